//! Modules: what they hold and say, how they link, and what scenes and texts are refused.

use std::error::Error as StdError;

use prefilter::{link, Accuracy, Bound, ColorMap, Colors, Error, Kernel, Ranges, Scene, Stage, Tier};
use spirv_tests::maps::named;
use spirv_tests::scenes;

type Outcome = Result<(), Box<dyn StdError + Send + Sync>>;

fn gradient() -> Result<ColorMap, Error> {
    ColorMap::gradient([
        (0.00, [0.05, 0.09, 0.03]),
        (0.45, [0.21, 0.24, 0.10]),
        (0.45, [0.42, 0.40, 0.37]),
        (1.00, [0.71, 0.69, 0.66]),
    ])
}

/// The text without comments and empty lines.
fn code(text: &str) -> String {
    let lines = text.lines().map(|line| line.split("//").next().unwrap_or("").trim_end());
    lines.filter(|line| !line.is_empty()).map(|line| format!("{line}\n")).collect()
}

#[test]
fn a_gradient_of_four_stops_is_small_and_binds_nothing() -> Outcome {
    for stops in [gradient()?, ColorMap::gradient((0..4).map(|at| (at as f32 / 3.0, [0.1 * at as f32, 0.5, 0.9])))?] {
        for kernel in [Kernel::Fast, Kernel::Exact] {
            let module = Scene::new("lichen").texture(stops.clone()).tier(Tier::ClosedForm(kernel)).module()?;
            let bytes = code(module.wgsl()).len();
            println!("{kernel:?}: {bytes} bytes");
            assert!(bytes <= 1536, "{bytes}"); // 1.5 KB
            assert!(module.tables().is_empty() && !module.wgsl().contains("texture_2d"));
            assert_eq!(module.exports().len(), 1);
            assert_eq!(module.exports()[0].parameters(), [("mean", "f32"), ("deviation", "f32")]);
        }
    }
    Ok(())
}

#[test]
fn every_scene_gives_the_same_bytes_again_and_holds_nothing_unused() -> Outcome {
    for (name, scene) in scenes::all()? {
        let (module, again) = (scene.module()?, scene.module()?);
        assert_eq!((module.wgsl(), module.explain()), (again.wgsl(), again.explain()), "{name}");
        let declarations = prefilter_wgsl::declarations(module.wgsl());
        for declaration in &declarations {
            let export = module.exports().iter().any(|export| export.name == declaration.name);
            let others = declarations.iter().filter(|other| other.name != declaration.name);
            let mentioned = others.flat_map(|other| other.mentions()).any(|mention| mention == declaration.name);
            assert!(export || mentioned, "{name}: {} is not used", declaration.name);
        }
        for export in module.exports() {
            assert!(export.name.starts_with(module.name()) && !export.documentation.is_empty(), "{name}");
        }
    }
    Ok(())
}

#[test]
fn the_accuracy_chooses_the_lightest_tier_within_it() -> Outcome {
    let scene = |error: f32| Scene::new("judged").accuracy(Accuracy::max_filter_error(error));
    let terrain = scene(1e-2).texture(named("terrain")?).module()?;
    assert!(terrain.bound().value() <= 1e-2);
    let close = scene(1e-5).texture(named("terrain")?).module()?;
    assert!(matches!(close.bound(), Bound::Guaranteed(bound) if bound <= 1e-5));
    assert!(close.explain().contains("exact kernel"), "{}", close.explain());
    assert!(terrain.cost().weight() <= close.cost().weight());
    // 256 stops are too many to unroll where a table is close enough, and may not be where it is not allowed.
    let viridis = scene(4e-3).texture(named("viridis")?).module()?;
    assert!(viridis.explain().contains("cube-root table by") || viridis.tables().len() == 1, "{}", viridis.explain());
    let accuracy = Accuracy::max_filter_error(4e-3).without_tables();
    assert!(scene(1.0).texture(named("viridis")?).accuracy(accuracy).module()?.tables().is_empty());
    let refused = scene(1e-9).texture(named("terrain")?).module();
    let Err(Error::Accuracy { asked, bound, .. }) = refused else { return Err("1e-9 is beyond f32".into()) };
    assert!(asked == 1e-9 && bound > 1e-9);
    Ok(())
}

#[test]
fn the_ranges_are_those_of_the_map_unless_others_are_given() -> Outcome {
    let ranges = |low: f32, high: f32| {
        let map = ColorMap::gradient([(low, [0.1, 0.2, 0.3]), (high, [0.9, 0.8, 0.7])])?;
        let scene = Scene::new("ranged").texture(map).tier(Tier::Naive);
        scene.module()?; // accepts them
        Ok::<_, Error>(scene.chosen_ranges())
    };
    assert_eq!(ranges(0.0, 1.0)?, Ranges::default());
    assert_eq!(ranges(0.3, 0.301)?, Ranges::default());
    assert_eq!(ranges(200.0, 900.0)?, Ranges { mean: (-225.0, 1125.0), deviation: 450.0 });
    assert_eq!(ranges(-3.0, -2.0)?, Ranges { mean: (-4.0, 2.0), deviation: 2.0 });
    assert_eq!(ranges(-65504.0, 65504.0)?, Ranges { mean: (-65504.0, 65504.0), deviation: 65504.0 });
    Ok(())
}

