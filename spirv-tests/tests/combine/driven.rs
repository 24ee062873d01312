//! Combinations whose statistics come from functions of the position.

use prefilter::driver::pattern::Motif;
use prefilter::gpu::Device;
use prefilter::{
    ColorMap, Combination, Custom, Driver, Error, Microsurface, Pattern, Reflectance, Scene, SlopeTier, Taps, Warp,
};
use spirv_tests::random::Random;

use crate::{run, Outcome};

/// Grain in a wave along x, and hills that are a plane with lost waves.
const TEXT: &str = "fn grains(position: vec2f, across: vec2f, along: vec2f) -> vec4f {
    return vec4f(0.5 + 0.3 * sin(position.x), 0.01 + 0.1 * dot(across, across), 0.0, 0.0);
}
fn plane(position: vec2f, across: vec2f, along: vec2f) -> vec4f {
    return vec4f(0.4 + 0.2 * position.y, 0.02 + 0.04 * dot(along, along), 0.0, 0.0);
}
fn plane_slope(position: vec2f, across: vec2f, along: vec2f) -> vec2f {
    return vec2f(0.1 * position.x, 0.2);
}
fn plane_slope_covariance(position: vec2f, across: vec2f, along: vec2f) -> vec3f {
    return vec3f(0.1 + dot(across, across), 0.02, 0.05);
}";

/// What the functions say of a pixel of deviation ½, by the name of a parameter.
fn said(place: &[f64], name: &str) -> Option<Vec<f64>> {
    let &[x, y, ax, ay, bx, by] = place else { return None };
    let (across, along) = (0.25 * (ax * ax + ay * ay), 0.25 * (bx * bx + by * by));
    match name {
        "position" => Some(vec![x, y]),
        "dpdx" => Some(vec![ax, ay]),
        "dpdy" => Some(vec![bx, by]),
        "grain_mean" => Some(vec![0.5 + 0.3 * x.sin()]),
        "grain_deviation" => Some(vec![(0.01 + 0.1 * across).sqrt()]),
        "mean" => Some(vec![0.4 + 0.2 * y]),
        "deviation" => Some(vec![(0.02 + 0.04 * along).sqrt()]),
        "mean_slope" => Some(vec![0.1 * x, 0.2]),
        "slope_covariance" => Some(vec![0.1 + across, 0.02, 0.05]),
        _ => None,
    }
}

/// What the caller passes.
fn passed(name: &str) -> Vec<f64> {
    match name {
        "view" => vec![0.36, 0.48, 0.8],
        "light" => vec![0.0, -0.6, 0.8],
        "direction" => vec![0.6, 0.8],
        "radiance" => vec![1.5, 1.0, 0.5],
        _ => vec![0.7],
    }
}

fn driver(function: &str, taps: Taps) -> Driver {
    Driver::Custom(Custom { taps, ..Custom::new(TEXT, function) })
}

fn grain(taps: Taps) -> Result<Scene, Error> {
    let map = ColorMap::gradient([(0.1, [0.5; 3]), (0.9, [1.0, 0.95, 0.9])])?;
    Ok(Scene::new("grain").texture(map).driver(driver("grains", taps)))
}

fn sand() -> Result<Scene, Error> {
    let map = ColorMap::gradient([(-0.3, [0.7, 0.6, 0.4]), (0.3, [0.9, 0.8, 0.6])])?;
    Ok(Scene::new("sand").slope(map).slope_tier(SlopeTier::Gaussian))
}

fn high() -> Result<Scene, Error> {
    Ok(Scene::new("high").height(ColorMap::gradient([(0.3, [0.1; 3]), (0.6, [1.0, 0.8, 0.9])])?))
}

