//! Scenes of heights: what they export, choose, leave out and refuse. No device.

use prefilter::{
    Accuracy, Bound, ColorMap, Colors, Driver, Error, HeightTier, Irradiance, IrradianceTier, Kernel, Microsurface,
    Moments, Ranges, Scene, SlopeTier, Tier,
};
use spirv_tests::maps::named;

use crate::{Outcome, FAST};

fn signatures(scene: &Scene) -> Result<Vec<String>, Error> {
    Ok(scene.module()?.exports().iter().map(|export| export.signature.clone()).collect())
}

#[test]
fn what_is_off_leaves_no_trace() -> Outcome {
    let scene = Scene::new("moss").height(named("terrain")?).tier(FAST).height_tier(HeightTier::Gaussian);
    let surface = Microsurface::default();
    let height = "fn moss_height(mean: f32, deviation: f32, slope_covariance: vec3f, view: vec3f";
    let lit = "fn moss_visibility(slope_covariance: vec3f, view: vec3f, light: vec3f) -> f32";
    assert_eq!(signatures(&scene)?, [&format!("{height}, light: vec3f) -> vec3f"), lit]);
    let text = scene.module()?.wgsl().to_owned();
    assert!(!text.contains("visibility_masking") && !text.contains("visibility_independence"));
    let dark = scene.clone().microsurface(Microsurface { shadowing: false, ..surface });
    assert_eq!(signatures(&dark)?, [format!("{height}) -> vec3f")]);
    let text = dark.module()?.wgsl().to_owned();
    assert!(!text.contains("light") && !text.contains("fn visibility_"), "{text}");
    let masked = scene.clone().microsurface(Microsurface { shadowing: false, masking: true, ..surface });
    assert_eq!(signatures(&masked)?[1], "fn moss_masking(slope_covariance: vec3f, view: vec3f) -> f32");
    let tilted = scene.clone().microsurface(Microsurface { masking: true, mean_slope: true, ..surface });
    let slopes = "mean_slope: vec2f, slope_covariance: vec3f, view: vec3f";
    assert_eq!(
        signatures(&tilted)?,
        [
            format!("fn moss_height(mean: f32, deviation: f32, {slopes}, light: vec3f) -> vec3f"),
            format!("fn moss_visibility({slopes}, light: vec3f) -> f32"),
            format!("fn moss_masking({slopes}) -> f32"),
        ]
    );
    assert!(!scene.module()?.wgsl().contains("mean_slope") && !tilted.module()?.wgsl().contains("smith_parameter_"));
    assert!(tilted
        .module()?
        .explain()
        .contains("mean slopes to 1 with directions that win 0.01 over the mean surface"));
    let hot = scene.microsurface(Microsurface { hotspot: true, ..surface }).module()?;
    assert_eq!(hot.wgsl().matches("visibility_independence(view, light)").count(), 2);
    Ok(())
}

#[test]
fn the_accuracy_chooses_among_tiers_of_heights() -> Outcome {
    let rock = |error: f32| Scene::new("rock").accuracy(Accuracy::max_filter_error(error).without_tables());
    // Two terms over a normal distribution are cheaper than two over shorter tails, more are not.
    let ramp = ColorMap::gradient([(0.2, [0.1, 0.3, 0.4]), (0.8, [0.9, 0.6, 0.2])])?;
    for (map, error, tier) in [
        (ramp.clone(), 0.5, "one normal distribution over the closed form with the fast kernel"),
        (ramp.clone(), 1e-2, "skewed heights in closed form with the fast kernel"),
        (ramp, 1e-3, "skewed heights in closed form"),
        (named("terrain")?, 0.5, "skewed heights in closed form with the fast kernel"),
        (named("terrain")?, 2e-3, "skewed heights in closed form"),
    ] {
        let module = rock(error).height(map).module()?;
        assert!(module.bound().value() <= error && module.tables().is_empty());
        assert!(module.explain().starts_with(&format!("rock: height (Ch) by {tier}\n")), "{}", module.explain());
    }
    let bands = rock(1e-4).height(named("steps6")?).module()?;
    assert!(matches!(bands.bound(), Bound::Guaranteed(bound) if bound <= 1e-4), "{}", bands.explain());
    let refused = rock(1e-4).height(named("terrain")?).module();
    assert!(matches!(refused, Err(Error::Accuracy { .. })));
    // Whoever asks for none takes what there is.
    let zigzag = ColorMap::gradient((0..13).map(|at| (at as f32 / 12.0, [[0.0; 3], [1.0; 3]][at % 2])))?;
    let default = Scene::new("rock").height(zigzag).module()?;
    assert!(default.explain().contains("the lightest near the closest; none is within 3.9e-3"));
    // A tier of heights that is named leaves the color map's to the accuracy.
    let named_tier = rock(1e-4).height(named("terrain")?).height_tier(HeightTier::Gaussian).module()?;
    assert!(named_tier.explain().contains("over the closed form with the exact kernel"), "{}", named_tier.explain());
    Ok(())
}