#[test]
fn scenes_that_cannot_be_are_refused() -> Outcome {
    let scene = |name: &str| Ok::<_, Error>(Scene::new(name).texture(gradient()?));
    // Reserved in WGSL, GLSL, HLSL and MSL in turn; the rest are no identifiers or not allowed in all four.
    for name in ["fn", "discard", "varying", "uvec3", "cbuffer", "SamplerState", "kernel", "constexpr"] {
        assert!(matches!(scene(name)?.module(), Err(Error::Name { .. })), "{name}");
    }
    for name in [
        "",
        "1st",
        "a b",
        "größe",
        "a__b",
        "_a",
        "a_",
        "map2",
        "a-b",
        "a\nb",
        "gl",
        "gl_a",
        "webgl_a",
        &"a".repeat(1000),
    ] {
        assert!(matches!(scene(name)?.module(), Err(Error::Name { .. })), "{name}");
    }
    assert!(matches!(Scene::new("empty").module(), Err(Error::Conflict(_))));
    for error in [0.0, -1.0, f32::NAN, f32::INFINITY] {
        let refused = scene("judged")?.accuracy(Accuracy::max_filter_error(error)).module();
        let Err(refused @ Error::Value { .. }) = refused else { return Err(format!("{error} is accepted").into()) };
        assert!(refused.to_string().ends_with("allowed is a finite number above 0"), "{refused}");
    }
    for (mean, deviation) in [
        ((0.0, 0.0), 0.5),
        ((1.0, 0.0), 0.5),
        ((f32::NAN, 1.0), 0.5),
        ((0.0, f32::INFINITY), 0.5),
        ((0.0, 1.0), 0.0),
        ((0.0, 1.0), -0.5),
        ((0.0, 1.0), f32::NAN),
    ] {
        let refused = scene("ranged")?.ranges(Ranges { mean, deviation }).module();
        assert!(matches!(refused, Err(Error::Value { .. })), "{mean:?} {deviation}");
    }
    let narrow = scene("ranged")?.ranges(Ranges { deviation: 1e-4, ..Ranges::default() }).module();
    let message = narrow.map(|_| ()).unwrap_err().to_string();
    assert_eq!(message, "the largest deviation is 0.0001; allowed is 0.001 to 65504");
    let fast = scene("dynamic")?.colors(Colors::Dynamic).tier(Tier::ClosedForm(Kernel::Fast)).module();
    assert!(matches!(fast, Err(Error::Conflict(_))));
    Ok(())
}

#[test]
fn the_users_text_comes_first_and_keeps_its_lines() -> Outcome {
    let module = Scene::new("lichen").texture(gradient()?).module()?;
    let text = "@fragment\nfn main() -> @location(0) vec4f {\n    return vec4f(lichen_texture(0.5, 0.1), 1.0);\n}\n";
    let shader = module.link(text)?;
    assert!(shader.wgsl().starts_with(text));
    let refused = |text: &str| module.link(text).map(|_| ()).unwrap_err().to_string();
    let unknown = refused("fn a() -> f32 {\n    return normal_cfd(0.5);\n}\n");
    assert!(unknown.starts_with("shader.wgsl:2:12: "), "{unknown}");
    assert!(unknown.contains("did you mean `normal_cdf`?"), "{unknown}");
    let own = refused("fn a() -> vec3f { return lichen_textur(0.5, 0.1); }\n");
    assert!(own.contains("did you mean `lichen_texture`?"), "{own}");
    let mistyped = refused("fn a() -> u32 {\n    return lichen_texture(0.5, 0.1);\n}\n");
    assert!(mistyped.starts_with("shader.wgsl:"), "{mistyped}");
    let collision = refused("// mine\nfn normal_cdf(x: f32) -> f32 { return x; }\n");
    assert!(collision.contains("shader.wgsl:2:4: ") && collision.contains("math/normal.wgsl:"), "{collision}");
    let hidden = refused("// mine\nfn vec3f(x: f32) -> f32 { return x; }\n");
    assert!(hidden.contains("shader.wgsl:2:4: `vec3f` is declared here and hides"), "{hidden}");
    module.link("fn m() -> f32 { return 1.0; }\nfn c() {}\n")?; // names that the module declares for itself
    let attributed = refused("@compute @workgroup_size(1)\n");
    assert!(attributed.contains("lichen_texture"), "{attributed}");
    let again = refused("fn lichen_texture() {}\n");
    assert!(again.contains("shader.wgsl:1:4") && again.contains("lichen_texture"), "{again}");
    Ok(())
}

#[test]
fn several_modules_share_the_shelf() -> Outcome {
    let moss = Scene::new("moss").texture(gradient()?).module()?;
    let rock = Scene::new("rock").texture(named("terrain")?).module()?;
    let shader =
        link(&[&moss, &rock], "fn both(h: f32) -> vec3f { return moss_texture(h, 0.1) + rock_texture(h, 0.1); }")?;
    assert_eq!(shader.wgsl().matches("fn texture_kink_fast(").count(), 1);
    Ok(())
}

#[test]
fn probes_call_every_export() -> Outcome {
    for (name, scene) in scenes::all()? {
        let module = scene.module()?;
        for stage in [Stage::Fragment, Stage::Compute] {
            let probe = module.probe(stage);
            assert!(module.exports().iter().all(|export| probe.contains(&format!("{}(", export.name))), "{name}");
            module.link(&probe)?;
        }
    }
    Ok(())
}

#[test]
fn scenes_survive_serialization() -> Outcome {
    for (name, scene) in scenes::all()? {
        let text = serde_json::to_string(&scene)?;
        assert_eq!(serde_json::from_str::<Scene>(&text)?, scene, "{name}");
    }
    Ok(())
}
