//! Heights from an image's pyramid.

use prefilter::gpu::{Address, Device, Kernel, Work};
use prefilter::reference::height::mean;
use prefilter::table::Format;
use prefilter::{Driver, Edge, HeightTier, Microsurface, MomentMipmap, Moments, Scene, SlopeMipmap, Taps};
use spirv_tests::maps::named;
use spirv_tests::random::Random;

use crate::{lambda, Outcome};

const ENTRY: &str = "
@group(0) @binding(0) var<storage, read_write> colors: array<vec4f>;
@group(0) @binding(1) var<storage, read> footprint: array<f32>;
@group(1) @binding(0) var image: texture_2d<f32>;
@group(1) @binding(1) var image_sampler: sampler;
@compute @workgroup_size(1)
fn main() {
    let reach = footprint[0];
    let covariance = vec3f(0.25, 0.1, 0.3);
    let color = rock_color(vec2f(0.3, 0.6), vec2f(reach, 0.0), vec2f(0.0, reach), covariance, vec3f(0.8, 0.0, 0.6),
        vec3f(0.0, 0.8, 0.6), image, image_sampler);
    colors[0] = vec4f(color, 0.0);
}";

/// A footprint over all of the image and more has its mean and deviation, and its color is that of these heights,
/// however many taps lie in it.
#[test]
fn a_pixel_of_a_whole_image_sees_its_heights() -> Outcome {
    let device = Device::new()?;
    let mut random = Random::new(3);
    let heights: Vec<f32> = (0..4096).map(|_| (0.2 + 0.5 * random.unit()) as f32).collect();
    let mipmap = MomentMipmap::new(64, 64, &heights, Edge::Repeat)?;
    let table = mipmap.table("image", Format::Rg32Float)?;
    let texture = device.upload(&table, Address::Repeat)?;
    let covariance = [0.25, 0.1, 0.3];
    let sum = lambda([0.8, 0.0, 0.6], covariance) + lambda([0.0, 0.8, 0.6], covariance);
    let [center, deviation] = mipmap.moments().map(f64::from);
    let truth = mean(&named("terrain")?.reference(), center, deviation, sum);
    for taps in [Taps::One, Taps::Four] {
        let scene = Scene::new("rock").height(named("terrain")?).height_tier(HeightTier::ClosedForm);
        let module = scene.driver(Driver::Moments(Moments { taps, ..Moments::default() })).module()?;
        let names: Vec<&str> = module.exports().iter().map(|export| export.name.as_str()).collect();
        assert_eq!(names, ["rock_height", "rock_visibility", "rock_color"]);
        assert!(module.explain().contains("footprints are from normal") && module.explain().contains("Smith's model"));
        let kernel = Kernel::new(&device, module.link(ENTRY)?.wgsl(), "main")?;
        let work = Work { inputs: &[&[900.0]], textures: &[&texture], invocations: 1, output: 4 };
        let color = kernel.run(&work)?;
        for channel in 0..3 {
            let apart = (f64::from(color[channel]) - truth[channel]).abs();
            assert!(apart <= f64::from(module.bound().value()), "{taps:?}: {color:?}, {truth:?}");
        }
    }
    Ok(())
}

/// What the heights take besides stands behind the driver's own parameters, and tables behind the image.
#[test]
fn parameters_keep_their_order() -> Outcome {
    let surface = Microsurface { mean_slope: true, perturbed: true, shadowing: false, ..Microsurface::default() };
    let scene = Scene::new("rock").height(named("terrain")?).height_tier(HeightTier::Skewed).microsurface(surface);
    let module = scene.driver(Driver::Moments(Moments::default())).module()?;
    let color = module.exports().iter().find(|export| export.name == "rock_color").ok_or("no color")?;
    let names: Vec<&str> = color.parameters().into_iter().map(|(name, _)| name).collect();
    let expected = "position dpdx dpdy noise_mean noise_deviation mean_slope slope_covariance view moments \
                    moments_sampler table table_sampler";
    assert_eq!(names.join(" "), expected);
    Ok(())
}

