//! The slopes of noise: of points and of the whole plane, and those that a footprint has and lacks against samples.

use prefilter::gpu::Device;
use prefilter::reference::fractal::Octaves;
use prefilter::reference::lattice::gradient;
use prefilter::reference::{perlin, simplex, value};
use prefilter::{ColorMap, Driver, Error, Noise, NoiseBasis, Scene};
use spirv_tests::kernel::Function;
use spirv_tests::random::Random;

use crate::{Found, Outcome};

/// Noises with their variances and those of their slopes along either axis over these, by their definitions.
const BASES: [(NoiseBasis, f64, f64); 3] = [
    (NoiseBasis::Perlin, 0.046_531_150_4, 8.383_952_08),
    (NoiseBasis::Value, 0.204_650_087_8, 3.646_408_84),
    (NoiseBasis::Simplex, 0.144_655_222_7, 160.0 / 7.0),
];

/// Octaves that are turned and scaled by odd amounts.
fn odd(basis: NoiseBasis, seed: u32) -> Noise {
    Noise { basis, octaves: 3, gain: 0.6, lacunarity: 2.1, rotation: 0.7, seed, ..Noise::default() }
}

fn scene(noise: Noise) -> Result<Scene, Error> {
    Ok(Scene::new("rock").slope(ColorMap::gradient([(0.0, [0.0; 3]), (1.0, [1.0; 3])])?).driver(Driver::Noise(noise)))
}

/// What the driver says of footprints: lists of position, across and along.
fn surfaces(device: &Device, noise: Noise, footprints: &[Vec<f64>]) -> Found<Vec<Vec<f64>>> {
    let module = scene(noise)?.module()?;
    let start = module.wgsl().find("fn rock_surface").ok_or("no surface")?;
    let end = module.wgsl()[start..].find("\n}\n").ok_or("no end")? + start + 3;
    let function = Function::in_text(&module.wgsl()[start..end], "rock_surface")?;
    Ok(function.results(device, &[], footprints)?)
}

/// The slope of the noise by its definition.
struct Truth {
    noise: Noise,
    octaves: Octaves,
    scale: f64,
    /// The variance of the slopes along either axis.
    variance: f64,
}

impl Truth {
    fn new(noise: Noise) -> Found<Self> {
        let (_, variance, slopes) =
            *BASES.iter().find(|(basis, ..)| *basis == noise.basis).ok_or("a noise of the plane")?;
        let octaves = Octaves {
            count: noise.octaves,
            gain: noise.gain.into(),
            lacunarity: noise.lacunarity.into(),
            rotation: noise.rotation.into(),
            offset: [0.618_033_989, 0.414_213_562],
        };
        let scale = f64::from(noise.deviation) / (octaves.power() * variance).sqrt();
        let growth = octaves.gain * octaves.lacunarity;
        let steep: f64 = (0..noise.octaves).map(|octave| growth.powi(2 * octave as i32)).sum();
        Ok(Self { noise, octaves, scale, variance: scale * scale * variance * slopes * steep })
    }

    fn slope(&self, position: [f64; 2]) -> [f64; 2] {
        let start = self.noise.seed.wrapping_mul(0x9e37_79b1);
        let height = |at: [f64; 2]| {
            self.octaves.sum(at, |at, octave| match self.noise.basis {
                NoiseBasis::Perlin => perlin::noise(at, [0; 2], start.wrapping_add(octave)),
                NoiseBasis::Value => value::noise(at, [0; 2], start.wrapping_add(octave)),
                _ => simplex::noise(at, start.wrapping_add(octave)),
            })
        };
        gradient(position, height).map(|slope| self.scale * slope)
    }
}

/// A place, and a footprint there with these deviations along an axis and across it.
struct Place {
    footprint: Vec<f64>,
    axis: [f64; 2],
    /// A point of the footprint.
    sample: [f64; 2],
}

