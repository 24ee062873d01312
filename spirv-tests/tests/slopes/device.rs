//! Question 2: moments, areas and probabilities of visible slopes on the device against quadrature.

use std::f64::consts::TAU;

use prefilter::gpu::Device;
use prefilter::reference::slopes::standard::{moments, weight};
use prefilter::reference::slopes::Visible;
use spirv_tests::kernel::Function;

use crate::{direction, single, Random};

type Outcome = Result<(), String>;

/// Runs the function `asked` of a text that mentions the shelf.
pub fn run(text: &str, points: &[Vec<f64>]) -> Result<Vec<Vec<f64>>, String> {
    let device = Device::new().map_err(|error| error.to_string())?;
    let results = Function::in_text(text, "asked")?.results(&device, &[], points)?;
    assert!(!points.is_empty() && results.len() == points.len());
    Ok(results)
}

/// The larger of two errors; a NaN is larger than everything.
pub fn worse(worst: f64, error: f64) -> f64 {
    if error.is_nan() {
        f64::INFINITY
    } else {
        worst.max(error)
    }
}

#[test]
fn the_standard_form_keeps_its_digits() -> Outcome {
    let text = "fn asked(parameter: f32) -> vec3f {
        return vec3f(slopes_moments(parameter), slopes_tail(abs(parameter)).z);
    }";
    let points: Vec<Vec<f64>> = (-12_000..=12_000).map(|index| single([1e-3 * f64::from(index)]).to_vec()).collect();
    // Below the horizon to 6 deviations, to 12, above.
    let mut worst = [[0.0; 3]; 3];
    for (point, got) in points.iter().zip(run(text, &points)?) {
        let a = point[0];
        let [mean, variance, _] = moments(a);
        let part = if a < -6.0 { 1 } else { usize::from(a >= 0.0) * 2 };
        for (worst, (got, truth)) in worst[part].iter_mut().zip(got.iter().zip([mean, variance, weight(-a.abs())])) {
            *worst = worse(*worst, (got / truth - 1.0).abs());
        }
    }
    for (name, [mean, variance, weight]) in ["a in [-6, 0)", "below", "above"].iter().zip(worst) {
        println!("{name}: of itself, mean {mean:.1e}, variance {variance:.1e}, weight {weight:.1e}");
    }
    // What the documentation of `slopes_tail` says.
    assert!(worst.iter().all(|part| part[0] <= 1.2e-6 && part[1] <= 5e-6), "{worst:?}");
    assert!(worst[0][2] <= 1e-5, "{worst:?}");
    // Φ/Ψ and 2 − R (R + a) as they stand: no variance is left.
    let naive = "fn asked(parameter: f32) -> vec2f {
        let density = 0.3989422804 * exp(-0.5 * parameter * parameter);
        let mean = normal_cdf(parameter) / (density + parameter * normal_cdf(parameter));
        return vec2f(mean, 2.0 - mean * (mean + parameter));
    }";
    let below: Vec<Vec<f64>> = points.iter().filter(|point| point[0] < -3.0 && point[0] > -4.0).cloned().collect();
    let negative = run(naive, &below)?.iter().filter(|got| !(got[1] >= 0.0)).count();
    println!("without the rational: {negative} of {} variances are negative for a in (-4, -3)", below.len());
    assert!(negative > below.len() / 10, "{negative}");
    Ok(())
}

/// What a map by slope needs of one view.
const CHAIN: &str = "
struct chain { mean: vec2f, covariance: vec3f, area: f32 }
fn asked(view: vec3f, covariance: vec3f, mean_slope: vec2f) -> chain {
    let factor = slopes_factor(view, covariance);
    let moments = slopes_moments(slopes_parameter(view, mean_slope, factor));
    let mean = mean_slope + moments.x * factor.xy;
    return chain(mean, slopes_covariance(factor, moments.y), slopes_area(view, mean_slope, factor));
}";

