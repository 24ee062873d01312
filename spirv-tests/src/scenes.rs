//! The scenes whose modules are snapshots, and go through every backend and validator.

mod distributions;
mod functions;
mod images;
mod patterns;
mod transferred;

use prefilter::{
    Accuracy, ColorMap, Colors, Combination, Driver, HeightTier, Irradiance, IrradianceTier, JointMap, Kernel,
    Microsurface, Moments, Ranges, Reflectance, Scene, SlopeDomain, SlopeMap, SlopeMoments, SlopeTaps, SlopeTier, Taps,
    Tier,
};

use crate::environments::SKY;
use crate::maps::{named, random};

type Result<T> = std::result::Result<T, Box<dyn std::error::Error + Send + Sync>>;

/// Every scene by a name for its files.
///
/// # Errors
/// None that the tests have seen: the maps are fixed.
pub fn all() -> Result<Vec<(&'static str, Scene)>> {
    let seen = [slopes()?, slope_maps()?, steepnesses()?, irradiances()?, driven_slopes()?].concat();
    let functions = [functions::all()?, images::all()?, distributions::all()?, patterns::all()?].concat();
    let functions = [functions, transferred::all()?].concat();
    Ok([textures()?, heights()?, seen, combinations()?, functions].concat())
}

/// The scenes of values.
///
/// # Errors
/// As [`all`].
pub fn textures() -> Result<Vec<(&'static str, Scene)>> {
    Ok([constant_colors()?, dynamic_colors()?, images::driven()?, edges_and_limits()?].concat())
}

/// The scenes of several layers: without light, in an environment, and under one light with all channels.
///
/// # Errors
/// As [`all`].
pub fn combinations() -> Result<Vec<(&'static str, Scene)>> {
    let rock = ColorMap::gradient([(0.3, [0.2, 0.3, 0.1]), (0.9, [0.4, 0.35, 0.3])])?;
    let rock = Scene::new("rock").steepness(rock);
    let high = Scene::new("high").height(ColorMap::gradient([(0.6, [0.0; 3]), (0.8, [1.0; 3])])?);
    let grain = ColorMap::gradient([(0.1, [0.5; 3]), (0.9, [1.0, 0.95, 0.9])])?;
    let grain = Scene::new("grain").texture(grain);
    let sand =
        Scene::new("sand").slope(ColorMap::gradient([(-0.3, [0.7, 0.6, 0.4, 0.2]), (0.3, [0.9, 0.8, 0.6, 0.9])])?);
    let strata = Scene::new("strata").height_percentile(ColorMap::bands([0.2; 4], [(0.5, [0.9; 4])])?);
    let snow = Combination::color([0.9, 0.9, 0.95])?;
    let unshadowed = Microsurface { shadowing: false, ..Microsurface::default() };
    let hills = || Scene::new("hills").combination(&grain * &rock * (1.0 - &high) + snow.clone() * &high);
    Ok(vec![
        ("combination_default", hills()),
        ("combination_lit", hills().microsurface(unshadowed).irradiance(sky()?).colors(Colors::Dynamic)),
        (
            "combination_radiance",
            Scene::new("dune")
                .combination(&sand * (1.0 - Combination::weight("wetness")? * &strata))
                .reflectance(Reflectance::Lambert),
        ),
        ("combination_joint", Scene::new("peak").combination(snow_on_rock()?).microsurface(unshadowed)),
        ("combination_given", Scene::new("dune").combination(0.5 * &sand + 0.5).reflectance(Reflectance::Given)),
    ])
}

/// Snow where it is high and flat, on rock.
fn snow_on_rock() -> Result<Combination> {
    let snow = |height: f32, steepness: f32| {
        let part = ((height - 0.5) / 0.2).clamp(0.0, 1.0) * ((0.6 - steepness) / 0.3).clamp(0.0, 1.0);
        [0.3, 0.25, 0.2].map(|rock| rock + part * (0.95 - rock))
    };
    Ok(JointMap::new([0.0, 0.5, 0.7, 1.0], [0.0, 0.3, 0.6, 1.0], snow)?.combination("snow", 2)?)
}

/// A sky that is bright at its zenith and on one side, over dark ground.
fn sky() -> Result<Irradiance> {
    Ok(Irradiance::from_harmonics(SKY)?)
}

