//! What scenes may have or be without: each with a scene that has it, the same switched off, and one that never had it.

use super::scenes::{heights, hills, ramp, sky, values_of, BARE};
use prefilter::{
    ColorMap, Colors, Combination, Distribution, Driver, HeightTransfer, Microsurface, Moments, Noise, NoiseFold,
    NoiseMethod, Pattern, Pixel, Reflectance, Scene, SlopeTaps, SlopeTier, Taps, Tier, Warp,
};

/// Something that a scene may have.
pub struct Feature {
    /// What it is.
    pub name: &'static str,
    /// A scene that has it.
    pub on: Scene,
    /// That scene, with the feature switched off again; none where nothing switches it off.
    pub off: Option<Scene>,
    /// A scene that was never told of it.
    pub never: Scene,
    /// Names that nothing but this feature puts into the text.
    pub words: &'static [&'static str],
}

/// All features.
///
/// # Errors
/// None that has been seen: the scenes are fixed.
pub fn all() -> Result<Vec<Feature>, prefilter::Error> {
    Ok([surfaces()?, colors()?, images()?, noises()?, layers()?].into_iter().flatten().collect())
}

/// Of a surface that hides parts of itself.
fn surfaces() -> Result<Vec<Feature>, prefilter::Error> {
    let of = |name, on, words| -> Result<Feature, prefilter::Error> {
        let on = heights()?.microsurface(on);
        Ok(Feature { name, off: Some(on.clone().microsurface(BARE)), on, never: heights()?.microsurface(BARE), words })
    };
    let lit = Microsurface { shadowing: true, ..BARE };
    let hotspot = heights()?.microsurface(Microsurface { hotspot: true, ..lit });
    let curve = HeightTransfer::smoothstep(0.0, 1.2)?;
    let slope = Scene::new("dune").slope(ramp()?).slope_tier(SlopeTier::Pair).tier(EXACT);
    Ok(vec![
        of("shadowing", lit, &["light", "lit", "moss_visibility"])?,
        Feature {
            name: "hotspot",
            off: Some(hotspot.clone().microsurface(lit)),
            on: hotspot,
            never: heights()?.microsurface(lit),
            words: &["visibility_correlated", "visibility_independence"],
        },
        of("masking", Microsurface { masking: true, ..BARE }, &["moss_masking"])?,
        of("mean slope", Microsurface { mean_slope: true, ..BARE }, &["mean_slope"])?,
        of("perturbed heights", Microsurface { perturbed: true, ..BARE }, &["noise_mean", "noise_deviation"])?,
        Feature {
            name: "two distributions of slopes",
            on: slope.clone(),
            off: Some(slope.clone().slope_tier(SlopeTier::Gaussian)),
            never: Scene::new("dune").slope(ramp()?).slope_tier(SlopeTier::Gaussian).tier(EXACT),
            words: &["slopes_pair"],
        },
        Feature {
            name: "height transfer",
            on: slope.clone().transfer(curve),
            off: None,
            never: slope,
            words: &["slope_nodes_lambda", "nodes", "nodes_sampler", "dune_transferred"],
        },
    ])
}

const EXACT: Tier = Tier::ClosedForm(prefilter::Kernel::Exact);

/// Of a map and where its colors are.
fn colors() -> Result<Vec<Feature>, prefilter::Error> {
    let values = values_of()?;
    let (dynamic, table) = (values.clone().colors(Colors::Dynamic), values.clone().tier(Tier::Table));
    let smooth = ColorMap::gradient([(0.0, [0.1, 0.2, 0.3]), (1.0, [0.9, 0.7, 0.5])])?;
    let smooth = Scene::new("lichen").texture(smooth).tier(EXACT);
    let four = ColorMap::gradient([(0.0, [0.1, 0.2, 0.3, 0.5]), (1.0, [0.9, 0.7, 0.5, 1.0])])?;
    let bounded = Distribution::Beta { low: 0.0, high: 1.0 };
    let free = || Ok::<_, prefilter::Error>(Scene::new("lichen").texture(ramp()?));
    Ok(vec![
        Feature {
            name: "dynamic colors",
            off: Some(dynamic.clone().colors(Colors::Constant)),
            on: dynamic,
            never: values.clone(),
            words: &["texture_knots", "knots"],
        },
        Feature {
            name: "tables",
            off: Some(table.clone().tier(EXACT)),
            on: table,
            never: values.clone(),
            words: &["texture_table", "table", "table_sampler"],
        },
        Feature {
            name: "hard edges",
            on: values.clone(),
            off: Some(values.texture(smooth.map().cloned().map_or_else(ramp, Ok)?)),
            never: smooth.clone(),
            words: &["texture_step"],
        },
        Feature {
            name: "fourth channel",
            on: smooth.clone().texture(four.clone()),
            off: Some(smooth.clone().texture(four).texture(smooth.map().cloned().map_or_else(ramp, Ok)?)),
            never: smooth,
            words: &["vec4f"],
        },
        Feature {
            name: "distribution between two ends",
            on: free()?.distribution(bounded.clone()),
            off: Some(free()?.distribution(bounded).distribution(Distribution::Normal)),
            never: free()?,
            words: &["texture_bounded_table"],
        },
    ])
}