/// Errors in the deviations of the visible slopes: of the mean, of the covariance, and of the area of itself.
fn whitened(visible: &Visible, got: &[f64]) -> [f64; 3] {
    let (mean, [xx, xy, yy]) = visible.moments();
    // The inverse of the Cholesky factor, (p, 0; q, r).
    let p = 1.0 / xx.sqrt();
    let r = 1.0 / (yy - xy * xy / xx).sqrt();
    let q = -xy / xx * r;
    let [x, y] = [got[0] - mean[0], got[1] - mean[1]];
    let [a, b, c] = [got[2] - xx, got[3] - xy, got[4] - yy];
    let both = [p * p * a, p * (q * a + r * b), q * q * a + 2.0 * q * r * b + r * r * c];
    let covariance = both.into_iter().fold(0.0, |most, value| worse(most, value.abs()));
    let area = visible.reach() * weight(visible.parameter());
    [worse((p * x).abs(), (q * x + r * y).abs()), covariance, (got[5] / area - 1.0).abs()]
}

/// The 99.9th percentiles and the largest of the errors of 30 000 views, at least some of whose area is in the picture.
fn errors(name: &str, mut view: impl FnMut() -> Visible) -> Result<[[f64; 2]; 3], String> {
    let views = std::iter::repeat_with(&mut view).filter(|visible| visible.parameter() > -9.0);
    let views: Vec<Visible> = views.take(30_000).collect();
    let point = |visible: &Visible| [&visible.view[..], &visible.covariance, &visible.mean].concat();
    let points: Vec<Vec<f64>> = views.iter().map(point).collect();
    let mut errors = [const { Vec::new() }; 3];
    for (visible, got) in views.iter().zip(run(CHAIN, &points)?) {
        for (errors, error) in errors.iter_mut().zip(whitened(visible, &got)) {
            errors.push(worse(0.0, error));
        }
    }
    let found = errors.map(|mut errors| {
        errors.sort_by(f64::total_cmp);
        [errors[errors.len() - errors.len() / 1000], errors[errors.len() - 1]]
    });
    for (what, [most, worst]) in ["mean", "covariance", "area"].iter().zip(found) {
        println!("{name}: {what} {most:.1e}, at worst {worst:.1e}");
    }
    Ok(found)
}

fn covariance(random: &mut Random, least: f64, most: f64, correlation: f64) -> [f64; 3] {
    let [x, y] = [random.between(least, most), random.between(least, most)];
    single([x * x, correlation * (2.0 * random.unit() - 1.0) * x * y, y * y])
}

fn tilt(random: &mut Random, most: f64) -> [f64; 2] {
    single([most * (2.0 * random.unit() - 1.0), most * (2.0 * random.unit() - 1.0)])
}

#[test]
fn moments_of_views_keep_their_figures() -> Outcome {
    let mut random = Random::new(11);
    let generic = errors("generic", || Visible {
        view: direction(random.unit(), TAU * random.unit()),
        covariance: covariance(&mut random, 0.05, 1.5, 0.9),
        mean: tilt(&mut random, 0.5),
    })?;
    let grazing = errors("grazing", || Visible {
        view: direction(random.between(1e-5, 0.1), TAU * random.unit()),
        covariance: covariance(&mut random, 0.05, 1.5, 0.9),
        mean: tilt(&mut random, 0.3),
    })?;
    let below = errors("below the horizon", || Visible {
        view: direction(-random.unit(), TAU * random.unit()),
        covariance: covariance(&mut random, 0.05, 1.5, 0.9),
        mean: tilt(&mut random, 0.5),
    })?;
    for class in [generic, grazing, below] {
        assert!(class[0][0] <= 2e-5 && class[1][0] <= 2e-5 && class[2][0] <= 3e-5, "{class:?}");
    }
    let ridges = errors("anisotropic 1000:1", || {
        let [long, short] = [random.between(0.05, 1.5), 1e-3];
        let variances = random.pick([[long * long, short * short * long * long], [short * short, 1.0]]);
        Visible {
            view: direction(random.unit(), TAU * random.unit()),
            covariance: single([variances[0], 0.0, variances[1]]),
            mean: [0.0; 2],
        }
    })?;
    assert!(ridges[0][0] <= 1e-4 && ridges[1][0] <= 1e-5, "{ridges:?}");
    Ok(())
}
