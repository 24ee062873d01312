//! The plane of `examples/data/colormaps.json` with twelve waves on it, seen up to its horizon, against stratified
//! samples of every pixel.

use std::fmt::Write;

use prefilter::driver::cosines::Wave;
use prefilter::gpu::Device;
use prefilter::{ColorMap, Cosines, Custom, Driver, Scene, Taps, Tier};
use spirv_tests::horizon::{colors, pixels, square, FOCAL};
use spirv_tests::maps::named;

use crate::{waves, Outcome};

/// Samples a pixel along each axis of the truth.
const SIDE: u32 = 32;
const MEAN: f32 = 0.5;

/// Position, dpdx and dpdy of every pixel.
fn footprints() -> Vec<f32> {
    let footprint = |[px, py]: [f64; 2]| {
        [px / py, FOCAL / py, 1.0 / py, 0.0, -px / (py * py), -FOCAL / (py * py)].map(|part| part as f32)
    };
    pixels().flat_map(footprint).collect()
}

/// `NAME_color` of a scene driven by something, on the plane.
fn filtered(device: &Device, map: &ColorMap, driver: Driver) -> Result<Vec<[f64; 3]>, prefilter::Error> {
    let module = Scene::new("sea").texture(map.clone()).driver(driver).module()?;
    let call = "fn color(p: array<f32, 6>) -> vec3f {
    return sea_color(vec2f(p[0], p[1]), vec2f(p[2], p[3]), vec2f(p[4], p[5]));
}";
    colors(device, module.link(call)?.wgsl(), &footprints())
}

/// The sum itself in WGSL, with what all filters share: nothing.
fn height(waves: &[Wave]) -> Result<String, std::fmt::Error> {
    let mut text = format!("fn height(p: vec2f) -> f32 {{\n    var sum = {MEAN:?};\n");
    for Wave { frequency: [x, y], amplitude, phase } in waves {
        writeln!(text, "    sum += {amplitude:?} * cos(6.28318531 * fract({x:?} * p.x + {y:?} * p.y + {phase:?}));")?;
    }
    Ok(text + "    return sum;\n}\n")
}

/// The map over stratified samples of the pixel's filter, a Gaussian of deviation ½, through the exact projection.
fn truth(device: &Device, map: &ColorMap, height: &str, seed: u32) -> Result<Vec<[f64; 3]>, prefilter::Error> {
    let module = Scene::new("truth").texture(map.clone()).tier(Tier::Naive).module()?;
    let text = format!(
        "fn word(state: u32) -> u32 {{
    let s = state * 747796405u + 2891336453u;
    let w = ((s >> ((s >> 28u) + 4u)) ^ s) * 277803737u;
    return (w >> 22u) ^ w;
}}
fn color(p: array<f32, 6>) -> vec3f {{
    var sum = vec3f();
    var state = word(bitcast<u32>(p[0]) ^ word(bitcast<u32>(p[1]) + {seed}u));
    for (var sample = 0u; sample < {SIDE}u * {SIDE}u; sample++) {{
        let first = word(state);
        state = word(first);
        let jitter = (vec2f(vec2u(first >> 8u, state >> 8u)) + 0.5) / 16777216.0;
        let unit = (vec2f(vec2u(sample % {SIDE}u, sample / {SIDE}u)) + jitter) / {SIDE}.0;
        let radius = 0.5 * sqrt(-2.0 * log(unit.x));
        let at = vec2f(p[0], p[1]) + radius * vec2f(cos(6.28318531 * unit.y), sin(6.28318531 * unit.y));
        let below = max(at.y, 0.01);
        sum += truth_texture(height(vec2f(at.x, {FOCAL:?}) / below), 0.0);
    }}
    return sum / {SIDE}.0 / {SIDE}.0;
}}
{height}"
    );
    let places: Vec<f32> = pixels().flat_map(|[x, y]| [x as f32, y as f32, 0.0, 0.0, 0.0, 0.0]).collect();
    colors(device, module.link(&text)?.wgsl(), &places)
}

