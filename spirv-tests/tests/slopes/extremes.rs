//! Whatever the view and the slopes: finite numbers, covariances that stay positive, continuity where the form changes.

use std::f64::consts::TAU;

use spirv_tests::any;

use crate::device::run;
use crate::{direction, single, Random};

type Outcome = Result<(), String>;

/// Points at a time.
const BATCH: usize = 200_000;

const CHAIN: &str = "
struct chain { factor: vec4f, one: vec2f, two: vec4f, mean: vec2f, whole: vec3f, low: vec3f, high: vec3f, along: vec2f,
    parameter: f32, area: f32, skewness: f32 }
fn asked(view: vec3f, covariance: vec3f, mean_slope: vec2f, direction: vec2f) -> chain {
    let factor = slopes_factor(view, covariance);
    let parameter = slopes_parameter(view, mean_slope, factor);
    let one = slopes_moments(parameter);
    let two = slopes_pair(parameter);
    return chain(factor, one, two, mean_slope + one.x * factor.xy, slopes_covariance(factor, one.y),
        slopes_covariance(factor, two.y), slopes_covariance(factor, two.w),
        slopes_along(direction, mean_slope, factor, one.x, one.y), parameter,
        slopes_area(view, mean_slope, factor), slopes_skewness(parameter));
}";

/// A variance: none, subnormal, small, usual, huge, the largest number, infinite, negative.
fn any_variance(random: &mut Random) -> f64 {
    let usual = random.between(1e-6, 4.0);
    let wide = random.between(1e-38, 3e38);
    random.pick([0.0, 1e-45, 1e-40, wide, wide, usual, usual, usual, usual, f64::from(f32::MAX), f64::INFINITY, -usual])
}

/// Covariances of any correlation, beyond what one can be, and next to singular; one of eight follows the view.
fn any_covariance(random: &mut Random, view: [f64; 3]) -> [f64; 3] {
    let [xx, yy] = [any_variance(random), any_variance(random)];
    let xx = random.pick([xx, xx, yy]);
    let even = 2.0 * random.unit() - 1.0;
    let correlation = random.pick([-1.0, 0.0, 1.0, even, even, 1.0 - 1e-7, 1e-7 - 1.0, 2.0, -1e30]);
    let xy = xx.abs().sqrt() * yy.abs().sqrt() * correlation;
    // All slopes across the view, or along it, but for rounding.
    let [x, y] = random.pick([[view[0], view[1]], [-view[1], view[0]]]);
    if random.word().is_multiple_of(8) {
        return single([x * x, x * y, y * y]);
    }
    single([xx, if xy.is_nan() { 0.0 } else { xy }, yy])
}

fn any_slope(random: &mut Random) -> [f64; 2] {
    let size = random.pick([0.0, 0.0, 0.0, 0.0, 1e-45, 1e-20, 0.5, 0.5, 10.0, 1e18, 1e30]);
    single([size * (2.0 * random.unit() - 1.0), size * (2.0 * random.unit() - 1.0)])
}

fn any_point(random: &mut Random) -> Vec<f64> {
    let view = any::direction(random);
    let turn = TAU * random.unit();
    let covariance = any_covariance(random, view);
    [&view[..], &covariance, &any_slope(random), &single([turn.cos(), turn.sin()])].concat()
}

/// Rounding of three products, down to the smallest normal number, is all that a determinant may lose.
fn is_positive(covariance: &[f64]) -> bool {
    let &[xx, xy, yy] = covariance else { return false };
    let least = f64::from(f32::MIN_POSITIVE);
    xx >= 0.0 && yy >= 0.0 && xy * xy <= (xx + least) * (yy + least) * (1.0 + 4e-7)
}

/// Draws the given number of points and counts those below the horizon and those with some area.
fn judge(seed: u32, count: usize) -> Result<[usize; 2], String> {
    let mut random = Random::new(seed);
    let points: Vec<Vec<f64>> = (0..count).map(|_| any_point(&mut random)).collect();
    let mut counts = [0; 2];
    for (point, got) in points.iter().zip(run(CHAIN, &points)?) {
        assert!(got.iter().all(|value| value.is_finite()), "{point:?}: {got:?}");
        let (one, two, parameter, area, skewness) = (&got[4..6], &got[6..10], got[23], got[24], got[25]);
        assert!(one[0] >= 0.0 && one[0] < 12.2 && one[1] > 0.0 && one[1] < 1.000_001, "{point:?}: {one:?}");
        assert!(two[1] > 0.0 && two[3] >= two[1] && two[3] < 1.000_001 && two[2] >= two[0], "{point:?}: {two:?}");
        for covariance in [&got[12..15], &got[15..18], &got[18..21]] {
            assert!(is_positive(covariance), "{point:?}: {covariance:?}");
        }
        assert!(parameter >= -12.0 && area >= 0.0 && got[22] >= 0.0, "{point:?}: {got:?}");
        assert!((-1e-5..1.415).contains(&skewness), "{point:?}: {skewness}");
        // The trace is that of all slopes.
        let trace: f64 = [point[3], point[5]].map(|variance| variance.clamp(0.0, 1e18)).iter().sum();
        let found: f64 = got[..4].iter().map(|part| part * part).sum();
        assert!(found <= 2.0 * trace * (1.0 + 1e-5) + 1e-30, "{point:?}: {found} of {trace}");
        counts[0] += usize::from(parameter < 0.0);
        counts[1] += usize::from(area > 0.0);
    }
    Ok(counts)
}

