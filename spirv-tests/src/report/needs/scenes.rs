//! Twenty scenes, from the paper's three cases on: one more thing at a time.

use prefilter::{
    ColorMap, Colors, Combination, Driver, HeightTier, HeightTransfer, Irradiance, Microsurface, Moments, Noise,
    Reflectance, Scene, SlopeDomain, SlopeMap, SlopeTier, Taps, Tier,
};

/// The scenes by what they have.
///
/// # Errors
/// None that has been seen: the maps are fixed.
pub fn all() -> Result<Vec<(&'static str, Scene)>, prefilter::Error> {
    Ok([cases()?, surfaces()?, values()?, others()?].concat())
}

/// Color by value, by height seen and lit, and by slope.
///
/// # Errors
/// As [`all`].
pub fn cases() -> Result<Vec<(&'static str, Scene)>, prefilter::Error> {
    let dune = ColorMap::gradient([(-0.6, [0.31, 0.22, 0.12]), (-0.1, [0.78, 0.63, 0.41]), (0.5, [0.93, 0.84, 0.68])])?;
    let slope = Scene::new("dune").slope(dune).slope_tier(SlopeTier::Gaussian).tier(EXACT);
    let masked = Microsurface { masking: true, ..Microsurface::default() };
    Ok(vec![
        ("C0: texture", values_of()?),
        ("Ch: height, masking and shadowing", heights()?.microsurface(masked)),
        ("Cs: slope", slope),
    ])
}

const EXACT: Tier = Tier::ClosedForm(prefilter::Kernel::Exact);

/// Four colors with a hard edge.
pub(super) fn ramp() -> Result<ColorMap, prefilter::Error> {
    ColorMap::gradient([
        (0.00, [0.05, 0.09, 0.03]),
        (0.45, [0.21, 0.24, 0.10]),
        (0.45, [0.42, 0.40, 0.37]),
        (1.00, [0.71, 0.69, 0.66]),
    ])
}

/// Color by value, in closed form.
pub(super) fn values_of() -> Result<Scene, prefilter::Error> {
    Ok(Scene::new("lichen").texture(ramp()?).tier(EXACT))
}

/// Color by height, in closed form.
pub(super) fn heights() -> Result<Scene, prefilter::Error> {
    Ok(Scene::new("moss").height(ramp()?).height_tier(HeightTier::ClosedForm))
}

/// What hides nothing but what is behind.
pub(super) const BARE: Microsurface =
    Microsurface { shadowing: false, hotspot: false, masking: false, mean_slope: false, perturbed: false };

/// What is known of a surface, one more thing each.
fn surfaces() -> Result<Vec<(&'static str, Scene)>, prefilter::Error> {
    let of = |surface| Ok::<_, prefilter::Error>(heights()?.microsurface(surface));
    let image = Moments { slopes: true, ..Moments::default() };
    Ok(vec![
        ("height, no light", of(BARE)?),
        ("height, shadowing", of(Microsurface { shadowing: true, ..BARE })?),
        ("height, hotspot", of(Microsurface { shadowing: true, hotspot: true, ..BARE })?),
        ("height, tilted", of(Microsurface { mean_slope: true, ..BARE })?),
        ("height, perturbed", of(Microsurface { perturbed: true, ..BARE })?),
        ("height of an image with slopes", of(BARE)?.driver(Driver::Moments(image))),
        ("height by percentile", Scene::new("rust").height_percentile(ramp()?).microsurface(BARE)),
    ])
}

/// Where values and colors come from.
fn values() -> Result<Vec<(&'static str, Scene)>, prefilter::Error> {
    let image = |taps| Driver::Moments(Moments { taps, ..Moments::default() });
    Ok(vec![
        ("texture, dynamic colors", values_of()?.colors(Colors::Dynamic)),
        ("texture by a table", values_of()?.tier(Tier::Table)),
        ("texture of an image", values_of()?.driver(image(Taps::One))),
        ("texture of an image, eight taps", values_of()?.driver(image(Taps::Eight))),
        ("texture of noise", values_of()?.driver(Driver::Noise(Noise::default()))),
    ])
}

/// The other filters.
fn others() -> Result<Vec<(&'static str, Scene)>, prefilter::Error> {
    let cliff = ColorMap::gradient([(0.25, [0.22, 0.31, 0.09]), (0.7, [0.46, 0.41, 0.36]), (1.2, [0.31, 0.28, 0.26])])?;
    let snow = SlopeMap::from_function(48, SlopeDomain::Within(0.8), |[x, y]| {
        let covered = (2.0 * (0.3 - x) - 3.0 * x.hypot(y - 0.2)).clamp(0.0, 1.0);
        [0.31 + 0.6 * covered, 0.28 + 0.65 * covered, 0.25 + 0.72 * covered]
    })?;
    let slopes = cases()?.remove(2).1;
    Ok(vec![
        ("slope of a curve's heights", slopes.transfer(HeightTransfer::smoothstep(0.0, 1.2)?)),
        ("slope map", Scene::new("snow").slope_map(snow)),
        ("steepness", Scene::new("cliff").steepness(cliff)),
        ("irradiance", Scene::new("hill").irradiance(sky()?)),
        ("combination, lit by a sky", hills()?.irradiance(sky()?).reflectance(Reflectance::Lambert)),
    ])
}

/// A bright sky over dark ground.
pub(super) fn sky() -> Result<Irradiance, prefilter::Error> {
    let mut harmonics = [[0.02, 0.03, 0.04]; 9];
    harmonics[0] = [0.9, 1.1, 1.4];
    harmonics[2] = [0.5, 0.6, 0.9];
    Irradiance::from_harmonics(harmonics)
}

/// Grains of rock and sand by its slope.
pub(super) fn hills() -> Result<Scene, prefilter::Error> {
    let grain = Scene::new("grain").texture(ramp()?).tier(EXACT);
    let sand = cases()?.remove(2).1;
    Ok(Scene::new("hills").combination(Combination::from(&grain) * &sand).microsurface(BARE))
}
