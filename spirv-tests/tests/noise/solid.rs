//! Noise in space that a plane cuts: its statistics, what footprints hold of it, and colors up to the horizon.

use prefilter::gpu::Device;
use prefilter::reference::lattice_solid::word;
use prefilter::{Driver, Kernel, Module, Noise, NoiseBasis, NoiseFold, NoiseMethod, Scene, Taps, Tier};
use spirv_tests::horizon::{colors, square};
use spirv_tests::maps::named;
use spirv_tests::random::Random;

use crate::plane::{Plane, Truth};
use crate::{at, Outcome};

/// Noises with their variances, by their definitions, and those of their slopes over them.
fn noises() -> [(&'static str, &'static str, f64, f64); 2] {
    let (a, b) = (181.0 / 231.0, 535.0 / 9009.0);
    [("perlin_solid", "perlin_solid", 2.0 * a * a * b, 6.80477), ("value_solid", "value", a * a * a / 3.0, 3.64641)]
}

/// Mean square with its standard error.
fn square_of(values: impl Iterator<Item = f64> + Clone) -> [f64; 2] {
    let count = values.clone().count() as f64;
    let mean = values.clone().map(|value| value * value).sum::<f64>() / count;
    let spread = values.map(|value| (value * value - mean).powi(2)).sum::<f64>() / count;
    [mean, (spread / count).sqrt()]
}

#[test]
fn the_variances_are_those_of_the_definition() -> Outcome {
    let device = Device::new()?;
    let mut random = Random::new(6);
    let points: Vec<Vec<f64>> = (0..500_000)
        .map(|_| [0, 1, 2].map(|_| f64::from((2e3 * (random.unit() - 0.5)) as f32)))
        .map(|place| [&place[..], &[0.0, 0.0, 0.0, 9.0]].concat())
        .collect();
    for (name, _, variance, slopes) in noises() {
        let found = at(&device, &format!("{name}_noise"), &points)?;
        for channel in 0..4 {
            let expected = if channel == 0 { variance } else { slopes * variance };
            let [mean, error] = square_of(found.iter().map(|values| values[channel]));
            println!("{name} {channel}: {mean:.6} ± {error:.1e}, expected {expected:.6}");
            assert!((mean - expected).abs() < 5.0 * error, "{name} {channel}: {mean} is not {expected} ± {error}");
        }
    }
    Ok(())
}

/// Words of neighbors, and of neighboring seeds, know nothing of each other: their upper halves, which are used.
#[test]
fn words_of_neighbors_are_independent() {
    let upper = |place: [i64; 3], seed: u32| f64::from(word(place, seed) >> 16) / 65536.0 - 0.5;
    let places: Vec<[i64; 3]> = (0..60i64.pow(3)).map(|at| [at % 60 - 30, at / 60 % 60 - 30, at / 3600 - 30]).collect();
    for ([x, y, z], seed) in [([1, 0, 0], 0), ([0, 1, 0], 0), ([0, 0, 1], 0), ([1, 1, 0], 0), ([0, 0, 0], 1)] {
        let products =
            places.iter().map(|&[a, b, c]| 12.0 * upper([a, b, c], 3) * upper([a + x, b + y, c + z], 3 + seed));
        let mean = products.sum::<f64>() / places.len() as f64;
        // A product of two even distributions of variance 1 has the variance 1.
        assert!(mean.abs() < 5.0 / (places.len() as f64).sqrt(), "{x} {y} {z} {seed}: {mean}");
    }
}

#[test]
fn periods_repeat() -> Outcome {
    let device = Device::new()?;
    let mut random = Random::new(2);
    // Binary fractions of 2⁻¹² move by whole numbers without rounding.
    let places: Vec<[f64; 3]> =
        (0..2000).map(|_| [0, 1, 2].map(|_| (9.0 * 4096.0 * random.unit()).round() / 4096.0)).collect();
    for (name, ..) in noises() {
        let moved = |apart: [f64; 3], period: [f64; 3]| {
            let place = |p: &[f64; 3]| [&[0, 1, 2].map(|axis| p[axis] + apart[axis])[..], &period, &[4.0]].concat();
            at(&device, &format!("{name}_noise"), &places.iter().map(place).collect::<Vec<_>>())
        };
        let home = moved([0.0; 3], [3.0, 5.0, 2.0])?;
        assert!(home == moved([-3.0, 10.0, 4.0], [3.0, 5.0, 2.0])?, "{name}: a period does not repeat the noise");
        assert!(home != moved([-3.0, 10.0, 4.0], [0.0; 3])?, "{name}: the noise repeats without a period");
    }
    Ok(())
}