/// The driver's color, and that of the filter for the whole image's statistics: `OWN` is its mean slope.
const WITH_SLOPES: &str = "
@group(0) @binding(0) var<storage, read_write> colors: array<vec4f>;
@group(0) @binding(1) var<storage, read> whole: array<f32>;
@group(1) @binding(0) var image: texture_2d<f32>;
@group(1) @binding(1) var image_sampler: sampler;
@group(1) @binding(2) var slopes: texture_2d<f32>;
@group(1) @binding(3) var slopes_sampler: sampler;
@group(1) @binding(4) var cross_slopes: texture_2d<f32>;
@compute @workgroup_size(1)
fn main() {
    let right = vec2f(whole[0], 0.0);
    let view = vec3f(0.8, 0.0, 0.6);
    let light = vec3f(0.0, 0.8, 0.6);
    let color = rock_color(vec2f(0.3, 0.6), right, right.yx, view, light, image, image_sampler, slopes, cross_slopes,
        slopes_sampler);
    colors[0] = vec4f(color, 0.0);
    let covariance = vec3f(whole[5], whole[6], whole[7]);
    colors[1] = vec4f(rock_height(whole[1], whole[2], OWNcovariance, view, light), 0.0);
}";

/// Where slopes come from the image's other pyramid they are those of the whole footprint.
#[test]
fn a_pixel_of_a_whole_image_finds_its_slopes() -> Outcome {
    let device = Device::new()?;
    let mut random = Random::new(5);
    let heights: Vec<f32> = (0..4096).map(|_| (0.2 + 0.5 * random.unit()) as f32).collect();
    let (values, slopes) = (
        MomentMipmap::new(64, 64, &heights, Edge::Repeat)?,
        SlopeMipmap::from_heights(64, 64, &heights, 0.6, Edge::Repeat)?,
    );
    let [four, two] = slopes.tables("slopes", Format::Rgba32Float)?;
    let textures = [values.table("image", Format::Rg32Float)?, four, two];
    let textures = [0, 1, 2]
        .map(|number| device.upload(&textures[number], Address::Repeat))
        .into_iter()
        .collect::<Result<Vec<_>, _>>()?;
    let (mean, covariance) = slopes.moments();
    let whole = [&[900.0][..], &values.moments(), &mean, &covariance].concat();
    for (mean_slope, own) in [(false, ""), (true, "vec2f(whole[3], whole[4]), ")] {
        let surface = Microsurface { mean_slope, ..Microsurface::default() };
        let scene =
            Scene::new("rock").height(named("terrain")?).height_tier(HeightTier::ClosedForm).microsurface(surface);
        let driver = Driver::Moments(Moments { taps: Taps::Four, slopes: true, ..Moments::default() });
        let module = scene.driver(driver).module()?;
        let color = module.exports().iter().find(|export| export.name == "rock_color").ok_or("no color")?;
        let names: Vec<&str> = color.parameters().into_iter().map(|(name, _)| name).collect();
        let expected = "position dpdx dpdy view light moments moments_sampler slopes slopes_cross slopes_sampler";
        assert_eq!(names.join(" "), expected);
        let entry = WITH_SLOPES.replace("OWN", own);
        let kernel = Kernel::new(&device, module.link(&entry)?.wgsl(), "main")?;
        let textures: Vec<_> = textures.iter().collect();
        let colors = kernel.run(&Work { inputs: &[&whole], textures: &textures, invocations: 1, output: 8 })?;
        for channel in 0..3 {
            let [color, own] = [colors[channel], colors[4 + channel]];
            assert!(own > 0.01 && (color - own).abs() <= 4e-6, "{mean_slope}: {colors:?}");
        }
    }
    Ok(())
}

#[test]
fn values_have_no_slopes() -> Outcome {
    let texture = Scene::new("rock").texture(named("terrain")?);
    let refused = texture.driver(Driver::Moments(Moments { slopes: true, ..Moments::default() })).module();
    let message = refused.err().ok_or("a texture has slopes")?.to_string();
    assert!(
        message.contains("a `texture` goes without a driver that gives mean and deviation of a height"),
        "{message}"
    );
    Ok(())
}