/// The exact mean with the same deviation for all phases, as the paper has it; and the value at a point.
fn baselines(waves: &[Wave]) -> Result<[String; 2], std::fmt::Error> {
    let mut paper = format!(
        "fn paper(position: vec2f, across: vec2f, along: vec2f) -> vec4f {{
    var m = vec4f({MEAN:?}, 0.0, 0.0, 0.0);
"
    );
    for Wave { frequency: [x, y], amplitude, phase } in waves {
        writeln!(
            paper,
            "    {{
        let k = vec2f({x:?}, {y:?});
        let e = exp(-19.7392088 * (dot(k, across) * dot(k, across) + dot(k, along) * dot(k, along)));
        m += vec4f({amplitude:?} * e * cos(6.28318531 * fract(dot(k, position) + {phase:?})),
            {:?} * (1.0 - e * e), 0.0, 0.0);
    }}",
            0.5 * amplitude * amplitude
        )?;
    }
    let point = format!(
        "fn point(position: vec2f, across: vec2f, along: vec2f) -> vec4f {{
    return vec4f(height(position), 0.0, 0.0, 0.0);
}}
{}",
        height(waves)?
    );
    Ok([paper + "    return m;\n}\n", point])
}

/// Point, paper, and ours by 1, 2, 4 and 8 taps: root mean square errors over four sums of waves, and their standard
/// error.
fn errors(map: &ColorMap) -> Result<[[f64; 2]; 6], Box<dyn std::error::Error + Send + Sync>> {
    let device = Device::new()?;
    let mut squares = [[0.0; 4]; 6];
    for seed in 0..4 {
        let twelve = waves(12, 0.25, 16.0, 0.18, 40 + seed);
        let truth = truth(&device, map, &height(&twelve)?, seed)?;
        let [paper, point] = baselines(&twelve)?;
        let ours =
            |taps: Taps| Driver::Cosines(Cosines { waves: twelve.clone(), mean: MEAN, taps, ..Cosines::default() });
        let drivers = [
            Driver::Custom(Custom::new(point, "point")),
            Driver::Custom(Custom::new(paper, "paper")),
            ours(Taps::One),
            ours(Taps::Two),
            ours(Taps::Four),
            ours(Taps::Eight),
        ];
        for (method, driver) in drivers.into_iter().enumerate() {
            squares[method][seed as usize] = square(&filtered(&device, map, driver)?, &truth);
        }
    }
    Ok(squares.map(|squares| {
        let mean = squares.iter().sum::<f64>() / 4.0;
        let variance = squares.iter().map(|one| (one - mean).powi(2)).sum::<f64>() / 3.0;
        // Of the root: half the relative error of the square.
        [mean.sqrt(), 0.5 * (variance / 4.0).sqrt() / mean.sqrt()]
    }))
}

#[test]
fn waves_up_to_the_horizon_keep_their_figures() -> Outcome {
    let stripe = ColorMap::bands([0.0; 3], [(0.45, [1.0; 3]), (0.5125, [0.0; 3])])?;
    let [smooth, edged] = [errors(&named("gist_earth")?)?, errors(&stripe)?];
    println!("gist_earth: point, paper, 1, 2, 4 and 8 taps {smooth:.4?}");
    println!("a stripe of 1/16: point, paper, 1, 2, 4 and 8 taps {edged:.4?}");
    assert!(smooth.iter().chain(&edged).all(|[error, standard]| 3.0 * standard < *error));
    // The paper's deviation errs by 0.015 and 0.079.
    assert!((0.013..0.02).contains(&smooth[1][0]) && (0.075..0.083).contains(&edged[1][0]));
    let waves = waves(1, 0.3, 1.0, 0.1, 0);
    for (index, taps) in [Taps::One, Taps::Two, Taps::Four, Taps::Eight].into_iter().enumerate() {
        let driver = Driver::Cosines(Cosines { waves: waves.clone(), taps, ..Cosines::default() });
        let module = Scene::new("sea").texture(stripe.clone()).driver(driver).module()?;
        let [smooth, edged] = [smooth[2 + index][0], edged[2 + index][0]];
        let quoted = format!("an RMS of {smooth:.3} with a smooth map and {edged:.3} with a narrow stripe");
        assert!(module.explain().contains(&quoted), "{quoted} is not in\n{}", module.explain());
    }
    Ok(())
}
