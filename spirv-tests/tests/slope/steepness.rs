//! Color by the steepness |s|: how far distributions of Rice are from the visible slopes, on the device against the f64
//! integral.

use std::f64::consts::{FRAC_PI_2, TAU};

use prefilter::gpu::Device;
use prefilter::reference::footprint::deviations;
use prefilter::reference::slopes::Visible;
use prefilter::reference::steepness::below;
use spirv_tests::kernel::Function;
use spirv_tests::random::Random;

use crate::{single, Fault, Outcome};

/// ν and σ as the shelf has them.
const ONE: &str = "fn asked(view: vec3f, mean_slope: vec2f, covariance: vec3f) -> vec2f {
    let square = steepness_moments(view, mean_slope, covariance);
    return steepness_rice(square.x, square.y);
}";

/// Of two normal distributions the lengths ν of five means each, the middle one first, σ, and the weights of the two
/// pairs of the others.
const TEN: &str = "
struct five { lengths: vec4f, middle: f32, sigma: f32, weights: vec2f }
struct ten { low: five, high: five }
fn rounds(mean: vec2f, covariance: vec3f) -> five {
    let s = footprint_stretched(covariance, rounds_five_least);
    let arms = rounds_five(s.part);
    let lengths = vec4f(length(mean - arms.x * s.away), length(mean + arms.x * s.away),
        length(mean - arms.y * s.away), length(mean + arms.y * s.away));
    return five(lengths, length(mean), s.deviation, arms.zw);
}
fn asked(view: vec3f, mean_slope: vec2f, covariance: vec3f) -> ten {
    let factor = slopes_factor(view, covariance);
    let pair = slopes_pair(slopes_parameter(view, mean_slope, factor));
    return ten(rounds(mean_slope + pair.x * factor.xy, slopes_covariance(factor, pair.y)),
        rounds(mean_slope + pair.z * factor.xy, slopes_covariance(factor, pair.w)));
}";

/// ν and σ of three, the middle one first, and the weight of either of the others.
const THREE: &str = "
struct three { middle: vec2f, before: vec2f, behind: vec2f, weight: f32 }
fn asked(view: vec3f, mean_slope: vec2f, covariance: vec3f) -> three {
    let parts = rice_split(view, mean_slope, covariance);
    return three(steepness_rice(parts.squares.x, parts.shares.x), steepness_rice(parts.squares.y, parts.shares.y),
        steepness_rice(parts.squares.z, parts.shares.z), parts.weight);
}";

/// ν, σ and weight of a distribution of Rice.
type Rice = [f64; 3];

fn one(got: &[f64]) -> Vec<Rice> {
    vec![[got[0], got[1], 1.0]]
}

fn three(got: &[f64]) -> Vec<Rice> {
    let weights = [1.0 - 2.0 * got[6], got[6], got[6]];
    got.chunks(2).zip(weights).map(|(part, weight)| [part[0], part[1], weight]).collect()
}

fn ten(got: &[f64]) -> Vec<Rice> {
    let five = |got: &[f64]| {
        let (middle, sigma, near, far) = (got[4], got[5], got[6], got[7]);
        let weights = [near, near, far, far, 1.0 - 2.0 * (near + far)];
        let lengths = [got[0], got[1], got[2], got[3], middle];
        lengths.into_iter().zip(weights).map(move |(length, weight)| [length, sigma, 0.5 * weight]).collect::<Vec<_>>()
    };
    [five(&got[..8]), five(&got[8..])].concat()
}

/// How a tier stands for lengths: its text, what that returns, how far ν may be, how small σ for axes of ratios up to
/// 2, and the largest error of a step for axes of ratios 1, 2 and 4.
struct Chain {
    text: &'static str,
    parts: fn(&[f64]) -> Vec<Rice>,
    reach: f64,
    narrowest: f64,
    figures: [f64; 3],
}