/// The driven color is that of the export that shows the most, with what the functions say.
#[test]
fn the_color_is_that_of_what_the_drivers_say() -> Outcome {
    let device = Device::new()?;
    let mut random = Random::new(3);
    let places: Vec<Vec<f64>> =
        (0..200).map(|_| (0..6).map(|_| f64::from((2.0 * random.unit() - 1.0) as f32)).collect()).collect();
    let tilted = Microsurface { mean_slope: true, ..Microsurface::default() };
    let (grain, sand, high) = (grain(Taps::One)?, sand()?, high()?);
    let layers = &grain * &sand * Combination::weight("wet")? + 0.5 * &high;
    let hills = || Scene::new("hills").combination(&layers).microsurface(tilted);
    let ground = driver("plane", Taps::One);
    let cases = [
        (Scene::new("hills").combination(0.5 * &grain), "hills_combined", 3),
        (Scene::new("hills").combination(0.5 * &grain + 0.5 * &high), "hills_combined", 5),
        (hills().driver(ground.clone()), "hills_combined", 7),
        (hills().driver(ground).reflectance(Reflectance::Lambert), "hills_radiance", 8),
    ];
    for (scene, called, count) in cases {
        let module = scene.module()?;
        let color = module.exports().iter().find(|export| export.name == "hills_color").ok_or("no color")?;
        assert!(color.parameters().len() >= count && !color.signature.contains("grain"), "{}", color.signature);
        let number = |place: usize, name: &str| said(&places[place], name).unwrap_or_else(|| passed(name));
        let found = run(&device, &module, "hills_color", places.len(), number)?;
        let expected = run(&device, &module, called, places.len(), number)?;
        for (place, (found, expected)) in found.iter().zip(&expected).enumerate() {
            let apart = (0..3).map(|channel| (found[channel] - expected[channel]).abs()).fold(0.0, f32::max);
            assert!(apart < 4e-6 && expected[0] > 0.01, "{called}, {place}: {found:?} is not {expected:?}");
        }
    }
    Ok(())
}

/// Taps of a footprint over which nothing changes are one; over others they are not.
#[test]
fn taps_average_the_whole_color() -> Outcome {
    let device = Device::new()?;
    let color = |taps: Taps, place: &[f64]| {
        let scene = Scene::new("hills").combination(grain(taps)? * &sand()?).driver(driver("plane", taps));
        let module = scene.module()?;
        run(&device, &module, "hills_color", 1, |_, name| said(place, name).unwrap_or_else(|| passed(name)))
    };
    for (spread, alike) in [(1e-4, true), (1.5, false)] {
        let place = [0.3, -0.2, spread, 0.0, 0.0, spread];
        let (one, eight) = (color(Taps::One, &place)?[0], color(Taps::Eight, &place)?[0]);
        assert_eq!((one[0] - eight[0]).abs() < 1e-5, alike, "{one:?} {eight:?}");
    }
    Ok(())
}

/// Colors of a pattern's layer are mixed from those of its two values, as those of its scene alone, displaced or not.
#[test]
fn layers_of_patterns_have_two_colors() -> Outcome {
    let device = Device::new()?;
    let map = ColorMap::gradient([(0.2, [0.1, 0.9, 0.4]), (0.5, [0.9, 0.1, 0.2]), (0.8, [0.3, 0.4, 1.0])])?;
    let stripes = Pattern { motif: Motif::Stripes { duty: 0.3 }, values: [0.25, 0.7], ..Pattern::default() };
    let stripes = Driver::Pattern(stripes);
    for driver in [stripes.clone(), Driver::Warp(Warp::of(stripes))] {
        let scene = Scene::new("tiles").texture(map.clone()).driver(driver);
        let alone = scene.module()?;
        let layered = Scene::new("room").combination(0.5 * &scene).module()?;
        let mut random = Random::new(4);
        let places: Vec<Vec<f64>> = (0..500).map(|_| (0..6).map(|_| 2.0 * random.unit() - 1.0).collect()).collect();
        let number = |place: usize, name: &str| said(&places[place], name).unwrap_or_default();
        let alone = run(&device, &alone, "tiles_color", places.len(), number)?;
        let layered = run(&device, &layered, "room_color", places.len(), number)?;
        for (alone, layered) in alone.iter().zip(&layered) {
            assert!((0..3).all(|at| (0.5 * alone[at] - layered[at]).abs() < 2e-6), "{alone:?} {layered:?}");
        }
    }
    Ok(())
}

#[test]
fn drivers_that_do_not_go_together_are_refused() -> Outcome {
    let refused = |scene: Scene, part: &str| {
        let message = scene.module().err().map(|error| error.to_string()).unwrap_or_default();
        assert!(message.contains(part), "{message:?} does not say {part:?}");
    };
    let ground = || driver("plane", Taps::One);
    let scene = |combination: Combination| Scene::new("hills").combination(combination);
    refused(scene(grain(Taps::Two)? * &sand()?).driver(ground()), "differs in dimensions, taps or pixel");
    refused(scene(grain(Taps::One)? * 0.5).driver(ground()), "which no layer takes");
    let flat = driver("grains", Taps::One); // knows no slopes
    refused(scene(sand()? * 0.5).driver(flat), "takes nothing of a driver that gives values and heights without");
    refused(scene(sand()?.driver(ground()) * 0.5), "which all layers share: give it to `hills`");
    refused(scene(grain(Taps::One)? * Combination::weight("across")?), "the weight `across` of `hills` has a name");
    Ok(())
}
