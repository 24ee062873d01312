//! Drivers that are functions: is the mixture of their taps the footprint, and do filters find what they say?

use prefilter::gpu::Device;
use prefilter::{
    ColorMap, Custom, Driver, HeightTier, Kernel, Microsurface, Module, Pixel, Scene, SlopeTier, Taps, Tier,
};
use spirv_tests::exports::ExportKernel;
use spirv_tests::random::Random;

type Outcome = Result<(), Box<dyn std::error::Error + Send + Sync>>;

/// The mean of squares over a footprint, as a value of no variance: what several taps return is the trace of their
/// mixture, and the square of the position.
const SQUARES: &str = "fn squares(position: VEC, across: VEC, along: VEC) -> vec4f {
    let trace = dot(across * WEIGHT, across) + dot(along * WEIGHT, along);
    return vec4f(dot(position * WEIGHT, position) + trace, 0.0, 0.0, 0.0);
}";

/// A height field with slopes.
const RAMP: &str = "fn ramp(position: vec2f, across: vec2f, along: vec2f) -> vec4f {
    return vec4f(0.5 + 0.1 * position.x, 0.01 * dot(across, across) + 0.002, 0.0, 0.0);
}
fn ramp_slope(position: vec2f, across: vec2f, along: vec2f) -> vec2f {
    return vec2f(0.1, 0.02 * position.y);
}
fn ramp_slope_covariance(position: vec2f, across: vec2<f32>, along: vec2<f32>) -> vec3<f32> {
    return vec3f(0.02, 0.003, 0.01) + vec3f(dot(along, along), 0.0, 0.0);
}";

fn gradient() -> Result<ColorMap, prefilter::Error> {
    ColorMap::gradient([(0.0, [0.0; 3]), (200.0, [200.0, 100.0, 50.0])])
}

fn colors(device: &Device, module: &Module, export: &str, points: &[f32]) -> Result<Vec<[f32; 4]>, prefilter::Error> {
    let export = module.exports().iter().find(|one| one.name == export).unwrap();
    ExportKernel::new(device, module, export)?.run(points)
}

/// Means of squares see the whole covariance, which the mixture of the taps' footprints must have; weights tell the
/// axes apart.
#[test]
fn the_mixture_of_taps_has_the_covariance_of_the_footprint() -> Outcome {
    let device = Device::new()?;
    let mut random = Random::new(11);
    let pixels = [Pixel::Round(0.5), Pixel::Covariance([0.3, 0.1, 0.4])];
    for (size, vector, weight) in [(2, "vec2f", "vec2f(1.0, 0.5)"), (3, "vec3f", "vec3f(1.0, 0.5, 2.0)")] {
        let text = SQUARES.replace("VEC", vector).replace("WEIGHT", weight);
        let weights = [1.0, 0.5, 2.0];
        let points: Vec<f32> = (0..3000 * size).map(|_| (4.0 * random.unit() - 2.0) as f32).collect();
        for (taps, pixel) in
            [Taps::One, Taps::Two, Taps::Four, Taps::Eight].into_iter().flat_map(|t| pixels.map(|p| (t, p)))
        {
            let custom = Custom { taps, pixel, ..Custom::new(&text, "squares") };
            let scene = Scene::new("moss").texture(gradient()?).tier(Tier::ClosedForm(Kernel::Exact));
            let module = scene.driver(Driver::Custom(custom)).module()?;
            let found = colors(&device, &module, "moss_color", &points)?;
            let [xx, xy, yy] = match pixel {
                Pixel::Round(deviation) => [deviation * deviation, 0.0, deviation * deviation],
                Pixel::Covariance(covariance) => covariance,
            }
            .map(f64::from);
            for (point, color) in points.chunks_exact(3 * size).zip(&found) {
                let axis = |axis: usize| {
                    let [p, x, y] = [0, 1, 2].map(|vector| f64::from(point[vector * size + axis]));
                    weights[axis] * (p * p + xx * x * x + 2.0 * xy * x * y + yy * y * y)
                };
                let expected: f64 = (0..size).map(axis).sum();
                let error = (f64::from(color[0]) - expected).abs();
                assert!(error < 2e-5 * (1.0 + expected), "{size} {taps:?} {pixel:?}: {color:?} is not {expected}");
            }
        }
    }
    Ok(())
}

