//! The largest error of a step, which bounds that of any map, by each form of the distribution of visible heights.

use prefilter::reference::heights::{cumulative, moments, perturbed_cumulative};

use crate::device::{f32s, run, worse};
use crate::lambdas;

type Outcome = Result<(), String>;

/// The probability below a height by the paper's moments, by ours in both grades, and by the tails.
const FORMS: &str = "
fn below(height: f32, lambda: f32) -> vec4f {
    let paper = heights_moments_paper(lambda);
    let fast = heights_moments_fast(lambda);
    let fine = heights_moments(lambda);
    let tails = height_skewed(fine.y, fine.z);
    return vec4f(
        normal_cdf((height - paper.x) / paper.y),
        normal_cdf((height - fast.x) / fast.y),
        normal_cdf((height - fine.x) / fine.y),
        1.0 - height_step(fine.x - height, tails),
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
    for (form, worst) in ["paper", "fast", "fine", "tails"].iter().zip(worst) {
        println!("lambda in [{low}, {high}], {form}: a step is off by {worst:.2e}");
    }
    Ok(worst)
}

#[test]
fn steps_keep_their_figures() -> Outcome {
    let [paper, fast, fine, tails] = worst(1e-3, 100.0)?;
    // numerics/height.md, section 3.1: 9.1e-2.
    assert!((paper - 0.091).abs() < 1e-3, "{paper}");
    assert!(fine <= 4.5e-2 && fast <= 4.5e-2, "{fine} {fast}");
    assert!(tails <= 2.6e-4, "{tails}");
    let [paper, fast, fine, tails] = worst(100.0, 1e4)?;
    assert!(paper > 0.4 && fine <= 5.7e-2 && fast <= 5.8e-2 && tails <= 3.3e-4, "{paper} {fast} {fine} {tails}");
    Ok(())
}

/// The probability by the shorter tails, which noise does not move.
const SHORT: &str = "
fn below(height: f32, lambda: f32, noise_deviation: f32) -> f32 {
    let visible = heights_perturbed(heights_moments(lambda), 0.0, 1.0, 0.0, noise_deviation);
    return 1.0 - tails_step(visible.x - height, tails_skewed(visible.y, visible.z));
}";

#[test]
fn steps_of_shorter_tails_keep_their_figures() -> Outcome {
    let noisy = [0.02, 0.05, 0.1, 0.107, 0.14, 0.2, 0.3, 0.5, 1.0].as_slice();
    for (noises, figure) in [([0.0].as_slice(), 1.65e-3), (noisy, 5.2e-3)] {
        let mut points = Vec::new();
        for lambda in lambdas(1e-3, 1e4, 121) {
            let [mean, deviation, ..] = moments(lambda);
            for noise in noises {
                let wide = deviation.hypot(*noise);
                points.extend((-60..=60).map(|index| f32s([mean + 0.1 * f64::from(index) * wide, lambda, *noise])));
            }
        }
        let truth = |point: &[f64]| match point[2] {
            0.0 => cumulative(point[0], point[1]),
            noise => perturbed_cumulative(point[0], point[1], noise),
        };
        let errors = points.iter().zip(run(SHORT, "below", &points)?).map(|(point, got)| (got[0] - truth(point)).abs());
        let worst = errors.fold(0.0, worse);
        println!("shorter tails, noise of {noises:?}: a step is off by {worst:.2e}");
        assert!(worst <= figure && 1.03 * worst >= figure, "{worst}");
    }
    Ok(())
}

/// Tails of the moments of heights with noise.
const PERTURBED: &str = "
fn below(height: f32, lambda: f32, noise_deviation: f32) -> f32 {
    let visible = heights_perturbed(heights_moments(lambda), 0.0, 1.0, 0.0, noise_deviation);
    return 1.0 - height_step(visible.x - height, perturbed_tails(visible.y, visible.z, noise_deviation));
}";

/// Noise takes visible heights out of the family that the tails are fitted to, and the tails after them.
#[test]
fn steps_keep_their_figures_with_noise() -> Outcome {
    for (low, high, figure) in [(1e-2, 1.0, 4e-4), (1.0, 10.0, 6e-4), (10.0, 100.0, 7e-4), (100.0, 1e4, 8.8e-4)] {
        let mut points = Vec::new();
        for lambda in lambdas(low, high, 13) {
            for noise in [0.02, 0.05, 0.1, 0.107, 0.14, 0.2, 0.3, 0.5, 1.0] {
                points.extend((-40..=80).map(|index| f32s([0.08 * f64::from(index), lambda, noise])));
            }
        }
        let error =
            |(point, got): (&Vec<f64>, Vec<f64>)| (got[0] - perturbed_cumulative(point[0], point[1], point[2])).abs();
        let worst = points.iter().zip(run(PERTURBED, "below", &points)?).map(error).fold(0.0, worse);
        println!("lambda in [{low}, {high}], with noise: a step is off by {worst:.2e}");
        assert!(worst <= figure && worst > 0.7 * figure, "{worst}");
    }
    Ok(())
}
