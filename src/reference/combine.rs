//! Colors and light on the slopes that a view sees, averaged together by quadrature, and what the nodes that stand for
//! those slopes are.

use super::footprint::variance_along;
use super::quadrature::integrate;
use super::slopes::Visible;

/// Beyond this many deviations lies less than 1e-14 of a normal variable.
const FAR: f64 = 8.0;

/// The mean over the visible slopes of a function of the slope, smooth but where the slope's component along a unit
/// vector crosses an edge. The covariance of the slopes is not singular.
///
/// Slopes are a component along the vector and one across it, of which the latter is normal given the former.
pub fn mean<const N: usize>(
    visible: &Visible,
    direction: [f64; 2],
    edges: &[f64],
    function: impl Fn([f64; 2]) -> [f64; N],
) -> [f64; N] {
    let axes = [direction, [-direction[1], direction[0]]];
    let dot = |a: [f64; 2], b: [f64; 2]| a[0] * b[0] + a[1] * b[1];
    let [xx, xy, yy] = visible.covariance;
    let image = [xx * axes[1][0] + xy * axes[1][1], xy * axes[1][0] + yy * axes[1][1]];
    let (variance, both) = (variance_along(visible.covariance, direction), dot(direction, image));
    let rest = (dot(axes[1], image) - both * both / variance).sqrt();
    let [start, middle] = axes.map(|axis| dot(axis, visible.mean));
    let deviation = variance.sqrt();
    let sums = |from: f64, to: f64, value: &dyn Fn([f64; 2]) -> [f64; N]| {
        integrate(from, to, 0.5 * deviation, |place| {
            let apart = (place - start) / deviation;
            let center = middle + both / variance * (place - start);
            let slope = |across: f64| [0, 1].map(|i| place * axes[0][i] + (center + rest * across) * axes[1][i]);
            let weight = |across: f64| visible.view[2] - dot([visible.view[0], visible.view[1]], slope(across));
            // The weight is linear across, and ends where it is 0.
            let end = (weight(0.0) / (weight(0.0) - weight(1.0))).clamp(-FAR, FAR);
            let end = if end.is_nan() { FAR } else { end };
            let mut sum = [0.0; N];
            for [from, to] in [[-FAR, end], [end, FAR]] {
                let part: [f64; N] = integrate(from, to, 1.0, |across| {
                    let density = (-0.5 * (apart * apart + across * across)).exp() * weight(across).max(0.0);
                    value(slope(across)).map(|value| value * density)
                });
                sum.iter_mut().zip(part).for_each(|(sum, part)| *sum += part);
            }
            sum
        })
    };
    let mut stops = vec![start - FAR * deviation, start + FAR * deviation];
    stops.extend(edges.iter().copied().filter(|edge| (edge - start).abs() < FAR * deviation));
    stops.sort_by(f64::total_cmp);
    let (mut sum, mut whole) = ([0.0; N], 0.0);
    for pair in stops.windows(2) {
        let part = sums(pair[0], pair[1], &function);
        sum.iter_mut().zip(part).for_each(|(sum, part)| *sum += part);
        whole += sums(pair[0], pair[1], &|_| [1.0; N])[0];
    }
    sum.map(|value| value / whole)
}

/// A node of the visible slopes: its place along both axes of their factor in deviations, and its weight.
///
/// Five nodes, one in the middle, two on the first axis and two on the second, have the weights 0.52 and 0.12, each
/// being 0.7 deviations wide. Their places have the mean 0, together with their widths the unit variance, and along the
/// first axis the third moment of 0.75 of a skewness.
pub fn node(number: usize, skewness: f64) -> [f64; 3] {
    const WEIGHT: f64 = 0.12;
    const REST: f64 = 1.0 - 2.0 * WEIGHT;
    const VARIANCE: f64 = 1.0 - 0.7 * 0.7;
    // The outer two of an axis, as far from the others as the variance asks for.
    let places = |middle: f64| {
        let others = -2.0 * WEIGHT * middle / REST;
        let apart = bisected(0.0, 4.0, |apart| {
            let squares = (middle - apart).powi(2) + (middle + apart).powi(2);
            WEIGHT * squares + REST * others * others - VARIANCE
        });
        [middle - apart, middle + apart, others]
    };
    let middle = bisected(0.0, 0.8, |middle| {
        let [low, high, others] = places(middle);
        WEIGHT * (low.powi(3) + high.powi(3)) + REST * others.powi(3) - 0.75 * skewness
    });
    let ([low, high, others], [below, above, _]) = (places(middle), places(0.0));
    match number {
        0 => [others, 0.0, 1.0 - 4.0 * WEIGHT],
        1 => [low, 0.0, WEIGHT],
        2 => [high, 0.0, WEIGHT],
        3 => [others, below, WEIGHT],
        _ => [others, above, WEIGHT],
    }
}

/// Where a rising function is 0.
fn bisected(mut low: f64, mut high: f64, function: impl Fn(f64) -> f64) -> f64 {
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if function(middle) < 0.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    0.5 * (low + high)
}