const CHAINS: [Chain; 3] = [
    Chain { text: ONE, parts: one, reach: 1.35, narrowest: 0.42, figures: [3.9e-2, 0.105, 0.155] },
    Chain { text: THREE, parts: three, reach: 2.25, narrowest: 0.33, figures: [3.7e-2, 3.52e-2, 7.2e-2] },
    Chain { text: TEN, parts: ten, reach: 3.1, narrowest: 0.19, figures: [1.05e-2, 2.6e-2, 6.2e-2] },
];

/// A surface seen from above its horizon, whose slopes have one deviation along an axis and `aspect` times less across.
pub(crate) fn seen(random: &mut Random, deviation: f64, aspect: f64, most: f64) -> Visible {
    loop {
        let (even, grazing, azimuth) = (random.unit(), random.between(1e-3, 1.0), TAU * random.unit());
        let z = random.pick([even, grazing]);
        let radius = ((1.0 - z) * (1.0 + z)).max(0.0).sqrt();
        let (any, part) = (TAU * random.unit(), random.unit());
        let turn = azimuth + random.pick([0.0, 0.25 * TAU, any]);
        let covariance = turned(deviation, aspect, turn);
        let (length, heading) = (most * random.pick([0.0, part]), TAU * random.unit());
        let mean = single([length * heading.cos(), length * heading.sin()]);
        let view = single([radius * azimuth.cos(), radius * azimuth.sin(), z]);
        let visible = Visible { view, covariance, mean };
        if visible.parameter() >= 0.0 {
            return visible;
        }
    }
}

/// Views along x at parameters from 0, of slopes with the deviation 0.4 along an axis at some angle with it, about
/// means towards and away from it and aside, in deviations.
fn grid(aspect: f64) -> Vec<Visible> {
    let mut views = Vec::new();
    for turn in [0.0, 0.125, 0.25, 0.5, 0.75].map(|part| part * FRAC_PI_2).into_iter().chain([FRAC_PI_2]) {
        let covariance = turned(0.4, aspect, turn);
        for place in (-8..=4).flat_map(|x| (0..=3).map(move |y| [x, y])) {
            let mean = single(place.map(|part| 0.08 * f64::from(part)));
            for parameter in [1e-3, 0.7] {
                let z = mean[0] + parameter * covariance[0].sqrt();
                let view = single([1.0 / f64::hypot(1.0, z), 0.0, z / f64::hypot(1.0, z)]);
                views.push(Visible { view, covariance, mean });
            }
        }
    }
    views
}

/// A covariance with a deviation along an axis, and `aspect` times less across.
fn turned(deviation: f64, aspect: f64, turn: f64) -> [f64; 3] {
    let (sin, cos) = turn.sin_cos();
    let [long, short] = [deviation * deviation, (deviation / aspect).powi(2)];
    single([long * cos * cos + short * sin * sin, (long - short) * sin * cos, long * sin * sin + short * cos * cos])
}

/// The probability of lengths below one by a distribution of Rice.
fn rice_below([center, sigma, _]: &Rice, length: f64) -> f64 {
    let variance = sigma * sigma;
    let round = Visible { view: [0.0, 0.0, 1.0], covariance: [variance, 0.0, variance], mean: [*center, 0.0] };
    below(&round, length)
}

/// What many views of slopes with axes of one ratio say of a chain.
struct Found {
    /// The largest error of a step, and the root of the mean square.
    errors: [f64; 2],
    /// How far ν is beyond the mean slope's length and how small σ is, at most, in deviations of the wider axis.
    ends: [f64; 2],
}

