//! What scenes of transferred heights export and refuse. No device.

use prefilter::{
    Accuracy, ColorMap, Combination, Cosines, Driver, HeightTier, HeightTransfer, Irradiance, Microsurface, Moments,
    Scene, SlopeTier, Taps, TransferTier, Wave,
};

use crate::Outcome;

fn moss() -> Result<Scene, prefilter::Error> {
    let map = ColorMap::gradient([(0.0, [0.05, 0.1, 0.02]), (1.0, [0.4, 0.5, 0.1])])?;
    Ok(Scene::new("moss").height(map).transfer(HeightTransfer::smoothstep(0.0, 1.2)?))
}

fn signatures(scene: &Scene) -> Result<Vec<String>, prefilter::Error> {
    Ok(scene.module()?.exports().iter().map(|export| export.signature.clone()).collect())
}

#[test]
fn exports_take_the_statistics_of_f() -> Outcome {
    let nodes = ", nodes: texture_2d<f32>, nodes_sampler: sampler";
    let table = ", table: texture_3d<f32>, table_sampler: sampler";
    let statistics = "mean: f32, deviation: f32, slope_covariance: vec3f, view: vec3f, light: vec3f";
    assert_eq!(
        signatures(&moss()?)?,
        [
            format!("fn moss_height({statistics}{table}{nodes}) -> vec3f"),
            format!("fn moss_visibility({statistics}{nodes}) -> f32"),
            "fn moss_transferred(mean: f32, deviation: f32) -> vec4f".to_owned(),
        ]
    );
    let map = ColorMap::gradient([(-0.4, [0.1; 3]), (0.4, [0.9; 3])])?;
    let dune = Scene::new("dune").slope(map).transfer(HeightTransfer::absolute()).transfer_tier(TransferTier::Paper);
    let slopes = "mean: f32, deviation: f32, mean_slope: vec2f, slope_covariance: vec3f, view: vec3f";
    assert_eq!(signatures(&dune)?[0], format!("fn dune_slope({slopes}, direction: vec2f{}) -> vec3f", ""));
    let sky = Irradiance::from_harmonics([[0.5; 3]; 9])?;
    let hill = Scene::new("hill").irradiance(sky).transfer(HeightTransfer::absolute());
    // Slopes in sight take all that is known of nodes, heights what hides them.
    let nodes = nodes.replace("2d", "3d");
    assert_eq!(signatures(&hill)?[1], format!("fn hill_lambert({slopes}, light: vec3f{nodes}) -> f32"));
    Ok(())
}

#[test]
fn a_driver_displaces_and_colors() -> Outcome {
    let wave = Wave { frequency: [1.0, 0.3], amplitude: 0.4, phase: 0.1 };
    let waves = |taps| Driver::Cosines(Cosines { waves: vec![wave; 2], taps, ..Cosines::default() });
    let names = |scene: Scene| -> Result<Vec<String>, prefilter::Error> {
        Ok(scene.module()?.exports().iter().map(|export| export.name.clone()).collect())
    };
    let own = ["moss_height", "moss_visibility", "moss_transferred"];
    let driven = ["moss_color", "moss_statistics", "moss_displacement"];
    assert_eq!(names(moss()?.driver(waves(Taps::One)))?, [own, driven].concat());
    // Taps of tilted surfaces count by their area in the picture.
    let tilted = Microsurface { mean_slope: true, ..Microsurface::default() };
    let several = moss()?.microsurface(tilted).driver(waves(Taps::Four));
    assert_eq!(names(several)?, [&own[..], &["moss_area"], &driven].concat());
    Ok(())
}

#[test]
fn what_has_no_meaning_is_refused() -> Outcome {
    let map = || ColorMap::gradient([(0.0, [0.1; 3]), (1.0, [0.9; 3])]);
    let curve = HeightTransfer::absolute;
    let grain = Scene::new("grain").height(map()?);
    for (scene, why) in [
        (Scene::new("fog").texture(map()?).transfer(curve()), "values are no heights"),
        (Scene::new("fog").height(map()?).transfer_tier(TransferTier::Paper), "no `transfer`"),
        (moss()?.driver(Driver::Moments(Moments::default())), "needs a function and its slopes"),
        (moss()?.height_tier(HeightTier::ClosedForm), "a tier of heights"),
        (
            moss()?.transfer_tier(TransferTier::TwoNodes).accuracy(Accuracy::default().without_tables()),
            "an accuracy without tables",
        ),
        (
            Scene::new("hills").combination(Combination::from(&grain.clone().transfer(curve()))),
            "a layer takes from its combination",
        ),
        (
            Scene::new("hills").combination(&grain).transfer(curve()).transfer_tier(TransferTier::TwoNodes),
            "combinations",
        ),
    ] {
        let refused = scene.module().err().map(|error| error.to_string()).unwrap_or_default();
        assert!(refused.contains(why), "{why}: {refused}");
    }
    Ok(())
}

