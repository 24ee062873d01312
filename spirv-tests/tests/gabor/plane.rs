//! A plane to the horizon, cut out of the solid: the color beside that of many samples a pixel.

use prefilter::gpu::{Device, Work};
use prefilter::Kernel::Exact;
use prefilter::{Driver, Gabor, GaborMethod, Scene, Spectrum, Taps, Tier};
use spirv_tests::maps::named;

use crate::{kernel, rms, Found, Outcome};

/// The scene of `examples/data/colormaps.json`: pixels across and down. The first row is 2.5 pixels below the horizon,
/// the focal length 60.
const WIDTH: usize = 48;
const HEIGHT: usize = 36;

/// Parts of a pixel's samples, an invocation each: Mesa's software rasterizer ends loops after 65535 turns in all.
const PARTS: usize = 4;

/// Every pixel's place, once for each part.
fn pixels(parts: usize) -> Vec<[f32; 3]> {
    let place = |pixel: usize, part| [(pixel % WIDTH) as f32 - 23.5, (pixel / WIDTH) as f32 + 2.5, part as f32];
    (0..WIDTH * HEIGHT).flat_map(|pixel| (0..parts).map(move |part| place(pixel, part))).collect()
}

/// The point of the ground that a place of the picture sees, on a plane that lies askew in the solid.
const GROUND: &str = "
fn ground(pixel: vec2f) -> vec3f {
    let at = vec2f(pixel.x, 60.0) / pixel.y;
    return at.x * vec3f(0.8, -0.6, 0.0) + at.y * vec3f(0.36, 0.48, 0.8) + vec3f(3.1, -4.2, 1.7);
}

// A quarter of 32² stratified samples.
fn truth(pixel: vec3f) -> vec3f {
    var sum = vec3f();
    for (var sample = 0u; sample < 256u; sample++) {
        let stratum = vec2u(sample % 32u, sample / 32u + 8u * u32(pixel.z));
        let words = hash_triple(hash_triple(vec3u(vec2u(vec2i(2.0 * pixel.xy)), stratum.x + 32u * stratum.y)));
        let place = (vec2f(stratum) + vec2f(words.xy >> vec2u(8u)) / 16777216.0) / 32.0;
        let away = 0.5 * sqrt(-2.0 * log(max(1.0 - place.x, 1e-7)));
        let turn = 6.28318531 * place.y;
        let at = ground(vec2f(pixel.x + away * cos(turn), max(pixel.y + away * sin(turn), 0.05)));
        sum += rock_texture(rock_statistics(at, vec3f(), vec3f()).x, 0.0);
    }
    return sum / 256.0;
}

fn naive(pixel: vec3f) -> vec3f {
    return rock_texture(rock_statistics(ground(pixel.xy), vec3f(), vec3f()).x, 0.0);
}

fn color(pixel: vec3f) -> vec3f {
    let right = vec3f(0.8, -0.6, 0.0) / pixel.y;
    let down = -(pixel.x * vec3f(0.8, -0.6, 0.0) + 60.0 * vec3f(0.36, 0.48, 0.8)) / (pixel.y * pixel.y);
    return rock_color(ground(pixel.xy), right, down);
}
";

/// Colors of all pixels by a function of the text, the mean of so many parts.
fn colors(device: &Device, gabor: Gabor, map: &str, function: &str, parts: usize) -> Found<Vec<[f32; 3]>> {
    let scene = Scene::new("rock").texture(named(map)?).tier(Tier::ClosedForm(Exact));
    let module = scene.driver(Driver::Gabor(gabor)).module()?;
    let points: Vec<f32> = pixels(parts).concat();
    let kernel = kernel(device, &module, GROUND, &format!("vec4f({function}({{0}}), 0.0)"), 3)?;
    let invocations = points.len() / 3;
    let colors = kernel.run(&Work { inputs: &[&points], textures: &[], invocations, output: 4 * invocations })?;
    let mean = |all: &[f32]| [0, 1, 2].map(|at| all.iter().skip(at).step_by(4).sum::<f32>() / parts as f32);
    Ok(colors.chunks_exact(4 * parts).map(mean).collect())
}

/// Root mean square over pixels, of each the channel that is farthest off.
fn apart(one: &[[f32; 3]], other: &[[f32; 3]]) -> f64 {
    let farthest = |(a, b): (&[f32; 3], &[f32; 3])| (0..3).map(|at| (a[at] - b[at]).abs()).fold(0.0, f32::max);
    rms(one.iter().zip(other).map(farthest).map(f64::from))
}

/// The numbers of the gap that a module states.
fn stated(gabor: Gabor) -> Found<Vec<f64>> {
    let scene = Scene::new("rock").texture(named("terrain")?).driver(Driver::Gabor(gabor));
    let module = scene.module()?;
    let gap = module.explain().split("not in the error:").nth(1).ok_or("no gap")?;
    Ok(gap.split([' ', '\n', ';']).filter_map(|word| word.parse().ok()).collect())
}

#[test]
fn colors_of_a_plane_to_the_horizon() -> Outcome {
    let device = Device::new()?;
    let spectrum = Spectrum::Isotropic { frequency: 2.0 };
    let ours = |taps| Gabor { spectrum, bandwidth: 2.0, taps, ..Gabor::default() };
    let paper = Gabor { method: GaborMethod::Paper, ..ours(Taps::One) };
    let methods = [paper, ours(Taps::One), ours(Taps::Two), ours(Taps::Four), ours(Taps::Eight)];
    let mut figures = Vec::new();
    for map in ["terrain", "steps6"] {
        let mut sums = [0.0; 6];
        for seed in 1..=4 {
            let seeded = |gabor: Gabor| Gabor { seed, ..gabor };
            let truth = colors(&device, seeded(paper), map, "truth", PARTS)?;
            let mut add = |which: usize, found: &[[f32; 3]]| sums[which] += 0.25 * apart(found, &truth).powi(2);
            add(5, &colors(&device, seeded(paper), map, "naive", 1)?);
            for (which, &gabor) in methods.iter().enumerate() {
                add(which, &colors(&device, seeded(gabor), map, "color", 1)?);
            }
        }
        let [paper, one, two, four, eight, naive] = sums.map(f64::sqrt);
        println!("{map}: paper {paper:.4}, ours {one:.4}, taps {two:.4} {four:.4} {eight:.4}, naive {naive:.4}");
        assert!(one < 0.75 * paper && two < 0.8 * one && four < 0.75 * two && eight < 0.8 * four, "{map}");
        figures.push(sums.map(f64::sqrt));
    }
    let table =
        include_str!("../../../README.md").split("| RMS on a plane to the horizon |").nth(1).ok_or("no table")?;
    let rows: Vec<&str> = table.lines().skip(2).take(2).collect();
    for (row, figures) in rows.iter().zip(&figures) {
        let quoted: Vec<f64> = row.split('|').filter_map(|cell| cell.trim().parse().ok()).collect();
        let off = (0..6).map(|at| quoted.get(at).map_or(f64::INFINITY, |quoted| (quoted / figures[at] - 1.0).abs()));
        assert!(off.fold(0.0, f64::max) < 0.06, "the README says {quoted:?}, not {figures:?}");
    }
    for (which, &gabor) in methods.iter().enumerate() {
        let measured = [figures[0][which], figures[1][which], figures[0][5], figures[1][5]];
        let stated = stated(gabor)?;
        let off = stated.iter().zip(&measured).map(|(stated, measured)| (stated - measured).abs() / measured);
        assert!(stated.len() == 4 && off.fold(0.0, f64::max) < 0.06, "{stated:?}, not {measured:?}");
    }
    Ok(())
}
