//! The driver of noise: its limits, its definition, its tiles, and what it refuses.

use prefilter::gpu::{Device, Kernel, Work};
use prefilter::reference::fractal::Octaves;
use prefilter::reference::{perlin, simplex, value};
use prefilter::{ColorMap, Driver, Error, Noise, NoiseBasis, NoiseFold, NoiseMethod, Scene};
use spirv_tests::random::Random;

use crate::Outcome;

const BASES: [NoiseBasis; 3] = [NoiseBasis::Perlin, NoiseBasis::Value, NoiseBasis::Simplex];

const METHODS: [NoiseMethod; 3] = [NoiseMethod::Gradient, NoiseMethod::Curvature, NoiseMethod::Stationary];

fn scene(noise: Noise) -> Result<Scene, Error> {
    Ok(Scene::new("rock").texture(ColorMap::gradient([(0.0, [0.0; 3]), (1.0, [1.0; 3])])?).driver(Driver::Noise(noise)))
}

/// Statistics at lists of position, across and along.
pub fn statistics(device: &Device, noise: Noise, points: &[f32]) -> Result<Vec<[f64; 4]>, Error> {
    let entry = "
@group(0) @binding(0) var<storage, read_write> output: array<vec4f>;
@group(0) @binding(1) var<storage, read> points: array<array<f32, 6>>;
@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= arrayLength(&points) { return; }
    let p = points[id.x];
    output[id.x] = rock_statistics(vec2f(p[0], p[1]), vec2f(p[2], p[3]), vec2f(p[4], p[5]));
}";
    let invocations = points.len() / 6;
    let kernel = Kernel::new(device, scene(noise)?.module()?.link(entry)?.wgsl(), "main")?;
    let found = kernel.run(&Work { inputs: &[points], textures: &[], invocations, output: 4 * invocations })?;
    Ok(found.chunks_exact(4).map(|four| [0, 1, 2, 3].map(|at| f64::from(four[at]))).collect())
}

/// Positions with one footprint.
fn spread(seed: u32, count: usize, across: [f32; 2], along: [f32; 2]) -> Vec<f32> {
    let mut random = Random::new(seed);
    let mut place = || (20.0 * random.unit() - 10.0) as f32;
    (0..count).flat_map(|_| [place(), place(), across[0], across[1], along[0], along[1]]).collect()
}

#[test]
fn a_point_has_the_noise_and_no_variance() -> Outcome {
    let device = Device::new()?;
    for (basis, method) in BASES.into_iter().flat_map(|b| METHODS.map(|m| (b, m))) {
        let noise = Noise { basis, method, octaves: 4, gain: 0.6, ..Noise::default() };
        let noise = Noise { lacunarity: 2.1, rotation: 0.7, seed: 9, ..noise };
        let octaves = Octaves {
            count: 4,
            gain: f64::from(noise.gain),
            lacunarity: f64::from(noise.lacunarity),
            rotation: f64::from(noise.rotation),
            offset: [0.618_033_989, 0.414_213_562],
        };
        let variance = match basis {
            NoiseBasis::Perlin => 0.046_531_150_4,
            NoiseBasis::Value => 0.204_650_087_8,
            _ => 0.144_655_222_7,
        };
        let seed = |octave| 9u32.wrapping_mul(0x9e37_79b1).wrapping_add(octave);
        let points = spread(4, 3000, [0.0; 2], [0.0; 2]);
        for (point, found) in points.chunks_exact(6).zip(statistics(&device, noise, &points)?) {
            let sum = octaves.sum([f64::from(point[0]), f64::from(point[1])], |at, octave| match basis {
                NoiseBasis::Perlin => perlin::noise(at, [0; 2], seed(octave)),
                NoiseBasis::Value => value::noise(at, [0; 2], seed(octave)),
                _ => simplex::noise(at, seed(octave)),
            });
            let expected = 0.5 + 0.18 * sum / (octaves.power() * variance).sqrt();
            assert!((found[0] - expected).abs() < 2e-5, "{basis:?} at {point:?}: {found:?} is not {expected}");
            assert!(found[1..] == [0.0; 3], "{basis:?}: {found:?}");
        }
    }
    Ok(())
}

#[test]
fn wide_footprints_have_the_mean_and_the_variance_of_the_plane() -> Outcome {
    let device = Device::new()?;
    for (basis, method) in BASES.into_iter().flat_map(|b| METHODS.map(|m| (b, m))) {
        let noise = Noise { basis, method, ..Noise::default() };
        for (across, along) in [([60.0, 0.0], [0.0, 80.0]), ([1e15, 1e14], [-1e12, 1e15]), ([3e5, 4e5], [0.0, 0.0])] {
            for found in statistics(&device, noise, &spread(5, 500, across, along))? {
                assert!((found[0] - 0.5).abs() < 2e-3, "{basis:?} {method:?} {across:?}: {found:?}");
                assert!((found[1] / 0.18f64.powi(2) - 1.0).abs() < 2e-3, "{basis:?} {method:?} {across:?}: {found:?}");
            }
        }
    }
    Ok(())
}