/// The filter gets the statistics of the function, of its slopes too, in the right order.
#[test]
fn filters_find_what_the_function_says() -> Outcome {
    let device = Device::new()?;
    let map = ColorMap::gradient([(-0.5, [0.1, 0.0, 0.3]), (0.2, [0.5, 0.9, 0.4]), (0.9, [1.0, 0.2, 0.6])])?;
    let tilted = Microsurface { mean_slope: true, ..Microsurface::default() };
    let heights = Scene::new("moss").height(map.clone()).height_tier(HeightTier::ClosedForm);
    let slopes = Scene::new("moss").slope(map.clone()).slope_tier(SlopeTier::Gaussian);
    // Position, derivatives; view, light or direction. Halves are the pixel's deviation.
    let place = [0.7, -0.4, 0.2, 0.1, -0.1, 0.3];
    let (view, light) = ([0.36, 0.48, 0.8], [0.0, -0.6, 0.8]);
    let values = [0.57, (0.01 * 0.25 * 0.05f32 + 0.002).sqrt()];
    let (mean, covariance) = ([0.1, -0.008], [0.02 + 0.25 * 0.1, 0.003, 0.01]);
    let cases = [
        (Scene::new("moss").texture(map), "moss_texture", vec![], values.to_vec()),
        (heights.clone(), "moss_height", [view, light].concat(), [&values[..], &covariance].concat()),
        (
            heights.microsurface(tilted),
            "moss_height",
            [view, light].concat(),
            [&values[..], &mean, &covariance].concat(),
        ),
        (slopes, "moss_slope", [&view[..], &[0.6, 0.8]].concat(), [&mean[..], &covariance].concat()),
    ];
    for (scene, filter, given, statistics) in cases {
        let module = scene.driver(Driver::Custom(Custom::new(RAMP, "ramp"))).module()?;
        let expected = colors(&device, &module, filter, &[&statistics[..], &given].concat())?;
        let found = colors(&device, &module, "moss_color", &[&place[..], &given].concat())?;
        for channel in 0..3 {
            let [found, expected] = [found[0][channel], expected[0][channel]];
            assert!((found - expected).abs() < 2e-6 && expected > 0.01, "{filter}: {found} is not {expected}");
        }
    }
    Ok(())
}

/// A footprint of nothing is a point, and the widest derivatives, singular ones among them, stay numbers of the map.
#[test]
fn any_derivatives_give_colors_of_the_map() -> Outcome {
    let device = Device::new()?;
    let text = "fn wave(position: vec3f, across: vec3f, along: vec3f) -> vec4f {
        let lost = 1.0 - exp(-min(dot(across, across) + dot(along, along), 80.0));
        return vec4f(0.5 + 0.3 * sin(position.x) * (1.0 - lost), 0.045 * lost, 0.0, 0.0);
    }";
    let map = ColorMap::gradient([(0.2, [0.25, 0.0, 0.5]), (0.8, [0.75, 1.0, 0.5])])?;
    let ends = [0.0, 1e-45, 1e-30, 1e-3, 1.0, -1e9, 1e30, f32::MAX];
    let steps = ends.into_iter().flat_map(|x| ends.map(|y| [[x, 0.0, 0.0], [0.0, y, y], [x, y, 0.0], [y, -x, x]]));
    let steps: Vec<[f32; 3]> = steps.flatten().collect();
    let points: Vec<f32> =
        steps.iter().flat_map(|x| steps.iter().flat_map(|y| [&[0.7, 0.2, -0.1], &x[..], y].concat())).collect();
    for taps in [Taps::One, Taps::Two, Taps::Four, Taps::Eight] {
        let custom = Custom { taps, ..Custom::new(text, "wave") };
        let scene = Scene::new("moss").texture(map.clone()).tier(Tier::ClosedForm(Kernel::Exact));
        let found = colors(&device, &scene.driver(Driver::Custom(custom)).module()?, "moss_color", &points)?;
        for (place, color) in points.chunks_exact(9).zip(&found) {
            let inside = (0.25..=0.75).contains(&color[0]) && (0.0..=1.0).contains(&color[1]) && color[2] == 0.5;
            assert!(inside, "{taps:?} at {place:?}: {color:?}");
            if place[3..].iter().all(|part| part.abs() < 1e-20) {
                let value = 0.5 + 0.3 * 0.7f32.sin();
                let expected = 0.25 + (value - 0.2) / 0.6 * 0.5;
                assert!((color[0] - expected).abs() < 1e-6, "{taps:?} at {place:?}: {color:?} is not {expected}");
            }
        }
    }
    Ok(())
}