#[test]
fn a_bound_is_the_step_error_times_the_variation() -> Outcome {
    let gray = |top: f32| ColorMap::gradient([(0.0, [0.2; 3]), (0.4, [top; 3]), (1.0, [0.2; 3])]);
    let bound = |top: f32| {
        let scene = Scene::new("rock").height(gray(top)?).height_tier(HeightTier::ClosedForm);
        Ok::<_, Error>(scene.module()?.bound().value())
    };
    for (top, variation) in [(0.7, 1.0), (0.3, 0.2)] {
        let found = bound(top)?;
        assert!((found / variation - 5.02e-4).abs() < 4e-6, "{found}");
    }
    let module = Scene::new("rock").height(gray(0.7)?).module()?;
    assert!(module.explain().contains("times the total variation 1.000"), "{}", module.explain());
    // No color leaves the hull, whatever the steps.
    let map = ColorMap::bands([0.0; 3], (0..9).map(|at| (0.1 * at as f32, [[1.0; 3], [0.0; 3]][at % 2])))?;
    let paper = Scene::new("rock").height(map).height_tier(HeightTier::Paper).tier(FAST).module()?;
    assert_eq!(paper.bound(), Bound::Guaranteed(1.0));
    Ok(())
}

/// Materials that differ only in their maps share a text.
#[test]
fn dynamic_colors_share_a_text() -> Outcome {
    let module = |name: &str| {
        let scene = Scene::new("rock").height(named(name)?).colors(Colors::Dynamic);
        Ok::<_, crate::Fault>(scene.height_tier(HeightTier::ClosedForm).module()?)
    };
    let (one, other) = (module("terrain")?, module("steps6")?);
    assert_eq!(one.wgsl(), other.wgsl());
    assert_ne!(one.tables(), other.tables());
    assert!(one.exports()[0].signature.ends_with("light: vec3f, knots: texture_2d<f32>) -> vec3f"));
    Ok(())
}

#[test]
fn scenes_that_cannot_be_are_refused() -> Outcome {
    let scene = |name: &str| Ok::<_, crate::Fault>(Scene::new("rock").height(named(name)?));
    let conflict = |scene: Scene| match scene.module() {
        Err(Error::Conflict(message)) => message,
        other => format!("no conflict: {:?}", other.map(|module| module.explain().to_owned())),
    };
    let graded = conflict(scene("terrain")?.height_tier(HeightTier::Exact));
    assert!(graded.contains("not this map, which has gradients"), "{graded}");
    let dynamic = conflict(scene("steps6")?.height_tier(HeightTier::Exact).colors(Colors::Dynamic));
    assert!(dynamic.contains("not dynamic colors"), "{dynamic}");
    let over = conflict(scene("steps6")?.height_tier(HeightTier::Exact).tier(Tier::ClosedForm(Kernel::Fast)));
    assert!(over.contains("leave out the tier"), "{over}");
    let both = conflict(scene("steps6")?.texture(named("terrain")?));
    assert!(both.contains("more than one filter, a `texture` and a `height`; make"), "{both}");
    let fast = scene("terrain")?.colors(Colors::Dynamic).tier(FAST).height_tier(HeightTier::Gaussian);
    assert!(conflict(fast).contains("needs constant colors"));
    Ok(())
}

