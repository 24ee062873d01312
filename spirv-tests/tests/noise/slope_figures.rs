//! Question 3: colors of the slopes of noise on a plane up to the horizon, by one evaluation and by several taps.
//!
//! All slopes count alike, so that what errs is the driver and not what a view sees of them.

use prefilter::gpu::Device;
use prefilter::{Driver, Kernel, Module, Noise, NoiseBasis, Scene, SlopeTier, Taps, Tier};
use spirv_tests::horizon::{colors, square};
use spirv_tests::maps::named;

use crate::plane::{Plane, Truth};
use crate::{octaves, Found, Outcome};

const SEEDS: [u32; 4] = [1, 2, 3, 4];
/// Along which slopes are colored.
const DIRECTION: [f64; 2] = [0.6, 0.8];

/// Six octaves whose slopes have a deviation of about a half along every direction.
fn noise(seed: u32, taps: Taps) -> Noise {
    Noise { deviation: 0.08, seed, taps, ..Noise::default() }
}

fn module(map: &str, tier: SlopeTier, noise: Noise) -> Found<Module> {
    let scene = Scene::new("rock").slope(named(map)?).slope_tier(tier).tier(Tier::ClosedForm(Kernel::Exact));
    Ok(scene.driver(Driver::Noise(noise)).module()?)
}

/// A function `truth_noise(position: vec2f) -> f32`: the slope of the noise by its definition, the gradients of the
/// octaves turned back one by one.
fn slope(noise: &Noise) -> Found<String> {
    assert_eq!(noise.basis, NoiseBasis::Perlin);
    let height = octaves(noise);
    let [x, y] = DIRECTION;
    let start = height.find("    var sum = ").ok_or("no sum")?;
    let end = height[start..].find(";\n").ok_or("no sum")? + start;
    // The direction goes along with the position from octave to octave, and each rises along it.
    let sum = format!("    var sum = 0.0;\n    var way = vec2f({x:?}, {y:?})");
    let text = format!("{}{sum}{}", &height[..start], &height[end..]);
    let text = text.replace("perlin_noise(", "dot(perlin_noise(").replace(").x;\n", ").yz, way);\n");
    let text = text.replace("        let turned", "        way = turned_way(way);\n        let turned");
    let (turn, lacunarity) = (noise.rotation, noise.lacunarity);
    Ok(format!(
        "fn turned_way(way: vec2f) -> vec2f {{
    let turned = vec2f(cos({turn:?}) * way.x - sin({turn:?}) * way.y, sin({turn:?}) * way.x + cos({turn:?}) * way.y);
    return {lacunarity:?} * turned;
}}
{text}"
    ))
}

/// The colors of a module's `NAME_color` on the plane.
fn filtered(device: &Device, module: &Module, plane: &Plane) -> Result<Vec<[f64; 3]>, prefilter::Error> {
    let export = module.exports().iter().find(|export| export.name == "rock_color");
    let view =
        if export.is_some_and(|export| export.signature.contains("view")) { "vec3f(0.0, 0.0, 1.0), " } else { "" };
    let [x, y] = DIRECTION;
    let text = format!(
        "fn color(p: array<f32, 6>) -> vec3f {{
    return rock_color(vec2f(p[0], p[1]), vec2f(p[2], p[3]), vec2f(p[4], p[5]), {view}vec2f({x:?}, {y:?}));
}}"
    );
    colors(device, module.link(&text)?.wgsl(), &plane.points())
}

/// Root mean square errors in thousandths, with their standard errors over the seeds: of the truth, of the slope at a
/// point, of the mean slope, and by one, two, four and eight taps.
fn errors(device: &Device, map: &str) -> Found<[[f64; 2]; 7]> {
    let mut squares: [Vec<f64>; 7] = Default::default();
    for seed in SEEDS {
        let (plane, text) = (Plane::new(seed), slope(&noise(seed, Taps::One))?);
        let [first, second] = [17, 4711].map(|jitter| Truth::new(map, &text, 32, jitter));
        let (first, second) = (first?, second?);
        let (one, two) = (first.mean(device, &plane)?, second.mean(device, &plane)?);
        let truth: Vec<[f64; 3]> = one.iter().zip(&two).map(|(a, b)| [0, 1, 2].map(|c| 0.5 * (a[c] + b[c]))).collect();
        // Half the difference of two halves is the standard error of their mean.
        squares[0].push(square(&one, &two) / 4.0);
        squares[1].push(square(&first.naive(device, &plane)?, &truth));
        let naive = module(map, SlopeTier::Naive, noise(seed, Taps::One))?;
        squares[2].push(square(&filtered(device, &naive, &plane)?, &truth));
        for (at, taps) in [Taps::One, Taps::Two, Taps::Four, Taps::Eight].into_iter().enumerate() {
            let module = module(map, SlopeTier::Unweighted, noise(seed, taps))?;
            squares[3 + at].push(square(&filtered(device, &module, &plane)?, &truth));
        }
    }
    Ok(squares.map(|squares| {
        let count = squares.len() as f64;
        let mean = squares.iter().sum::<f64>() / count;
        let spread = squares.iter().map(|square| (square - mean).powi(2)).sum::<f64>() / (count - 1.0);
        [1e3 * mean.sqrt(), 1e3 * (spread / count).sqrt() / (2.0 * mean.sqrt())]
    }))
}

/// The table of the driver's documentation, in thousandths.
fn documented(map: &str) -> Vec<f64> {
    let text = include_str!("../../../src/driver/noise.rs");
    let row = text.lines().find_map(|row| row.strip_prefix(&format!("/// | {map} | "))).unwrap_or_default();
    row.trim_end_matches(" |").split(" | ").filter_map(|number| number.parse().ok()).collect()
}

#[test]
fn slopes_up_to_the_horizon_keep_their_figures() -> Outcome {
    let device = Device::new()?;
    let all = [Taps::One, Taps::Two, Taps::Four, Taps::Eight];
    let found = [errors(&device, "terrain")?, errors(&device, "steps6")?];
    for (map, [truth, point, mean, taps @ ..]) in ["terrain", "steps6"].into_iter().zip(&found) {
        println!("{map}: truth {truth:.1?}, 1, 2, 4, 8 taps {taps:.1?}, mean slope {mean:.1?}, point {point:.1?}");
        let figures: Vec<f64> = documented(map);
        assert_eq!(figures.len(), 6, "{map}");
        for ([error, standard], figure) in taps.iter().chain([mean, point]).zip(&figures) {
            assert!(*standard < error / 3.0 && truth[0] < error / 3.0, "{map}: not measured well enough");
            assert!((error - figure).abs() < 1.0, "{map}: {error} is not {figure}");
        }
        assert!(taps[0][0] < 0.25 * mean[0].min(point[0]), "{map}: {taps:?}");
    }
    for (at, taps) in all.into_iter().enumerate() {
        let explained = module("terrain", SlopeTier::Unweighted, noise(1, taps))?.explain().to_owned();
        let [terrain, steps] = [0, 1].map(|map| found[map][3 + at][0] / 1e3);
        let [_, said] = explained.split("all counted alike, it is ").collect::<Vec<_>>()[..] else {
            return Err(format!("no figure of slopes in\n{explained}").into());
        };
        let said: Vec<f64> = said.split([' ', ';']).filter_map(|word| word.parse().ok()).take(2).collect();
        assert!((said[0] - terrain).abs() < 1e-3 && (said[1] - steps).abs() < 1e-3, "{said:?} {terrain} {steps}");
    }
    Ok(())
}