#[test]
fn functions_that_do_not_fit_are_refused() -> Outcome {
    let scene = || Ok::<_, prefilter::Error>(Scene::new("moss").texture(gradient()?));
    let refused = |scene: Scene, text: &str, name: &str| {
        let module = scene.driver(Driver::Custom(Custom::new(text, name))).module();
        module.map(|_| String::new()).unwrap_or_else(|error| error.to_string())
    };
    let plane = SQUARES.replace("VEC", "vec2f").replace("WEIGHT", "1.0");
    assert_eq!(refused(scene()?, &plane, "squares"), "");
    let renamed = plane.replace("position", "vector").replace("vec2f", "vec2<f32>");
    assert_eq!(refused(scene()?, &renamed, "squares"), "");
    let cases = [
        (refused(scene()?, &plane, "cubes"), "declares no `cubes`; it needs `fn cubes(position: vec2f"),
        (refused(scene()?, &plane.replace("-> vec4f", "-> f32"), "squares"), "allowed is `fn squares(position: vec2f"),
        (
            refused(
                scene()?,
                &format!("{plane}\nfn squares_slope(at: vec2f, a: vec2f, b: vec2f) -> vec2f {{ return at; }}"),
                "squares",
            ),
            "declares no `squares_slope_covariance`",
        ),
        (
            refused(scene()?, &plane.replace("along: vec2f)", "along: vec2f, time: f32)"), "squares"),
            "allowed is `fn squares(position: vec2f",
        ),
        (refused(scene()?, "fn squares(", "squares"), "`fn squares(` does not match"),
        (
            refused(Scene::new("moss").slope(gradient()?), &plane, "squares"),
            "a `slope` goes without a driver that gives values and heights without slopes",
        ),
        (
            refused(scene()?, &plane.replace("return", "let mean = nothing; return"), "squares"),
            "no definition in scope for identifier: `nothing`",
        ),
    ];
    for (message, part) in cases {
        assert!(message.contains(part), "{message:?} does not say {part:?}");
    }
    Ok(())
}

/// A shader that has the function already is linked with the module, and two modules with one function are.
#[test]
fn a_function_stands_once_in_what_is_linked() -> Outcome {
    let text = SQUARES.replace("VEC", "vec2f").replace("WEIGHT", "1.0");
    let module = |name: &str| {
        Scene::new(name).texture(gradient()?).driver(Driver::Custom(Custom::new(&text, "squares"))).module()
    };
    let (moss, rock) = (module("moss")?, module("rock")?);
    for given in ["", &text] {
        let linked = prefilter::link(&[&moss, &rock], given)?;
        assert_eq!(linked.wgsl().matches("fn squares(").count(), 1);
        assert!(linked.wgsl().contains("fn moss_color(") && linked.wgsl().contains("fn rock_color("));
    }
    let other = Custom::new(text.replace("0.0, 0.0, 0.0", "1.0, 0.0, 0.0"), "squares");
    let sand = Scene::new("sand").texture(gradient()?).driver(Driver::Custom(other)).module()?;
    let refused = prefilter::link(&[&moss, &sand], "").expect_err("one name, two functions").to_string();
    assert!(refused.contains("the drivers of `moss` and `sand` declare `squares` differently"), "{refused}");
    Ok(())
}
