//! Does a footprint hold what one evaluation with second derivatives says of it, and does it say more than without?

use prefilter::gpu::Device;
use prefilter::{Driver, Error, Noise, NoiseBasis, NoiseFold, NoiseMethod, Scene};
use spirv_tests::maps::named;
use spirv_tests::random::Random;

use crate::driver::statistics;
use crate::Outcome;

/// Footprints, and samples of each.
const PLACES: usize = 20_000;
const SAMPLES: usize = 32;

/// Of the mean and the variance that a method says: the mean square error of the mean, the mean square of what the
/// samples are from it, and the mean of the variance.
#[derive(Debug)]
struct Said {
    error: f64,
    square: f64,
    variance: f64,
}

/// What two methods say of footprints whose axes are turned at random, against the same samples.
fn judged(device: &Device, basis: NoiseBasis, [major, minor]: [f64; 2]) -> Result<[Said; 2], Error> {
    let mut random = Random::new(11);
    let (mut places, mut samples) = (Vec::new(), Vec::new());
    for _ in 0..PLACES {
        let [x, y] = [0; 2].map(|_| 400.0 * random.unit() - 200.0);
        let (sin, cos) = (std::f64::consts::TAU * random.unit()).sin_cos();
        let axes = [[major * cos, major * sin], [-minor * sin, minor * cos]];
        places.extend([x, y, axes[0][0], axes[0][1], axes[1][0], axes[1][1]].map(|part| part as f32));
        for _ in 0..SAMPLES {
            let radius = (-2.0 * (1.0 - random.unit()).ln()).sqrt();
            let (sin, cos) = (std::f64::consts::TAU * random.unit()).sin_cos();
            let at = |axis: usize| [x, y][axis] + radius * (cos * axes[0][axis] + sin * axes[1][axis]);
            samples.extend([at(0), at(1), 0.0, 0.0, 0.0, 0.0].map(|part| part as f32));
        }
    }
    let noise = Noise { basis, ..Noise::default() };
    let values: Vec<f64> = statistics(device, noise, &samples)?.into_iter().map(|found| found[0]).collect();
    let mut said = Vec::new();
    for method in [NoiseMethod::Gradient, NoiseMethod::Curvature] {
        let found = statistics(device, Noise { method, ..noise }, &places)?;
        let (mut error, mut square, mut variance) = (0.0, 0.0, 0.0);
        for (found, values) in found.iter().zip(values.chunks_exact(SAMPLES)) {
            let count = SAMPLES as f64;
            let mean = values.iter().sum::<f64>() / count;
            let own = values.iter().map(|value| (value - mean).powi(2)).sum::<f64>() / (count - 1.0);
            // What samples leave open is not the method's error.
            error += (mean - found[0]).powi(2) - own / count;
            square += values.iter().map(|value| (value - found[0]).powi(2)).sum::<f64>() / count;
            variance += found[1];
        }
        let [error, square, variance] = [error, square, variance].map(|sum| sum / PLACES as f64);
        said.push(Said { error, square, variance });
    }
    <[Said; 2]>::try_from(said).map_err(|_| Error::Conflict("two methods".into()))
}

#[test]
fn second_derivatives_tell_more_of_the_mean_and_keep_the_variance() -> Outcome {
    let device = Device::new()?;
    for basis in [NoiseBasis::Perlin, NoiseBasis::Value, NoiseBasis::Simplex] {
        for major in [0.02, 0.06, 0.2, 0.6] {
            for minor in [major, 0.1 * major] {
                let [plain, bent] = judged(&device, basis, [major, minor])?;
                let errors = [plain.error, bent.error].map(f64::sqrt);
                let variance = bent.variance / bent.square;
                println!(
                    "{basis:?} {major} × {minor:.3}: error of the mean {:.4}, without {:.4}; variance {variance:.4} \
                     of the samples'",
                    errors[1], errors[0]
                );
                assert!((variance - 1.0).abs() < 0.02, "{basis:?} {major} × {minor}: {variance}");
                let most = if major < 0.3 { 0.6 } else { 0.95 };
                assert!(errors[1] < most * errors[0], "{basis:?} {major} × {minor}: {errors:?}");
            }
        }
    }
    Ok(())
}

#[test]
fn folds_and_noise_in_space_have_no_curvature() -> Outcome {
    let curved = Noise { method: NoiseMethod::Curvature, ..Noise::default() };
    for (noise, says) in [
        (Noise { fold: NoiseFold::Ridged, ..curved }, "folded noise has the method `Gradient`"),
        (Noise { basis: NoiseBasis::PerlinSolid, ..curved }, "noise by its `Curvature` is of the plane"),
    ] {
        let scene = Scene::new("rock").texture(named("terrain")?).driver(Driver::Noise(noise));
        let error = scene.module().unwrap_err().to_string();
        assert!(error.contains(says), "`{error}` does not say `{says}`");
    }
    Ok(())
}