/// Steps at many steepnesses.
fn steps(device: &Device, chain: &Chain, aspect: f64, count: usize) -> Result<Found, Fault> {
    let mut random = Random::new(151);
    let views: Vec<Visible> = (0..count)
        .map(|_| {
            let deviation = random.between(0.05, 1.0);
            let most = random.pick([0.3, 3.0 * deviation]);
            seen(&mut random, deviation, aspect, most)
        })
        .chain(grid(aspect))
        .collect();
    let points: Vec<Vec<f64>> =
        views.iter().map(|visible| [&visible.view[..], &visible.mean, &visible.covariance].concat()).collect();
    let got = Function::in_text(chain.text, "asked")?.results(device, &[], &points)?;
    assert!(!got.is_empty() && got.len() == views.len());
    let (mut worst, mut sum, mut ends) = (0.0f64, 0.0, [f64::NEG_INFINITY, f64::INFINITY]);
    for (visible, got) in views.iter().zip(&got) {
        let parts = (chain.parts)(got);
        // Within the axes of a scene's table.
        let (length, [wide, _]) = (visible.mean[0].hypot(visible.mean[1]), deviations(visible.covariance));
        let mut moments = [0.0; 2];
        for [center, sigma, weight] in &parts {
            assert!(*center <= length + chain.reach * wide && *sigma <= 1.25 * wide, "{visible:?}: {got:?}");
            ends = [ends[0].max((center - length) / wide), ends[1].min(sigma / wide)];
            moments[0] += weight * center;
            moments[1] += weight * (center * center + sigma * sigma);
        }
        let [center, spread] = [moments[0], (moments[1] - moments[0] * moments[0]).max(0.0).sqrt()];
        for step in 0..24 {
            let at = (center + spread * 0.25 * (f64::from(step) - 11.5)).abs();
            let found: f64 = parts.iter().map(|part| part[2] * rice_below(part, at)).sum();
            let error = below(visible, at) - found;
            assert!(error.is_finite(), "{visible:?}");
            worst = worst.max(error.abs());
            sum += error * error;
        }
    }
    Ok(Found { errors: [worst, (sum / (24 * views.len()) as f64).sqrt()], ends })
}

#[test]
fn steps_of_steepness_keep_their_figures() -> Outcome {
    let device = Device::new()?;
    for chain in &CHAINS {
        let (mut reach, mut narrowest) = (0.0f64, f64::INFINITY);
        for (aspect, figure) in [1.0, 2.0, 4.0].into_iter().zip(chain.figures) {
            let Found { errors: [worst, square], ends: [far, narrow] } = steps(&device, chain, aspect, 500)?;
            println!("axes of {aspect}:1: a step errs by {worst:.3e}, root mean square {square:.3e}");
            assert!(worst <= figure && 1.05 * worst >= figure, "{aspect}: {worst}");
            reach = reach.max(far);
            narrowest = if aspect > 2.0 { narrowest } else { narrowest.min(narrow) };
        }
        println!("ν up to {reach:.3} beyond the mean slope, σ from {narrowest:.3}");
        assert!(reach <= chain.reach && 1.15 * reach >= chain.reach, "{reach} of {}", chain.reach);
        assert!(narrowest >= chain.narrowest && narrowest <= 1.15 * chain.narrowest, "{narrowest}");
    }
    Ok(())
}

/// Scaled as a whole: a limit on each number by itself would turn any correlation into 1.
#[test]
fn huge_slopes_keep_their_shape() -> Outcome {
    let device = Device::new()?;
    // Over a level surface and from its horizon only lengths change with the size.
    let sizes = [1e11, 1e12, 1e14, 1e20, 3e38];
    let points = sizes.map(|size| [&[0.8, -0.6, 0.0, 0.0, 0.0][..], &single([size, -0.2 * size, 0.5 * size])].concat());
    let whole = "fn asked(view: vec3f, mean_slope: vec2f, covariance: vec3f) -> rice_parts {
        let square = steepness_moments(view, mean_slope, covariance);
        let parts = rice_split(view, mean_slope, covariance);
        return rice_parts(vec3f(square.x, parts.squares.xy), vec3f(square.y, parts.shares.xy), parts.weight);
    }";
    let got = Function::in_text(whole, "asked")?.results(&device, &[], &points)?;
    assert_eq!(got.len(), sizes.len());
    for (size, found) in sizes.into_iter().zip(&got) {
        // Three squares, then their shares and the weight.
        let scale = |number: usize| if number < 3 { size.min(1e12) / sizes[0] } else { 1.0 };
        for (number, (found, small)) in found.iter().zip(&got[0]).enumerate() {
            let part = found / (scale(number) * small);
            assert!((part - 1.0).abs() <= 1e-5, "{size:e}: number {number} is {part} of what it should be");
        }
    }
    Ok(())
}
