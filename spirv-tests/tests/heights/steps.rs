//! The largest error of a step, which bounds that of any map, by each form of the distribution of visible heights.

use prefilter::reference::heights::{cumulative, moments, perturbed_cumulative};

use crate::device::{f32s, run, worse};
use crate::lambdas;

type Outcome = Result<(), String>;

/// The probability below a height by the paper's moments, by ours in both grades, and by the mixture.
const FORMS: &str = "
fn below(height: f32, lambda: f32) -> vec4f {
    let paper = heights_moments_paper(lambda);
    let fast = heights_moments_fast(lambda);
    let fine = heights_moments(lambda);
    let pair = heights_mixture(lambda);
    let mixed = 0.375 * normal_cdf((height - pair.x) / pair.y) + 0.625 * normal_cdf((height - pair.z) / pair.w);
    return vec4f(
        normal_cdf((height - paper.x) / paper.y),
        normal_cdf((height - fast.x) / fast.y),
        normal_cdf((height - fine.x) / fine.y),
        mixed,
    );
}";

/// Worst step errors of the four forms over a range of Λ.
fn worst(low: f64, high: f64) -> Result<[f64; 4], String> {
    let mut points = Vec::new();
    for lambda in [0.0].into_iter().chain(lambdas(low, high, 241)) {
        let [mean, deviation, ..] = moments(lambda);
        points.extend((-250..=250).map(|index| f32s([mean + 0.02 * f64::from(index) * deviation, lambda])));
    }
    let mut worst = [0.0; 4];
    for (point, got) in points.iter().zip(run(FORMS, "below", &points)?) {
        let truth = cumulative(point[0], point[1]);
        for (worst, got) in worst.iter_mut().zip(got) {
            *worst = worse(*worst, (got - truth).abs());
        }
    }
    for (form, worst) in ["paper", "fast", "fine", "mixture"].iter().zip(worst) {
        println!("lambda in [{low}, {high}], {form}: a step is off by {worst:.2e}");
    }
    Ok(worst)
}

#[test]
fn steps_keep_their_figures() -> Outcome {
    let [paper, fast, fine, mixture] = worst(1e-3, 100.0)?;
    // numerics/height.md, section 3.1: 9.1e-2.
    assert!((paper - 0.091).abs() < 1e-3, "{paper}");
    assert!(fine <= 4.5e-2 && fast <= 4.5e-2, "{fine} {fast}");
    assert!(mixture <= 6e-3, "{mixture}");
    let [paper, fast, fine, mixture] = worst(100.0, 1e4)?;
    assert!(paper > 0.4 && fine <= 5.7e-2 && fast <= 5.8e-2 && mixture <= 9e-3, "{paper} {fast} {fine} {mixture}");
    Ok(())
}

/// The mixture takes noise exactly: each of its distributions adds the noise's variance.
const PERTURBED: &str = "
fn below(height: f32, lambda: f32, noise_deviation: f32) -> f32 {
    let pair = heights_mixture(lambda);
    let high = heights_perturbed(vec3f(pair.xy, 0.0), 0.0, 1.0, 0.0, noise_deviation);
    let low = heights_perturbed(vec3f(pair.zw, 0.0), 0.0, 1.0, 0.0, noise_deviation);
    return 0.375 * normal_cdf((height - high.x) / high.y) + 0.625 * normal_cdf((height - low.x) / low.y);
}";

#[test]
fn noise_does_not_harm_the_mixture() -> Outcome {
    let mut points = Vec::new();
    for lambda in lambdas(1e-2, 100.0, 25) {
        for noise in [0.02, 0.1, 0.3, 1.0] {
            points.extend((-30..=50).map(|index| f32s([0.1 * f64::from(index), lambda, noise])));
        }
    }
    let error =
        |(point, got): (&Vec<f64>, Vec<f64>)| (got[0] - perturbed_cumulative(point[0], point[1], point[2])).abs();
    let worst = points.iter().zip(run(PERTURBED, "below", &points)?).map(error).fold(0.0, worse);
    println!("step error of the mixture with noise: {worst:.2e}");
    assert!(worst <= 6e-3, "{worst}");
    Ok(())
}

/// Mean and variance of the mixture are those of the moments, to rounding.
#[test]
fn the_mixture_keeps_mean_and_deviation() -> Outcome {
    const TEXT: &str = "
fn both(lambda: f32) -> vec4f {
    let pair = heights_mixture(lambda);
    let own = heights_moments(lambda);
    let mean = 0.375 * pair.x + 0.625 * pair.z;
    let high = vec2f(pair.x - mean, pair.y);
    let low = vec2f(pair.z - mean, pair.w);
    return vec4f(mean, sqrt(0.375 * dot(high, high) + 0.625 * dot(low, low)), own.xy);
}";
    let points: Vec<Vec<f64>> = [0.0].into_iter().chain(lambdas(1e-6, 1e6, 5000)).map(|l| f32s([l])).collect();
    for (point, got) in points.iter().zip(run(TEXT, "both", &points)?) {
        assert!((got[0] - got[2]).abs() <= 6e-7 && (got[1] - got[3]).abs() <= 4e-7, "{point:?}: {got:?}");
    }
    Ok(())
}