/// The scenes of irradiance.
///
/// # Errors
/// As [`all`].
pub fn irradiances() -> Result<Vec<(&'static str, Scene)>> {
    let sky = sky()?;
    let hill = || Scene::new("hill").irradiance(sky);
    Ok(vec![
        ("irradiance_default", hill()),
        ("irradiance_dynamic", hill().colors(Colors::Dynamic).irradiance_tier(IrradianceTier::FourGaussians)),
        ("irradiance_points", hill().irradiance_tier(IrradianceTier::Points)),
    ])
}

/// The scenes of heights.
///
/// # Errors
/// As [`all`].
pub fn heights() -> Result<Vec<(&'static str, Scene)>> {
    let terrain = || Ok::<_, Box<dyn std::error::Error + Send + Sync>>(Scene::new("terrain").height(named("terrain")?));
    let lichen = || {
        ColorMap::gradient([
            (0.00, [0.05, 0.09, 0.03]),
            (0.45, [0.21, 0.24, 0.10]),
            (0.45, [0.42, 0.40, 0.37]),
            (1.00, [0.71, 0.69, 0.66]),
        ])
    };
    let bands = || Ok::<_, Box<dyn std::error::Error + Send + Sync>>(Scene::new("strata").height(named("steps6")?));
    let four = ColorMap::gradient([(0.0, [0.1, 0.2, 0.3, 0.4]), (1.0, [0.9, 0.8, 0.7, 1.0])])?;
    let masked = Microsurface { shadowing: false, masking: true, ..Microsurface::default() };
    let hotspot = Microsurface { hotspot: true, ..Microsurface::default() };
    let tilted = Microsurface { mean_slope: true, ..Microsurface::default() };
    let perturbed = Microsurface { perturbed: true, ..Microsurface::default() };
    Ok(vec![
        ("height_default", Scene::new("lichen").height(lichen()?)),
        ("height_paper", Scene::new("lichen").height(lichen()?).height_tier(HeightTier::Paper)),
        ("height_gaussian", terrain()?.height_tier(HeightTier::Gaussian).tier(FAST)),
        ("height_closed_form_fast", terrain()?.height_tier(HeightTier::ClosedFormFast)),
        ("height_closed_form", terrain()?.height_tier(HeightTier::ClosedForm)),
        ("height_table", terrain()?.height_tier(HeightTier::Gaussian).tier(Tier::Table)),
        ("height_skewed", terrain()?.height_tier(HeightTier::Skewed)),
        ("height_skewed_dynamic", terrain()?.colors(Colors::Dynamic).height_tier(HeightTier::Skewed)),
        ("height_dynamic", terrain()?.colors(Colors::Dynamic).height_tier(HeightTier::ClosedForm)),
        ("height_bands", bands()?.height_tier(HeightTier::Exact)),
        ("height_bands_hotspot", bands()?.height_tier(HeightTier::Exact).microsurface(hotspot)),
        ("height_tilted", terrain()?.microsurface(tilted).height_tier(HeightTier::Gaussian).tier(FAST)),
        ("height_perturbed", terrain()?.microsurface(perturbed).height_tier(HeightTier::ClosedForm)),
        ("height_percentile", Scene::new("lichen").height_percentile(lichen()?)),
        ("height_percentile_dynamic", Scene::new("lichen").height_percentile(lichen()?).colors(Colors::Dynamic)),
        ("height_masked", Scene::new("moss").height(four).microsurface(masked).tier(FAST)),
    ])
}

/// The scenes of slopes.
///
/// # Errors
/// As [`all`].
pub fn slopes() -> Result<Vec<(&'static str, Scene)>> {
    let dune = ColorMap::gradient([
        (-0.6, [0.31, 0.22, 0.12]),
        (-0.1, [0.55, 0.42, 0.27]),
        (-0.1, [0.78, 0.63, 0.41]),
        (0.5, [0.93, 0.84, 0.68]),
    ])?;
    let dune = || Scene::new("dune").slope(dune.clone());
    Ok(vec![
        ("slope_default", dune()),
        ("slope_naive", dune().slope_tier(SlopeTier::Naive)),
        ("slope_unweighted", dune().slope_tier(SlopeTier::Unweighted)),
        ("slope_gaussian", dune().slope_tier(SlopeTier::Gaussian).tier(FAST)),
        ("slope_pair", dune().slope_tier(SlopeTier::Pair).tier(EXACT)),
        ("slope_table", dune().slope_tier(SlopeTier::Pair).tier(Tier::Table)),
        ("slope_dynamic", dune().colors(Colors::Dynamic).slope_tier(SlopeTier::Pair).tier(EXACT)),
    ])
}