/// A small footprint's variance is that of the plane which touches the noise: its gradient, by differences of means.
#[test]
fn small_footprints_have_the_variance_of_the_gradient() -> Outcome {
    const SIZE: f32 = 1e-3;
    let device = Device::new()?;
    for (basis, method) in BASES.into_iter().flat_map(|b| [METHODS[0], METHODS[1]].map(|m| (b, m))) {
        let noise = Noise { basis, method, octaves: 3, ..Noise::default() };
        let points = spread(6, 2000, [SIZE, 0.0], [0.3 * SIZE, 0.5 * SIZE]);
        let moved = |x: f32, y: f32| {
            let point = |p: &[f32]| [p[0] + x, p[1] + y, 0.0, 0.0, 0.0, 0.0];
            statistics(&device, noise, &points.chunks_exact(6).flat_map(point).collect::<Vec<_>>())
        };
        let step = 0.01f32;
        let sides = [moved(step, 0.0)?, moved(-step, 0.0)?, moved(0.0, step)?, moved(0.0, -step)?];
        let found = statistics(&device, noise, &points)?;
        let (mut error, mut whole) = (0.0, 0.0);
        for (at, found) in found.iter().enumerate() {
            let slope = [0, 2].map(|side| (sides[side][at][0] - sides[side + 1][at][0]) / (2.0 * f64::from(step)));
            let size = f64::from(SIZE);
            let rises = [size * slope[0], size * (0.3 * slope[0] + 0.5 * slope[1])];
            let expected: f64 = rises.iter().map(|rise| rise * rise).sum();
            error += (found[1] - expected).abs();
            whole += expected;
        }
        println!("{basis:?} {method:?}: variance of small footprints within {:.1e} of the gradient's", error / whole);
        assert!(error < 2e-2 * whole, "{basis:?} {method:?}: {error:e} of {whole:e}");
    }
    Ok(())
}

#[test]
fn tiles_repeat() -> Outcome {
    let device = Device::new()?;
    let noise = Noise { period: 5, rotation: 0.0, lacunarity: 3.0, octaves: 4, ..Noise::default() };
    for basis in [NoiseBasis::Perlin, NoiseBasis::Value] {
        let tile = Noise { basis, ..noise };
        let mut random = Random::new(2);
        let mut place = || (65536.0 * 5.0 * random.unit()).round() as f32 / 65536.0;
        let points: Vec<f32> = (0..1000).flat_map(|_| [place(), place(), 0.1, 0.0, 0.0, 0.2]).collect();
        let moved = |by: [f32; 2]| -> Vec<f32> {
            points.chunks_exact(6).flat_map(|p| [p[0] + by[0], p[1] + by[1], p[2], p[3], p[4], p[5]]).collect()
        };
        let home = statistics(&device, tile, &points)?;
        let apart = |other: &[[f64; 4]]| home.iter().zip(other).map(|(a, b)| (a[0] - b[0]).abs()).fold(0.0, f64::max);
        // Rounding in the last of 4 octaves.
        assert!(apart(&statistics(&device, tile, &moved([5.0, -10.0]))?) < 1e-5, "{basis:?}");
        assert!(apart(&statistics(&device, tile, &moved([4.0, 0.0]))?) > 0.1, "{basis:?}");
        assert!(apart(&statistics(&device, Noise { period: 0, ..tile }, &moved([5.0, -10.0]))?) > 0.1, "{basis:?}");
    }
    Ok(())
}

#[test]
fn what_is_no_noise_is_refused() -> Outcome {
    let refused = |noise: Noise| match scene(noise).and_then(|scene| scene.module()) {
        Err(error) => error.to_string(),
        Ok(_) => String::new(),
    };
    let fine = Noise { rotation: 0.0, period: 4, ..Noise::default() };
    assert_eq!(refused(fine), "");
    for (noise, says) in [
        (Noise { octaves: 0, ..fine }, "the noise's number of octaves is 0; allowed is 1 to 16"),
        (Noise { gain: f32::NAN, ..fine }, "the noise's gain is NaN"),
        (Noise { gain: 1.5, ..fine }, "the noise's gain is 1.5"),
        (Noise { lacunarity: 0.5, ..fine }, "the noise's lacunarity is 0.5; allowed is 1 to 16"),
        (Noise { rotation: f32::INFINITY, ..fine }, "the noise's rotation is inf"),
        (Noise { mean: 1e7, ..fine }, "the noise's mean is 10000000.0"),
        (Noise { deviation: -0.1, ..fine }, "the noise's deviation is -0.1"),
        (Noise { rotation: 0.5, ..fine }, "octaves that are not turned"),
        (Noise { lacunarity: 2.5, ..fine }, "a whole `lacunarity`"),
        (Noise { basis: NoiseBasis::Simplex, ..fine }, "is not `Simplex`"),
        (Noise { period: 1 << 22, ..fine }, "in the last octave"),
    ] {
        let error = refused(noise);
        assert!(error.contains(says), "`{error}` does not say `{says}`");
    }
    let slopes = |noise: Noise| -> Result<_, Error> {
        let dune = Scene::new("dune").slope(ColorMap::gradient([(0.0, [0.0; 3]), (1.0, [1.0; 3])])?);
        dune.driver(Driver::Noise(noise)).module()
    };
    slopes(Noise::default())?;
    for noise in [
        Noise { basis: NoiseBasis::PerlinSolid, ..Noise::default() },
        Noise { basis: NoiseBasis::ValueSolid, ..Noise::default() },
        Noise { fold: NoiseFold::Ridged, ..Noise::default() },
        Noise { method: NoiseMethod::Stationary, ..Noise::default() },
    ] {
        let error = slopes(noise).unwrap_err().to_string();
        assert!(error.contains("without slopes, `Driver::Noise` in space, folded or"), "{error}");
    }
    Ok(())
}
