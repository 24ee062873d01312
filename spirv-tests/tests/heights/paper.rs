//! What the paper says of visible heights, and what is so. No device: the fits in 64 bits.

use prefilter::reference::heights::{cumulative, moments};
use prefilter::reference::normal::cumulative as normal_cumulative;

use crate::lambdas;

/// Equations 16 and 17 with the printed constants and a logarithm.
fn fits(lambda: f64, logarithm: fn(f64) -> f64) -> [f64; 2] {
    [0.39 * logarithm(4.75 * lambda + 1.0), 1.0 / (1.0 + 0.26 * logarithm(1.13 * lambda + 1.0))]
}

/// The largest errors of mean and deviation for Λ up to 100.
fn errors(logarithm: fn(f64) -> f64) -> [f64; 2] {
    lambdas(1e-4, 100.0, 2000).fold([0.0; 2], |worst: [f64; 2], lambda| {
        let ([mean, deviation, ..], fit) = (moments(lambda), fits(lambda, logarithm));
        [worst[0].max((fit[0] - mean).abs()), worst[1].max((fit[1] - deviation).abs())]
    })
}

/// The paper does not say which logarithm it means: only the natural one is near.
#[test]
fn the_logarithm_is_the_natural_one() {
    for (logarithm, known) in
        [(f64::ln as fn(f64) -> f64, [0.131, 0.028]), (f64::log2, [0.96, 0.069]), (f64::log10, [1.47, 0.22])]
    {
        let found = errors(logarithm);
        println!("largest errors of mean and deviation: {found:.3?}");
        assert!((0..2).all(|index| (found[index] / known[index] - 1.0).abs() < 0.03), "{found:?} {known:?}");
    }
}

/// Λ with the errors of the paper's mean and deviation and of a step by its normal distribution.
///
/// Source: numerics/height.md, section 1.
const ERRORS: [[f64; 4]; 10] = [
    [0.1, 0.0668, 0.0006, 0.0287],
    [0.3, 0.1180, 0.0026, 0.0543],
    [1.0, 0.1180, 0.0101, 0.0662],
    [3.0, 0.0332, 0.0210, 0.0379],
    [10.0, -0.0726, 0.0279, 0.0488],
    [30.0, -0.1196, 0.0262, 0.0844],
    [100.0, -0.1066, 0.0192, 0.0870],
    [1e3, 0.0601, 0.0023, 0.1195],
    [1e4, 0.3481, -0.0123, 0.4827],
    [1e6, 1.1328, -0.0317, f64::NAN],
];

/// The largest error of a step when the visible heights are taken for normal.
fn step_error(lambda: f64, mean: f64, deviation: f64) -> f64 {
    let error = |height: f64| (normal_cumulative((height - mean) / deviation) - cumulative(height, lambda)).abs();
    (-3000..=3000).map(|index| error(moments(lambda)[0] + 1e-3 * f64::from(index))).fold(0.0, f64::max)
}

/// The printed constants are those whose errors the notes measured: a garbled digit would show.
#[test]
fn the_constants_have_the_errors_that_the_notes_print() {
    for [lambda, by_mean, by_deviation, by_step] in ERRORS {
        let ([mean, deviation, ..], fit) = (moments(lambda), fits(lambda, f64::ln));
        assert!((fit[0] - mean - by_mean).abs() < 6e-5, "{lambda}: {}", fit[0] - mean);
        assert!((fit[1] - deviation - by_deviation).abs() < 6e-5, "{lambda}: {}", fit[1] - deviation);
        if by_step.is_finite() {
            let found = step_error(lambda, fit[0], fit[1]);
            assert!((found - by_step).abs() < 1e-4, "{lambda}: {found}");
        }
    }
}

/// Twice too steep where nothing is hidden yet, which is where most pixels are.
#[test]
fn the_mean_rises_twice_too_fast_at_first() {
    let slope = |mean: f64| mean / 1e-7;
    assert!((slope(fits(1e-7, f64::ln)[0]) / 1.8525 - 1.0).abs() < 1e-4);
    assert!((slope(moments(1e-7)[0]) / 0.903_197 - 1.0).abs() < 1e-4);
}

/// Equation 17 sets σ_d² equal to the raw second moment: at Λ = 1 that is 1 exactly, the fit gives .836, and the
/// deviation about the mean is .826.
#[test]
fn equation_seventeen_is_the_deviation_about_the_mean() {
    for (lambda, raw) in [(1.0, 1.0), (10.0, 1.688), (100.0, 2.548)] {
        let [mean, deviation, ..] = moments(lambda);
        let found = (mean * mean + deviation * deviation).sqrt();
        assert!((found - raw).abs() < 5e-4, "{lambda}: {found}");
        let fit = fits(lambda, f64::ln)[1];
        assert!((fit - deviation).abs() < 0.03 && (fit - found).abs() > 0.15, "{lambda}: {fit}");
    }
}

/// "At grazing angles the distribution is still well approximated by a Gaussian": the larger Λ, the less. With the
/// exact moments a step is off by 4.4e-2 at Λ = 100 and by 6.1e-2 at 1e6, on the way to the Gumbel distribution's
/// 7.1e-2.
#[test]
fn no_gaussian_is_close_at_grazing_angles() {
    let mut last = 0.0;
    for (lambda, known) in
        [(0.1, 0.0013), (1.0, 0.0094), (10.0, 0.0286), (100.0, 0.0437), (1e3, 0.0518), (1e4, 0.0563), (1e6, 0.0610)]
    {
        let [mean, deviation, ..] = moments(lambda);
        let found = step_error(lambda, mean, deviation);
        assert!((found - known).abs() < 1e-4 && found > last, "{lambda}: {found}");
        last = found;
    }
    let (mean, deviation) = (0.577_215_664_901_532_9, std::f64::consts::PI / 6f64.sqrt());
    let gumbel = |x: f64| (-(-x).exp()).exp();
    let error = |x: f64| (gumbel(x) - normal_cumulative((x - mean) / deviation)).abs();
    let limit = (-5000..=10_000).map(|index| error(1e-3 * f64::from(index))).fold(0.0, f64::max);
    assert!((limit - 0.0707).abs() < 1e-4 && limit > last, "{limit}");
}