/// The scenes of maps of the whole slope: snow that lies to one side, and a wheel of aspects with a fourth channel.
///
/// # Errors
/// As [`all`].
pub fn slope_maps() -> Result<Vec<(&'static str, Scene)>> {
    let snow = SlopeMap::from_function(48, SlopeDomain::Within(0.8), |[x, y]| {
        let covered = (2.0 * (0.3 - x) - 3.0 * x.hypot(y - 0.2)).clamp(0.0, 1.0);
        [0.31 + 0.6 * covered, 0.28 + 0.65 * covered, 0.25 + 0.72 * covered]
    })?;
    let wheel = SlopeMap::from_function(64, SlopeDomain::All, |[x, y]| {
        let steep = x.hypot(y);
        let part = 0.45 / steep.max(0.1);
        [0.5 + part * x, 0.5 + part * y, 0.5 - part * x, steep / (1.0 + steep)]
    })?;
    let (snow, wheel) =
        (|| Scene::new("snow").slope_map(snow.clone()), || Scene::new("aspect").slope_map(wheel.clone()));
    Ok(vec![
        ("slope_map_default", snow()),
        ("slope_map_unweighted", wheel().slope_tier(SlopeTier::Unweighted).slope_taps(SlopeTaps::One)),
        ("slope_map_gaussian", snow().slope_tier(SlopeTier::Gaussian).slope_taps(SlopeTaps::Three)),
        ("slope_map_eleven", snow().slope_tier(SlopeTier::Pair).slope_taps(SlopeTaps::Eleven)),
        ("slope_map_pair", wheel().slope_tier(SlopeTier::Pair).slope_taps(SlopeTaps::Three)),
    ])
}

/// The scenes of steepness.
///
/// # Errors
/// As [`all`].
pub fn steepnesses() -> Result<Vec<(&'static str, Scene)>> {
    let cliff = ColorMap::gradient([
        (0.25, [0.22, 0.31, 0.09]),
        (0.55, [0.35, 0.33, 0.22]),
        (0.7, [0.46, 0.41, 0.36]),
        (1.2, [0.31, 0.28, 0.26]),
    ])?;
    let cliff = || Scene::new("cliff").steepness(cliff.clone());
    Ok(vec![
        ("steepness_default", cliff()),
        ("steepness_dynamic", cliff().colors(Colors::Dynamic)),
        ("steepness_naive", cliff().slope_tier(SlopeTier::Naive)),
        ("steepness_three", cliff().slope_taps(SlopeTaps::Three)),
        ("steepness_pair", cliff().slope_tier(SlopeTier::Pair)),
    ])
}

/// The scenes of slopes from a map's pyramid.
///
/// # Errors
/// As [`all`].
pub fn driven_slopes() -> Result<Vec<(&'static str, Scene)>> {
    let sand = ColorMap::gradient([(-0.5, [0.31, 0.22, 0.12]), (0.1, [0.78, 0.63, 0.41]), (0.5, [0.93, 0.84, 0.68])])?;
    let dune = |tier| Scene::new("dune").slope(sand.clone()).slope_tier(tier).tier(FAST);
    let driven = |taps| Driver::SlopeMoments(SlopeMoments { taps, ..SlopeMoments::default() });
    let cliff = ColorMap::gradient([(0.4, [0.22, 0.31, 0.09]), (0.7, [0.46, 0.41, 0.36])])?;
    let sky = Irradiance::from_harmonics([[0.9, 1.1, 1.4]; 9])?;
    let hill = Scene::new("hill").irradiance(sky).colors(Colors::Dynamic);
    let snow = SlopeMap::from_function(16, SlopeDomain::Within(0.5), |[x, y]| [0.5 + x, 0.5 - y, 0.25])?;
    let snow = Scene::new("snow").slope_map(snow).slope_tier(SlopeTier::Gaussian).slope_taps(SlopeTaps::One);
    let sloped = Driver::Moments(Moments { taps: Taps::Two, slopes: true, ..Moments::default() });
    let tilted = Microsurface { mean_slope: true, ..Microsurface::default() };
    let heights = Scene::new("terrain").height(named("terrain")?).microsurface(tilted).tier(FAST);
    Ok(vec![
        ("height_driven_with_slopes", heights.height_tier(HeightTier::Gaussian).driver(sloped)),
        ("slope_driven", dune(SlopeTier::Gaussian).driver(driven(Taps::One))),
        ("slope_driven_by_eight_taps", dune(SlopeTier::Pair).driver(driven(Taps::Eight))),
        ("slope_driven_unweighted", dune(SlopeTier::Unweighted).driver(driven(Taps::Two))),
        ("steepness_driven", Scene::new("cliff").steepness(cliff).driver(driven(Taps::Four))),
        ("slope_map_driven", snow.driver(driven(Taps::Two))),
        ("irradiance_driven", hill.irradiance_tier(IrradianceTier::Points).driver(driven(Taps::Two))),
    ])
}

