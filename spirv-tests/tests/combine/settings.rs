//! Are names, numbers and settings that a combination has no use for refused, and those that it has kept apart?

use prefilter::{
    Accuracy, ColorMap, Colors, Combination, Driver, Error, Irradiance, JointMap, Microsurface, Reflectance, Scene,
    SlopeDomain, SlopeMap, SlopeMoments, SlopeTaps,
};

use crate::Outcome;

fn map() -> Result<ColorMap, Error> {
    ColorMap::gradient([(0.2, [0.2, 0.3, 0.1]), (0.7, [0.8, 0.4, 0.9])])
}

fn sky() -> Result<Irradiance, Error> {
    Irradiance::from_harmonics([[0.9, 1.1, 1.4]; 9])
}

fn refused(scene: &Scene, what: &str) {
    match scene.module() {
        Err(error @ (Error::Conflict(_) | Error::Value { .. } | Error::Size { .. })) => {
            assert!(error.to_string().contains(what), "{error}");
        }
        other => panic!("{what}: {other:?}"),
    }
}

/// A parameter of the same name would be one for both, or hide what the module calls.
#[test]
fn weights_have_names_of_their_own() -> Outcome {
    let (sand, high) = (Scene::new("sand").slope(map()?), Scene::new("high").height(map()?));
    let rock = Scene::new("rock").steepness(map()?);
    let lit = |weight: &str| {
        let combination = (&sand + &high) * Combination::weight(weight)? + &rock;
        let scene = Scene::new("hills").combination(combination).irradiance(sky()?).colors(Colors::Dynamic);
        Ok::<_, Error>(scene.reflectance(Reflectance::Given))
    };
    for taken in [
        // Statistics and what else is passed.
        "mean",
        "deviation",
        "view",
        "light",
        "direction",
        "x",
        "radiance",
        "reflectance",
        "rock_table",
        "environment",
        // What the functions name inside.
        "color",
        "joint",
        "seen",
        "moments",
        "square",
        "low",
        "node",
        "at",
        "c",
        "sand_color",
        // What they call, and what the linker would take for a call.
        "smith_lambda_fast",
        "hills_sand_slope",
        "combine_nodes",
        "texture_kink",
    ] {
        refused(&lit(taken)?, &format!("the weight `{taken}`"));
    }
    assert!(lit("wetness")?.module().is_ok());
    // What a module does not have is free.
    let free = Scene::new("hills").combination(&rock * Combination::weight("radiance")?);
    assert!(free.module()?.exports()[0].signature.contains("view: vec3f, radiance: f32, rock_table"));
    Ok(())
}

#[test]
fn layers_may_have_the_names_of_other_things() -> Outcome {
    for name in ["light", "color", "node", "mean", "noise", "texture", "slopes", "c"] {
        let layer = Scene::new(name).texture(map()?);
        let scene = Scene::new("hills").combination(&layer * Scene::new("sand").slope(map()?)).irradiance(sky()?);
        let module = scene.reflectance(Reflectance::Lambert).module().map_err(|error| format!("{name}: {error}"))?;
        assert!(module.exports()[0]
            .signature
            .contains(&format!("({name}_mean: f32, {name}_deviation: f32, mean_slope")));
    }
    Ok(())
}

/// A file may name a channel that its map has not.
#[test]
fn channels_from_files_are_those_of_their_maps() -> Outcome {
    let mask = Scene::new("mask").height(map()?);
    let scene = Scene::new("hills").combination(Combination::channel(&mask, 2)? * Combination::color([0.1, 0.2, 0.3])?);
    let text = serde_json::to_string(&scene)?;
    assert_eq!(serde_json::from_str::<Scene>(&text)?, scene);
    assert!(text.contains("},2]"), "{text}");
    refused(&serde_json::from_str(&text.replace("},2]", "},3]"))?, "the channel of `mask`");
    Ok(())
}

/// An expression may be used more than once.
#[test]
fn expressions_are_operands_by_reference() -> Outcome {
    let (half, layer) = (Combination::from(0.5), Scene::new("sand").slope(map()?));
    let (owned, lent) = (half.clone() * &layer + 0.5 * half.clone(), &half * &layer + 0.5 * &half);
    assert_eq!(owned, lent);
    assert!(Scene::new("hills").combination(&lent).module().is_ok());
    Ok(())
}

#[test]
fn numbers_are_those_of_colors() -> Outcome {
    for number in [f32::NAN, f32::INFINITY, -65505.0] {
        refused(&Scene::new("hills").combination(number * Scene::new("sand").slope(map()?)), "-65504 to 65504");
    }
    let far = JointMap::new([0.0, 65505.0], [0.0, 1.0], |_, _| [0.5; 3]).map(|_| ()).expect_err("far");
    assert!(far.to_string().contains("heights"), "{far}");
    Ok(())
}