/// Errors of Λ between the texels of nodes move colors: the bound falls as they do.
#[test]
fn bounds_of_heights_count_what_hides_them() -> Outcome {
    let tilted = Microsurface { mean_slope: true, ..Microsurface::default() };
    for surface in [Microsurface::default(), tilted] {
        let bound = |tier| -> Result<f32, prefilter::Error> {
            Ok(moss()?.microsurface(surface).transfer_tier(tier).module()?.bound().value())
        };
        let [two, three, four] = [TransferTier::TwoNodes, TransferTier::ThreeNodes, TransferTier::FourNodes].map(bound);
        let [two, three, four] = [two?, three?, four?];
        println!("{two:.2e}, {three:.2e}, {four:.2e}");
        assert!(two > 1.01 * three && three > 1.001 * four, "{two}, {three}, {four}");
    }
    Ok(())
}

/// A name is refused for what it is, not for what is put behind it.
#[test]
fn long_names_are_names() -> Outcome {
    let map = ColorMap::gradient([(0.0, [0.1; 3]), (1.0, [0.9; 3])])?;
    let named = |letters: usize| {
        let scene = Scene::new(&"a".repeat(letters)).slope(map.clone()).transfer(HeightTransfer::absolute());
        scene.transfer_tier(TransferTier::Paper).module()
    };
    for letters in [1, 93, 94, 100] {
        let module = named(letters)?;
        module.link(&module.probe(prefilter::Stage::Compute))?;
    }
    assert!(matches!(named(101), Err(prefilter::Error::Name { name, .. }) if name.len() == 101));
    Ok(())
}

#[test]
fn combinations_are_the_papers() -> Outcome {
    let map = ColorMap::gradient([(0.0, [0.1; 3]), (1.0, [0.9; 3])])?;
    let high = Scene::new("high").height(map.clone());
    let steep = Scene::new("steep").steepness(map);
    let hills = Scene::new("hills").combination(&high * &steep).transfer(HeightTransfer::smoothstep(0.0, 1.2)?);
    let statistics = "mean: f32, deviation: f32, mean_slope: vec2f, slope_covariance: vec3f, view: vec3f, light: vec3f";
    let signatures = signatures(&hills)?;
    assert!(signatures[0].starts_with(&format!("fn hills_combined({statistics}")), "{}", signatures[0]);
    assert!(hills.module()?.explain().contains(&TransferTier::Paper.to_string()));
    Ok(())
}

#[test]
fn the_accuracy_has_a_say() -> Outcome {
    let asked = |scene: Scene, error: f32| scene.accuracy(Accuracy::max_filter_error(error)).module();
    // No table of heights is that close.
    assert!(matches!(asked(moss()?, 1e-4), Err(prefilter::Error::Accuracy { .. })));
    let step = ColorMap::bands([0.0; 3], [(0.1, [1.0; 3])])?;
    let dune = || -> Result<Scene, prefilter::Error> {
        let dune = Scene::new("dune").slope(step.clone()).slope_tier(SlopeTier::Pair);
        Ok(dune.transfer(HeightTransfer::smoothstep(-1.0, 1.0)?))
    };
    for (error, tier) in
        [(0.5, TransferTier::TwoNodes), (0.12, TransferTier::ThreeNodes), (0.075, TransferTier::FourNodes)]
    {
        let module = asked(dune()?, error)?;
        assert!(
            module.bound().value() <= error && module.explain().contains(&tier.to_string()),
            "{}",
            module.explain()
        );
    }
    Ok(())
}

/// A hard edge at the height of a level stretch counts all of it as above, however wide the footprint.
#[test]
fn level_stretches_lie_above_an_edge_at_their_height() -> Outcome {
    let device = prefilter::gpu::Device::new()?;
    let ground = ColorMap::bands([0.1; 3], [(0.0, [0.9; 3])])?;
    let module = Scene::new("moss").height(ground).transfer(HeightTransfer::smoothstep(0.0, 1.2)?).module()?;
    let export = spirv_tests::exports::ExportKernel::new(&device, &module, &module.exports()[0])?;
    let [view, light] = [[0.0, 0.6, 0.8], [0.0, -0.6, 0.8]];
    for deviation in [0.0, 0.01, 0.05, 0.2] {
        let point = [&[-0.5, deviation, 0.09, 0.0, 0.09][..], &view, &light].concat();
        let [red, ..] = export.run(&point)?[0];
        assert!((red - 0.9).abs() < 2e-3, "{deviation}: {red}");
    }
    Ok(())
}