#[test]
fn extreme_inputs_give_finite_slopes() -> Outcome {
    for seed in 1..=any::inputs(1_000_000) / BATCH {
        let [below, some] = judge(seed as u32, BATCH)?;
        assert!(below > 20_000 && some > 100_000, "{below}, {some}");
    }
    Ok(())
}

/// Scaled as a whole: a limit on each number by itself would turn any correlation into 1.
#[test]
fn huge_slopes_keep_their_shape() -> Outcome {
    for size in [1.0, 1e18, 1e20, 1e26, 3e38] {
        let got = run(
            CHAIN,
            &[[&[0.48, -0.36, 0.8][..], &single([size, -0.2 * size, 0.5 * size]), &[0.1, 0.2, 1.0, 0.0]].concat()],
        )?;
        let [ex, ey, fx, fy] = [0, 1, 2, 3].map(|part| got[0][part]);
        let [xx, xy, yy] = [ex * ex + fx * fx, ex * ey + fx * fy, ey * ey + fy * fy];
        assert!((xy / xx + 0.2).abs() <= 1e-6 && (yy / xx - 0.5).abs() <= 1e-6, "{size:e}: {xx:e}, {xy:e}, {yy:e}");
    }
    Ok(())
}

fn one(view: [f64; 3], covariance: [f64; 3], mean_slope: [f64; 2]) -> Result<Vec<f64>, String> {
    let point = [&view[..], &single(covariance), &single(mean_slope), &[1.0, 0.0]].concat();
    Ok(run(CHAIN, &[point])?.remove(0))
}

#[test]
fn what_needs_no_filter_gets_none() -> Outcome {
    // Along the normal all slopes weigh the same.
    let got = one([0.0, 0.0, 1.0], [0.25, -0.125, 0.5], [0.5, -1.0])?;
    assert!(got[4] < 2e-18 && got[5] == 1.0, "{got:?}");
    assert_eq!((&got[10..12], got[24]), (&[0.5, -1.0][..], 1.0), "{got:?}");
    for (found, all) in got[12..15].iter().zip([0.25, -0.125, 0.5]) {
        assert!((found - all).abs() <= 1e-7, "{got:?}");
    }
    // A flat surface has one slope; what is seen of it is its foreshortened area, and nothing from below.
    for z in [1e-6, 0.3, 0.9] {
        let view = direction(z, 0.7);
        let got = one(view, [0.0; 3], [0.0; 2])?;
        assert_eq!((&got[10..12], &got[12..15], got[24]), (&[0.0; 2][..], &[0.0; 3][..], view[2]), "{got:?}");
        let got = one(direction(-z, 0.7), [0.0; 3], [0.0; 2])?;
        assert_eq!((&got[10..12], got[24]), (&[0.0; 2][..], 0.0), "{got:?}");
    }
    // Its slope is the mean slope, whose foreshortened area is that of its facet.
    let got = one([0.6, 0.0, 0.8], [0.0; 3], [0.5, 0.0])?;
    assert!((got[24] - 0.5).abs() < 1e-7 && got[10..12] == [0.5, 0.0], "{got:?}");
    // Slopes across the view weigh the same, whatever they are.
    let got = one([0.96, 0.0, 0.28], [0.0, 0.0, 0.25], [0.1, 0.2])?;
    assert!((got[11] - 0.2).abs() < 1e-7 && (got[14] - 0.25).abs() < 1e-7 && got[10] == f64::from(0.1f32), "{got:?}");
    Ok(())
}

/// From step to step of one thousandth of a deviation no moment jumps, at the horizon, at the lowest parameter, beyond.
#[test]
fn moments_are_continuous() -> Outcome {
    let points: Vec<Vec<f64>> = (-16_000..=16_000).map(|index| vec![f64::from(index) / 1024.0]).collect();
    let text = "struct all { moments: vec2f, pair: vec4f, skewness: f32 }
    fn asked(parameter: f32) -> all {
        return all(slopes_moments(parameter), slopes_pair(parameter), slopes_skewness(parameter));
    }";
    let got = run(text, &points)?;
    for (point, pair) in points.iter().zip(got.windows(2)) {
        for (before, after) in pair[0].iter().zip(&pair[1]) {
            assert!((after - before).abs() < 1.5e-3, "{point:?}: {pair:?}");
        }
        assert!(pair[1][0] <= pair[0][0] + 3e-6 && pair[1][1] >= pair[0][1] - 3e-6, "{point:?}: {pair:?}");
    }
    Ok(())
}