/// What a scene would ignore it refuses, rather than seem to heed it.
#[test]
fn settings_of_other_filters_are_refused() -> Outcome {
    let map = named("terrain")?;
    let driver = Driver::Moments(Moments::default());
    let surface = Microsurface { masking: true, ..Microsurface::default() };
    let [texture, height, share, slope, light] = [
        Scene::new("rock").texture(map.clone()),
        Scene::new("rock").height(map.clone()),
        Scene::new("rock").height_percentile(map.clone()),
        Scene::new("rock").slope(map),
        Scene::new("rock").irradiance(Irradiance::from_harmonics([[0.5; 3]; 9])?),
    ];
    let normals = IrradianceTier::Points;
    for (scene, refusal) in [
        (
            texture.clone().height_tier(HeightTier::Paper),
            "a `texture` goes without a tier of heights, the paper's fits",
        ),
        (texture.clone().slope_tier(SlopeTier::Pair), "a `texture` goes without a tier of slopes"),
        (texture.clone().irradiance_tier(normals), "a `texture` goes without a tier of irradiance"),
        (texture.microsurface(surface), "a `texture` goes without a `microsurface`"),
        (height.clone().slope_tier(SlopeTier::Pair), "a `height` goes without a tier of slopes"),
        (height.irradiance_tier(normals), "a `height` goes without a tier of irradiance, five slopes"),
        (share.clone().ranges(Ranges::default()), "a `height_percentile` goes without `ranges`"),
        (share.slope_tier(SlopeTier::Pair), "a `height_percentile` goes without a tier of slopes"),
        (slope.irradiance_tier(normals), "a `slope` goes without a tier of irradiance"),
        (light.clone().tier(FAST), "`irradiance` goes without a color map's tier"),
        (light.clone().ranges(Ranges::default()), "its `ranges` are wider"),
        (light.driver(driver), "`irradiance` goes without a driver"),
    ] {
        let message = scene.module().map(|module| module.explain().to_owned()).unwrap_err().to_string();
        assert!(message.contains(refusal), "{message}");
    }
    let nothing = Scene::new("rock").module().map(|module| module.explain().to_owned()).unwrap_err().to_string();
    assert!(nothing.contains("the scene `rock` filters nothing; give it a `texture`, a `height`"), "{nothing}");
    Ok(())
}

/// Scenes stored before there were heights still load.
#[test]
fn older_files_load() -> Outcome {
    let scene = Scene::new("rock").texture(named("terrain")?).accuracy(Accuracy::max_filter_error(1e-3));
    let mut file = serde_json::to_value(&scene)?;
    let fields = file.as_object_mut().ok_or("an object")?;
    for new in ["height", "percentile", "microsurface", "height_tier"] {
        assert!(fields.remove(new).is_some(), "{new}");
    }
    assert_eq!(serde_json::from_value::<Scene>(file)?, scene);
    // So do surfaces of fewer switches.
    let surface = serde_json::from_str::<Microsurface>(r#"{"shadowing":false,"hotspot":true,"masking":true}"#)?;
    let known = Microsurface { shadowing: false, hotspot: true, masking: true, ..Microsurface::default() };
    assert_eq!(surface, known);
    Ok(())
}

/// Over ranges that lie far from the map, all colors are those of its end: the axis of their table has no length.
#[test]
fn ranges_far_from_the_map_make_a_module() -> Outcome {
    for mean in [(40000.0, 40001.0), (65000.0, 65000.01), (-65001.0, -65000.0)] {
        for map in [named("terrain")?, named("steps6")?] {
            let far = Scene::new("far").height(map).ranges(Ranges { mean, deviation: 1e-3 });
            far.clone().module()?;
            let read = far.height_tier(HeightTier::Skewed).module()?;
            assert_eq!(read.tables().len(), 1);
        }
    }
    Ok(())
}