/// Half the mean square of the difference of two points of a footprint is the variance within it, on planes of all
/// turns.
#[test]
fn lost_variances_are_those_of_samples_on_planes() -> Outcome {
    const COUNT: usize = 600_000;
    let device = Device::new()?;
    let mut random = Random::new(12);
    let mut normal = move || {
        let radius = (-2.0 * (1.0 - random.unit()).ln()).sqrt();
        let (sin, cos) = (std::f64::consts::TAU * random.unit()).sin_cos();
        [radius * cos, radius * sin]
    };
    for (name, filter, variance, _) in noises() {
        for deviation in [0.05, 0.1, 0.2, 0.3, 0.5, 1.0, 2.0] {
            let mut pair = || {
                let [[x, y], [z, a], [b, c], [d, e]] = [normal(), normal(), normal(), normal()];
                // Two directions at right angles.
                let first = f64::sqrt(a * a + b * b + c * c);
                let (u, v) = ([a / first, b / first, c / first], [d, e, 0.5 * (d - e)]);
                let along: f64 = (0..3).map(|axis| u[axis] * v[axis]).sum();
                let w = [0, 1, 2].map(|axis| v[axis] - along * u[axis]);
                let second = w.iter().map(|part| part * part).sum::<f64>().sqrt();
                let place = [300.0 * x, 300.0 * y, 300.0 * z];
                [normal(), normal()].map(|[p, q]| {
                    let at = |axis: usize| place[axis] + deviation * (p * u[axis] + q * w[axis] / second);
                    [&[0, 1, 2].map(|axis| f64::from(at(axis) as f32))[..], &[0.0, 0.0, 0.0, 5.0]].concat()
                })
            };
            let pairs: Vec<[Vec<f64>; 2]> = (0..COUNT).map(|_| pair()).collect();
            let [a, b] = [0, 1].map(|which| pairs.iter().map(|pair| pair[which].clone()).collect::<Vec<_>>());
            let (a, b) = (at(&device, &format!("{name}_noise"), &a)?, at(&device, &format!("{name}_noise"), &b)?);
            let halves: Vec<f64> = a.iter().zip(&b).map(|(a, b)| 0.5 * (a[0] - b[0]).powi(2) / variance).collect();
            let mean = halves.iter().sum::<f64>() / COUNT as f64;
            let spread = halves.iter().map(|half| (half - mean).powi(2)).sum::<f64>() / COUNT as f64;
            let error = (spread / COUNT as f64).sqrt() / mean;
            let wider = 2f64.sqrt() * deviation;
            let lost = at(&device, &format!("{filter}_lost"), &[vec![wider, wider]])?[0][0];
            println!("{name} {deviation}: lost {lost:.5}, sampled {mean:.5} ± {:.2}%", 100.0 * error);
            assert!(error < 0.02 / 3.0, "{name} {deviation}: not measured well enough, {error}");
            assert!((lost / mean - 1.0).abs() < 0.02, "{name} {deviation}: {lost} is not {mean}");
        }
    }
    Ok(())
}

/// A plane in space: positions of its two coordinates.
const CUT: &str = "fn cut(p: vec2f) -> vec3f {
    return mat2x3f(0.8, 0.36, 0.48, -0.6, 0.48, 0.64) * p;
}";

fn module(noise: Noise, tier: Tier) -> Result<Module, Box<dyn std::error::Error + Send + Sync>> {
    Ok(Scene::new("rock").texture(named("terrain")?).tier(tier).driver(Driver::Noise(noise)).module()?)
}

fn filtered(device: &Device, module: &Module, plane: &Plane) -> Result<Vec<[f64; 3]>, prefilter::Error> {
    let text = format!(
        "{CUT}
fn color(p: array<f32, 6>) -> vec3f {{
    return rock_color(cut(vec2f(p[0], p[1])), cut(vec2f(p[2], p[3])), cut(vec2f(p[4], p[5])));
}}"
    );
    colors(device, module.link(&text)?.wgsl(), &plane.points())
}