const EXACT: Tier = Tier::ClosedForm(Kernel::Exact);
const FAST: Tier = Tier::ClosedForm(Kernel::Fast);

fn constant_colors() -> Result<Vec<(&'static str, Scene)>> {
    let terrain =
        || Ok::<_, Box<dyn std::error::Error + Send + Sync>>(Scene::new("terrain").texture(named("terrain")?));
    let steps = || Ok::<_, Box<dyn std::error::Error + Send + Sync>>(Scene::new("strata").texture(named("steps6")?));
    Ok(vec![
        ("terrain_default", terrain()?),
        ("terrain_naive", terrain()?.tier(Tier::Naive)),
        ("terrain_paper", terrain()?.tier(Tier::Paper)),
        ("terrain_table", terrain()?.tier(Tier::Table)),
        ("terrain_fast", terrain()?.tier(FAST)),
        ("terrain_exact", terrain()?.tier(EXACT)),
        ("terrain_tight", terrain()?.accuracy(Accuracy::max_filter_error(3e-5).without_tables())),
        ("steps_naive", steps()?.tier(Tier::Naive)),
        ("steps_fast", steps()?.tier(FAST)),
        ("steps_exact", steps()?.tier(EXACT)),
        ("gist_earth_exact", Scene::new("earth").texture(named("gist_earth")?).tier(EXACT)),
    ])
}

fn dynamic_colors() -> Result<Vec<(&'static str, Scene)>> {
    let dynamic = |name: &str| {
        Ok::<_, Box<dyn std::error::Error + Send + Sync>>(
            Scene::new("material").texture(named(name)?).colors(Colors::Dynamic),
        )
    };
    let four = ColorMap::gradient([(0.0, [0.1, 0.2, 0.3, 0.4]), (1.0, [0.9, 0.8, 0.7, 1.0])])?;
    Ok(vec![
        ("dynamic_knots", dynamic("terrain")?.tier(EXACT)),
        ("dynamic_table", dynamic("terrain")?.tier(Tier::Table)),
        ("dynamic_paper", dynamic("terrain")?.tier(Tier::Paper)),
        ("four_channels", Scene::new("moss").texture(four.clone()).tier(FAST)),
        ("four_channels_dynamic", Scene::new("moss").texture(four.clone()).colors(Colors::Dynamic).tier(EXACT)),
        ("four_channels_table", Scene::new("moss").texture(four).tier(Tier::Table)),
    ])
}

fn edges_and_limits() -> Result<Vec<(&'static str, Scene)>> {
    let threshold = ColorMap::bands([0.02, 0.02, 0.02], [(0.5, [0.9, 0.85, 0.8])])?;
    let flat = ColorMap::gradient([(0.5, [0.2, 0.4, 0.6])])?;
    let meters = ColorMap::gradient([(-20.0, [0.0, 0.1, 0.4]), (0.0, [0.7, 0.7, 0.5]), (1800.0, [1.0, 1.0, 1.0])])?;
    let narrow = ColorMap::gradient([(0.3, [0.0, 0.0, 0.0]), (0.300_01, [1.0, 0.5, 0.2]), (0.8, [0.3, 0.5, 0.9])])?;
    Ok(vec![
        ("threshold", Scene::new("cutout").texture(threshold)),
        ("flat", Scene::new("plain").texture(flat)),
        ("meters", Scene::new("relief").texture(meters).ranges(Ranges { mean: (-50.0, 2000.0), deviation: 500.0 })),
        ("narrow_ramp", Scene::new("crease").texture(narrow).tier(EXACT)),
        ("hard_random", Scene::new("mixed").texture(random(8, true, 7)?).tier(EXACT)),
    ])
}
