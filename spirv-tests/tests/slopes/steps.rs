//! The largest error of a step, which bounds that of any map of one component, by one and by two normal distributions.

use std::f64::consts::TAU;

use prefilter::reference::slopes::standard::{cumulative, moments};

use crate::device::{run, worse};
use crate::{any, Random};

type Outcome = Result<(), String>;

/// The probability of u below an edge by one normal distribution and by the pair.
const STANDARD: &str = "
fn asked(edge: f32, parameter: f32) -> vec2f {
    let one = slopes_moments(parameter);
    let two = slopes_pair(parameter);
    let pair = 0.5 * normal_cdf((edge - two.x) * inverseSqrt(two.y))
        + 0.5 * normal_cdf((edge - two.z) * inverseSqrt(two.w));
    return vec2f(normal_cdf((edge - one.x) * inverseSqrt(one.y)), pair);
}";

/// Worst step errors of both over parameters.
fn worst(parameters: impl Iterator<Item = f64>) -> Result<[f64; 2], String> {
    let (mut points, mut truths) = (Vec::new(), Vec::new());
    for parameter in parameters {
        let parameter = f64::from(parameter as f32);
        let [mean, variance, _] = moments(parameter);
        let edge = |index: i32| f64::from((mean + 0.01 * f64::from(index) * variance.sqrt()) as f32);
        let edges: Vec<f64> = (-400..=600).map(edge).collect();
        truths.extend(cumulative(parameter, &edges));
        points.extend(edges.into_iter().map(|edge| vec![edge, parameter]));
    }
    let mut worst = [0.0; 2];
    for (truth, got) in truths.into_iter().zip(run(STANDARD, &points)?) {
        for (worst, got) in worst.iter_mut().zip(got) {
            *worst = worse(*worst, (got - truth).abs());
        }
    }
    Ok(worst)
}

fn steps(from: f64, to: f64) -> Result<[f64; 2], String> {
    let [one, two] = worst((0..=200).map(|step| from + (to - from) * f64::from(step) / 200.0))?;
    println!("a in [{from}, {to}]: a step is off by {one:.2e} by one normal distribution, by two {two:.2e}");
    Ok([one, two])
}

#[test]
fn steps_keep_their_figures() -> Outcome {
    let [one, two] = steps(0.0, 12.0)?;
    assert!(one <= 0.047 && two <= 0.0125, "{one} {two}");
    let [one, two] = steps(-3.0, 0.0)?;
    assert!(one <= 0.085 && two <= 0.025, "{one} {two}");
    let [one, two] = steps(-12.0, -3.0)?;
    assert!(one <= 0.1 && two <= 0.031, "{one} {two}");
    // From `slopes_single` on one is enough, and what two become; below it is not.
    let [one, two] = steps(3.0, 40.0)?;
    assert!(one <= 5.1e-3 && two <= 5.1e-3, "{one} {two}");
    let [one, two] = steps(2.0, 3.0)?;
    assert!(one > 0.01 && two <= 6.5e-3, "{one} {two}");
    Ok(())
}

/// Numbers of the notes, section 3: the parameter, and the errors of one and of two normal distributions. From 2 on
/// ours become one, where theirs are within 2.7e-3: no color jumps where a module takes one.
const KNOWN: [[f64; 3]; 7] = [
    [-3.0, 0.080, 0.022],
    [-1.0, 0.062, 0.016],
    [0.0, 0.0465, 0.0118],
    [0.5, 0.037, 0.0094],
    [1.0, 0.028, 0.0069],
    [1.5, 0.020, 0.0044],
    [2.0, 0.013, 0.0027],
];

#[test]
fn the_coefficients_have_the_errors_that_the_notes_print() -> Outcome {
    for [parameter, one, two] in KNOWN {
        let found = worst([parameter].into_iter())?;
        assert!((found[0] / one - 1.0).abs() < 0.03, "{parameter}: {found:?}");
        assert!((found[1] - two).abs() < 6e-5 + 0.006 * two, "{parameter}: {found:?}");
    }
    Ok(())
}

/// The probability that the component along a direction is below an edge, through the whole chain.
const CHAIN: &str = "
fn side(edge: f32, component: vec2f) -> f32 {
    return normal_cdf((edge - component.x) / max(component.y, 1e-6));
}
fn asked(view: vec3f, covariance: vec3f, mean_slope: vec2f, direction: vec2f, edge: f32) -> vec4f {
    let factor = slopes_factor(view, covariance);
    let parameter = slopes_parameter(view, mean_slope, factor);
    let one = slopes_moments(parameter);
    let two = slopes_pair(parameter);
    let single = side(edge, slopes_along(direction, mean_slope, factor, one.x, one.y));
    let low = side(edge, slopes_along(direction, mean_slope, factor, two.x, two.y));
    let high = side(edge, slopes_along(direction, mean_slope, factor, two.z, two.w));
    let all = side(edge, slopes_along(direction, mean_slope, factor, 0.0, 1.0));
    return vec4f(single, 0.5 * (low + high), all, parameter);
}";

#[test]
fn steps_along_any_direction_are_no_worse() -> Outcome {
    let mut random = Random::new(21);
    let (mut points, mut truths) = (Vec::new(), Vec::new());
    while truths.len() < 40_000 {
        let visible = any(&mut random);
        if visible.parameter() < 0.0 {
            continue;
        }
        let angle = random.pick([0.0, 0.1, 1.0, 1.57]) + TAU * random.unit();
        let toward = crate::single([angle.cos(), angle.sin()]);
        let [mean, deviation, _] = visible.moments_along(toward);
        for _ in 0..4 {
            let edge = f64::from((mean + deviation * (6.0 * random.unit() - 3.0)) as f32);
            points.push([&visible.view[..], &visible.covariance, &visible.mean, &toward, &[edge]].concat());
            truths.push(visible.below(toward, edge));
        }
    }
    let mut worst = [0.0; 3];
    for (truth, got) in truths.into_iter().zip(run(CHAIN, &points)?) {
        for (worst, got) in worst.iter_mut().zip(&got) {
            *worst = worse(*worst, (got - truth).abs());
        }
    }
    let [one, two, all] = worst;
    println!("steps along any direction: one {one:.2e}, two {two:.2e}, all slopes alike {all:.2e}");
    assert!(one <= 0.047 && two <= 0.0125 && all > 0.3, "{worst:?}");
    Ok(())
}

/// Mean and variance of the pair are those of the moments, to rounding, and from `slopes_single` on it is one.
#[test]
fn the_pair_keeps_mean_and_variance() -> Outcome {
    let text = "struct both { two: vec2f, one: vec2f, apart: f32 }
    fn asked(parameter: f32) -> both {
        let two = slopes_pair(parameter);
        let offset = 0.5 * (two.z - two.x);
        let mean = vec2f(0.5 * (two.x + two.z), 0.5 * (two.y + two.w) + offset * offset);
        return both(mean, slopes_moments(parameter), max(offset, abs(two.w - two.y)));
    }";
    let points: Vec<Vec<f64>> = (-1300..=4000).map(|index| vec![f64::from(index) / 64.0]).collect();
    for (point, got) in points.iter().zip(run(text, &points)?) {
        assert!((got[0] - got[2]).abs() <= 2e-7 * (1.0 + got[2]), "{point:?}: {got:?}");
        assert!((got[1] - got[3]).abs() <= 4e-7, "{point:?}: {got:?}");
        assert!(point[0] < 3.0 || got[4] == 0.0, "{point:?}: {got:?}");
    }
    Ok(())
}