/// Four octaves by their definition, without a rotation.
fn definition(noise: &Noise, name: &str, variance: f64) -> String {
    let power: f64 = (0..noise.octaves).map(|octave| 0.25f64.powi(octave as i32)).sum();
    let scale = f64::from(noise.deviation) / (power * variance).sqrt();
    let (count, seed) = (noise.octaves, noise.seed.wrapping_mul(0x9e37_79b1));
    format!(
        "{CUT}
fn truth_noise(position: vec2f) -> f32 {{
    var at = cut(position);
    var sum = 0.5;
    for (var octave = 0u; octave < {count}u; octave++) {{
        sum += {scale:?} / f32(1u << octave) * {name}_noise(at, vec3f(), {seed}u + octave).x;
        at = 2.0 * at + vec3f(0.618033989, 0.414213562, 0.732050808);
    }}
    return sum;
}}"
    )
}

#[test]
fn one_evaluation_tells_most_of_a_footprint() -> Outcome {
    let device = Device::new()?;
    let exact = Tier::ClosedForm(Kernel::Exact);
    for (basis, (name, _, variance, _)) in [NoiseBasis::PerlinSolid, NoiseBasis::ValueSolid].into_iter().zip(noises()) {
        let mut squares = [const { Vec::new() }; 6];
        for seed in [1, 2, 3, 4] {
            let plane = Plane::new(seed);
            let noise = Noise { basis, seed, octaves: 4, rotation: 0.0, ..Noise::default() };
            let text = definition(&noise, name, variance);
            let [first, second] = [17, 4711].map(|jitter| Truth::new("terrain", &text, 16, jitter));
            let (first, second) = (first?, second?);
            let (one, two) = (first.mean(&device, &plane)?, second.mean(&device, &plane)?);
            let mean = |(a, b): (&[f64; 3], &[f64; 3])| [0, 1, 2].map(|channel| 0.5 * (a[channel] + b[channel]));
            let truth: Vec<[f64; 3]> = one.iter().zip(&two).map(mean).collect();
            let of = |method, taps| module(Noise { method, taps, ..noise }, exact);
            let found = [
                first.naive(&device, &plane)?,
                filtered(&device, &of(NoiseMethod::Stationary, Taps::One)?, &plane)?,
                filtered(&device, &of(NoiseMethod::Gradient, Taps::One)?, &plane)?,
                filtered(&device, &of(NoiseMethod::Gradient, Taps::Four)?, &plane)?,
                filtered(&device, &of(NoiseMethod::Gradient, Taps::Eight)?, &plane)?,
            ];
            squares.iter_mut().zip(&found).for_each(|(squares, found)| squares.push(square(found, &truth)));
            squares[5].push(square(&one, &two) / 4.0);
        }
        let rms = squares.map(|squares| 1e3 * (squares.iter().sum::<f64>() / squares.len() as f64).sqrt());
        println!("{name}: point, paper, 1 tap, 4 taps, 8 taps, truth in thousandths: {rms:.1?}");
        let [point, paper, one, four, eight, truth] = rms;
        assert!(truth < eight / 3.0, "{name}: not measured well enough");
        // As of noise in the plane.
        assert!(one <= 55.0 && four <= 36.0 && eight <= 29.0, "{name}: {rms:?}");
        assert!(one < 0.85 * paper && one < 0.5 * point, "{name}: {rms:?}");
    }
    Ok(())
}

/// A footprint of nothing is the noise itself, turned octaves or not.
#[test]
fn footprints_of_nothing_are_points() -> Outcome {
    let device = Device::new()?;
    let plane = Plane::new(5);
    for (basis, (name, _, variance, _)) in [NoiseBasis::PerlinSolid, NoiseBasis::ValueSolid].into_iter().zip(noises()) {
        let noise = Noise { basis, octaves: 4, rotation: 0.0, ..Noise::default() };
        let truth = Truth::new("terrain", &definition(&noise, name, variance), 1, 1)?.naive(&device, &plane)?;
        let text = format!(
            "{CUT}
fn color(p: array<f32, 6>) -> vec3f {{
    return rock_color(cut(vec2f(p[0], p[1])), vec3f(), vec3f());
}}"
        );
        let point = |noise: Noise| -> Result<_, Box<dyn std::error::Error + Send + Sync>> {
            Ok(colors(&device, module(noise, Tier::Naive)?.link(&text)?.wgsl(), &plane.points())?)
        };
        let apart = square(&point(noise)?, &truth).sqrt();
        assert!(apart < 1e-4, "{name}: {apart}");
        assert!(square(&point(Noise { rotation: 0.5, ..noise })?, &truth) > 1e-3);
        let folded = module(Noise { fold: NoiseFold::Turbulence, ..noise }, Tier::Naive);
        assert!(folded.is_err_and(|error| error.to_string().contains("not in space")));
    }
    Ok(())
}