#[test]
fn no_setting_is_ignored() -> Outcome {
    let (grain, sand) = (Scene::new("grain").texture(map()?), Scene::new("sand").slope(map()?));
    let driver = Driver::SlopeMoments(SlopeMoments::default());
    let masking = Microsurface { masking: true, ..Microsurface::default() };
    let noisy = Microsurface { perturbed: true, ..Microsurface::default() };
    let hills = || Scene::new("hills").combination(&sand);
    let wheel = SlopeMap::from_function(8, SlopeDomain::Within(1.0), |[x, y]| [0.5 + 0.1 * x, 0.5 + 0.1 * y, 0.5])?;
    refused(&hills().colors(Colors::Dynamic), "dynamic colors");
    refused(&hills().slope_taps(SlopeTaps::Three), "three reads");
    refused(&hills().slope_map(wheel), "a map of slopes of its own");
    refused(&hills().driver(driver.clone()), "pass its statistics to the combination");
    refused(&hills().microsurface(noisy), "noise");
    refused(&Scene::new("hills").combination(&grain).microsurface(masking), "a `microsurface`");
    refused(&Scene::new("hills").combination(sand.clone().driver(driver)), "pass its statistics");
    refused(&Scene::new("hills").combination(sand.clone().microsurface(masking)), "a microsurface");
    refused(&Scene::new("hills").combination(sand.clone().combination(&grain)), "and a combination");
    Ok(())
}

/// The noise on the heights is in both factors.
#[test]
fn noise_that_is_a_layer_is_no_factor_of_heights() -> Outcome {
    let (noise, high) = (Scene::new("noise").texture(map()?), Scene::new("high").height(map()?));
    let noisy = Microsurface { perturbed: true, ..Microsurface::default() };
    let scene = |combination: Combination| Scene::new("hills").combination(combination);
    refused(&scene(&noise * &high).microsurface(noisy), "depend on the value `noise`");
    let sum = scene(&noise + &high).microsurface(noisy).module()?;
    assert_eq!(sum.exports()[0].signature.matches("noise_mean").count(), 1);
    assert!(scene(&noise * &high).module().is_ok());
    Ok(())
}

/// Colors beyond 1 enlarge the errors of what they are factors of.
#[test]
fn an_accuracy_is_kept_whatever_the_colors() -> Outcome {
    let bright = ColorMap::gradient([(0.2, [20.0, 30.0, 10.0]), (0.7, [80.0, 40.0, 90.0])])?;
    let [first, second] = ["first", "second"].map(|name| Scene::new(name).texture(bright.clone()));
    let sand = Scene::new("sand").slope(map()?);
    let asked = |combination: Combination, error| {
        Scene::new("hills").combination(combination).accuracy(Accuracy::max_filter_error(error)).module()
    };
    let closest = asked(&first * &second, 0.1)?;
    println!("two bright factors: {}", closest.bound());
    assert!(closest.bound().value() <= 0.1);
    assert!(matches!(asked(&first * &second, 1e-3), Err(Error::Accuracy { .. })));
    let mixed = &first * (&sand + 0.01 * &second);
    for error in [3.0, 5.0, 10.0] {
        let module = asked(mixed.clone(), error)?;
        println!("asked for {error}: {}", module.bound());
        assert!(module.bound().value() <= error, "{}", module.explain());
    }
    assert!(matches!(asked(mixed, 0.1), Err(Error::Accuracy { .. })));
    // One layer needs more than half of it, and the other next to nothing.
    let module = asked(Scene::new("grain").texture(map()?) + &sand, 0.011)?;
    assert!(module.bound().value() <= 0.011, "{}", module.explain());
    // A layer of its own accuracy leaves the whole to the others.
    let own = sand.clone().accuracy(Accuracy::max_filter_error(0.05));
    let grain = Scene::new("grain").texture(map()?);
    let module = asked(&own + &grain, 1e-5)?;
    assert!(module.bound().value() < 0.05 + 1e-5, "{}", module.explain());
    Ok(())
}

/// Values are neither seen nor lit, slopes only seen.
#[test]
fn documentation_speaks_of_what_a_module_has() -> Outcome {
    let (grain, sand, high) =
        (Scene::new("grain").texture(map()?), Scene::new("sand").slope(map()?), Scene::new("high").height(map()?));
    let said = |combination: Combination| {
        let module = Scene::new("hills").combination(combination).reflectance(Reflectance::Given).module()?;
        let of =
            |name: &str| module.exports().iter().find(|export| export.name == name).map(|e| e.documentation.clone());
        Ok::<_, Error>([of("hills_combined").unwrap_or_default(), of("hills_radiance").unwrap_or_default()])
    };
    let [values, slopes, heights] = [said(grain.into())?, said(sand.into())?, said(high.into())?];
    assert!(["seen", "lit", "heights", "Slopes"].iter().all(|word| !values[0].contains(word)), "{}", values[0]);
    assert!(slopes[0].contains("seen.") && !slopes[0].contains("seen and lit."), "{}", slopes[0]);
    assert!(heights[0].contains("seen and lit.") && heights[0].contains("`deviation`"), "{}", heights[0]);
    assert_eq!([&values, &slopes].map(|said| said[1].contains("visibility")), [false, true]);
    Ok(())
}

/// A bound holds for what it says, that of each layer.
#[test]
fn explanations_say_what_the_bounds_of_layers_hold_for() -> Outcome {
    let (grain, high) = (Scene::new("grain").texture(map()?), Scene::new("high").height(map()?));
    let steep = Scene::new("rock").steepness(map()?);
    let tilted = Microsurface { mean_slope: true, ..Microsurface::default() };
    let scene = Scene::new("hills").combination(&grain * &high + &steep).microsurface(tilted);
    let text = scene.module()?.explain().to_owned();
    for alone in [grain.module()?, high.microsurface(tilted).module()?, steep.module()?] {
        let said = alone.explain().lines().filter(|line| line.starts_with("  covers") || line.starts_with("  ranges"));
        for line in said {
            assert!(text.contains(line), "{line} is not in\n{text}");
        }
    }
    assert_eq!(["covers", "ranges"].map(|word| text.matches(word).count()), [2, 3]);
    Ok(())
}