/// Of images.
fn images() -> Result<Vec<Feature>, prefilter::Error> {
    let driven = |scene: Scene, image| scene.driver(Driver::Moments(image));
    let (one, bare) = (Moments::default(), heights()?.microsurface(BARE));
    let pair = Distribution::Pair;
    let of = |name, on: Moments, words| -> Result<Feature, prefilter::Error> {
        let on = driven(values_of()?, on);
        Ok(Feature { name, off: Some(driven(on.clone(), one)), on, never: driven(values_of()?, one), words })
    };
    Ok(vec![
        Feature {
            name: "driver",
            on: driven(values_of()?, one),
            off: None,
            never: values_of()?,
            words: &["lichen_color", "moments", "dpdx"],
        },
        of("taps", Moments { taps: Taps::Two, ..one }, &["taps_covariance"])?,
        of("oblong pixels", Moments { pixel: Pixel::Covariance([0.25, 0.05, 0.1]), ..one }, &["footprint_covariance"])?,
        Feature {
            name: "slopes of an image",
            on: driven(bare.clone(), Moments { slopes: true, ..one }),
            off: Some(driven(driven(bare.clone(), Moments { slopes: true, ..one }), one)),
            never: driven(bare, one),
            words: &["slopes", "slopes_sampler"],
        },
        Feature {
            name: "two heaps of values",
            on: driven(values_of()?, one).distribution(pair.clone()),
            off: Some(driven(values_of()?, one).distribution(pair).distribution(Distribution::Normal)),
            never: driven(values_of()?, one),
            words: &["mixture_pair", "lichen_pair"],
        },
    ])
}

/// Of noise.
fn noises() -> Result<Vec<Feature>, prefilter::Error> {
    let plain = Noise::default();
    let driven = |scene: Scene, noise| scene.driver(Driver::Noise(noise));
    let of = |name, on: Noise, words| -> Result<Feature, prefilter::Error> {
        let on = driven(values_of()?, on);
        Ok(Feature { name, off: Some(driven(on.clone(), plain)), on, never: driven(values_of()?, plain), words })
    };
    let checker = Driver::Pattern(Pattern::default());
    let warped = values_of()?.driver(Driver::Warp(Warp::of(checker.clone())));
    Ok(vec![
        of("folds", Noise { fold: NoiseFold::Ridged, ..plain }, &["fold_octave"])?,
        of("curvature", Noise { method: NoiseMethod::Curvature, ..plain }, &["bend_statistics"])?,
        Feature {
            name: "displaced positions",
            off: Some(warped.clone().driver(checker.clone())),
            on: warped,
            never: values_of()?.driver(checker),
            words: &["warp_position"],
        },
    ])
}

/// Of combinations.
fn layers() -> Result<Vec<Feature>, prefilter::Error> {
    let lit = hills()?.irradiance(sky()?);
    let weighted = Combination::weight("wetness")? * &values_of()?;
    let snow =
        prefilter::SlopeMap::from_function(16, prefilter::SlopeDomain::Within(0.5), |[x, y]| [0.5 + x, 0.5 - y, 0.25])?;
    let snow = Scene::new("snow").slope_map(snow).slope_tier(SlopeTier::Gaussian);
    Ok(vec![
        Feature { name: "irradiance", on: lit, off: None, never: hills()?, words: &["hills_lit"] },
        Feature {
            name: "reflectance",
            on: hills()?.reflectance(Reflectance::Lambert),
            off: None,
            never: hills()?,
            words: &["hills_radiance", "radiance", "light"],
        },
        Feature {
            name: "weights",
            on: Scene::new("hills").combination(weighted),
            off: None,
            never: Scene::new("hills").combination(&values_of()?),
            words: &["wetness"],
        },
        Feature {
            name: "reads along an axis",
            on: snow.clone().slope_taps(SlopeTaps::Three),
            off: Some(snow.clone().slope_taps(SlopeTaps::Three).slope_taps(SlopeTaps::One)),
            never: snow.slope_taps(SlopeTaps::One),
            words: &["slope_map_three"],
        },
    ])
}