/// About the origin within this deviation.
fn places(random: &mut Random, spread: f64, [major, minor]: [f64; 2], count: usize) -> Vec<Place> {
    let mut normal = || {
        let radius = (-2.0 * (1.0 - random.unit()).ln()).sqrt();
        let (sin, cos) = (std::f64::consts::TAU * random.unit()).sin_cos();
        [radius * cos, radius * sin]
    };
    let place = |_| {
        let [x, y] = normal().map(|part| f64::from((spread * part) as f32));
        let [axis, turn] = [normal(), normal()].map(|[x, y]| [x / x.hypot(y), y / x.hypot(y)]);
        // The two vectors are turned against the footprint's axes.
        let vector = |[a, b]: [f64; 2]| {
            let (a, b) = (major * a, minor * b);
            [a * axis[0] - b * axis[1], a * axis[1] + b * axis[0]].map(|part| f64::from(part as f32))
        };
        let (across, along) = (vector(turn), vector([-turn[1], turn[0]]));
        let [u, v] = normal();
        let sample = [0, 1].map(|at| [x, y][at] + u * across[at] + v * along[at]);
        Place { footprint: vec![x, y, across[0], across[1], along[0], along[1]], axis, sample }
    };
    (0..count).map(place).collect()
}

#[test]
fn a_point_has_its_slope_and_the_plane_has_all_slopes() -> Outcome {
    let device = Device::new()?;
    for (basis, ..) in BASES {
        // Of slopes the last octave has the most, and the first.
        for noise in [odd(basis, 3), Noise { gain: 0.2, ..odd(basis, 4) }, Noise { basis, ..Noise::default() }] {
            let truth = Truth::new(noise)?;
            let points = places(&mut Random::new(7), 4.0, [0.0; 2], 500);
            let footprints: Vec<Vec<f64>> = points.iter().map(|place| place.footprint.clone()).collect();
            let size = truth.variance.sqrt();
            // The rounding of places in the last of six octaves.
            for (point, found) in footprints.iter().zip(surfaces(&device, noise, &footprints)?) {
                let slope = truth.slope([point[0], point[1]]);
                let error = (found[4] - slope[0]).hypot(found[5] - slope[1]);
                assert!(error < 1e-3 * size, "{noise:?} {point:?}: {found:?} {slope:?}");
                assert!(found[6..] == [0.0; 3], "{noise:?} {point:?}: {found:?}");
            }
            for deviations in [[80.0, 60.0], [1e15, 1e12], [1e5, 3e3]] {
                let wide = places(&mut Random::new(8), 4.0, deviations, 200);
                let footprints: Vec<Vec<f64>> = wide.iter().map(|place| place.footprint.clone()).collect();
                for found in surfaces(&device, noise, &footprints)? {
                    let share = [6, 7, 8].map(|at| found[at] / truth.variance);
                    let near = |share: f64, whole: f64| (share - whole).abs() < 1e-3;
                    assert!(near(share[0], 1.0) && near(share[1], 0.0) && near(share[2], 1.0), "{noise:?} {found:?}");
                    assert!(found[4].hypot(found[5]) < 5e-3 * size, "{noise:?} {found:?}");
                }
            }
        }
    }
    Ok(())
}

/// Mean squares along the footprint's axes, of the noise's variance of slopes: of the mean slope, of what it misses of
/// samples, with the mean fourth power, and of that by the driver's covariance; the mean product of the missed slopes
/// along both axes; and what to multiply the mean slope by for the least error.
#[derive(Default)]
struct Squares {
    mean: [f64; 2],
    missed: [f64; 2],
    fourth: [f64; 2],
    covariance: [f64; 2],
    product: f64,
    multiplier: [f64; 2],
}

fn squares(device: &Device, noise: impl Fn(u32) -> Noise, deviations: [f64; 2], count: usize) -> Found<Squares> {
    let mut sums = Squares::default();
    let seeds = [1, 2, 3, 4];
    for seed in seeds {
        let noise = noise(seed);
        let truth = Truth::new(noise)?;
        let places = places(&mut Random::new(100 + seed), 100.0, deviations, count);
        let footprints: Vec<Vec<f64>> = places.iter().map(|place| place.footprint.clone()).collect();
        let unit = 1.0 / (truth.variance * (count * seeds.len()) as f64);
        for (place, found) in places.iter().zip(surfaces(device, noise, &footprints)?) {
            let [x, y] = place.axis;
            let axes = [[x, y], [-y, x]];
            let along = |[x, y]: [f64; 2], axis: [f64; 2]| x * axis[0] + y * axis[1];
            let mean = axes.map(|axis| along([found[4], found[5]], axis));
            let slope = axes.map(|axis| along(truth.slope(place.sample), axis));
            let missed = [0, 1].map(|at| slope[at] - mean[at]);
            for (at, [x, y]) in axes.into_iter().enumerate() {
                sums.mean[at] += unit * mean[at] * mean[at];
                sums.missed[at] += unit * missed[at] * missed[at];
                sums.fourth[at] += unit / truth.variance * missed[at].powi(4);
                sums.covariance[at] += unit * (x * x * found[6] + 2.0 * x * y * found[7] + y * y * found[8]);
                sums.multiplier[at] += unit * slope[at] * mean[at];
            }
            sums.product += unit * missed[0] * missed[1];
        }
    }
    sums.multiplier = [0, 1].map(|at| sums.multiplier[at] / sums.mean[at]);
    Ok(sums)
}

/// For four seeds, round and long footprints, turned against the lattice and their two vectors.
#[test]
fn slopes_are_those_of_samples() -> Outcome {
    let device = Device::new()?;
    for (basis, ..) in BASES {
        for major in [0.05, 0.2, 0.7, 2.0] {
            for aspect in [1.0, 8.0] {
                kept(&device, &|seed| Noise { basis, octaves: 1, seed, ..Noise::default() }, [major, major / aspect])?;
            }
        }
        for major in [0.03, 0.3, 1.0] {
            kept(&device, &|seed| odd(basis, seed), [major, major / 5.0])?;
        }
    }
    Ok(())
}

/// The covariance within 3 %, and the mean slope as near as any multiple of it.
fn kept(device: &Device, noise: &dyn Fn(u32) -> Noise, deviations: [f64; 2]) -> Outcome {
    // Samples a seed: the squares of small differences have long tails.
    let count = if deviations[0] < 0.6 { 32_000 } else { 10_000 };
    let found = squares(device, noise, deviations, count)?;
    let Squares { mean, missed, fourth, covariance, product, multiplier } = found;
    let errors = [0, 1].map(|at| covariance[at] / missed[at] - 1.0);
    let standard = [0, 1].map(|at| ((fourth[at] / missed[at].powi(2) - 1.0) / (4 * count) as f64).sqrt());
    let name = format!("{} {:?} {deviations:?}", noise(0).octaves, noise(0).basis);
    println!(
        "{name}: mean {mean:.3?} times {multiplier:.3?}, missed {missed:.4?}, covariance off by {errors:.3?} \
         ± {standard:.3?}, {product:.4}"
    );
    for at in [0, 1] {
        assert!(standard[at] < 0.01, "{name}: not measured well enough, {standard:?}");
        assert!(errors[at].abs() < 0.03, "{name}: {} is not {}", covariance[at], missed[at]);
        assert!((mean[at] + covariance[at] - 1.0).abs() < 0.02, "{name}: {} and {}", mean[at], covariance[at]);
        // What another multiple of the mean slope would win.
        let won = mean[at] * (multiplier[at] - 1.0).powi(2);
        assert!(!(mean[at] > 1e-6) || won < 1e-3, "{name}: the mean slope should be {} times as large", multiplier[at]);
    }
    assert!(product.abs() < 0.03 * (missed[0] * missed[1]).sqrt(), "{name}: {product}");
    Ok(())
}
