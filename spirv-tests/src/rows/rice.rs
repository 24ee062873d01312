//! Means over the lengths of slopes, and moments of their parts, by quadrature.

use prefilter::gpu::Address;
use prefilter::reference::footprint::{axes, deviations, variance_along};
use prefilter::reference::normal::density;
use prefilter::reference::quadrature::integrate;
use prefilter::reference::slopes::Visible;
use prefilter::reference::steepness::mean;
use prefilter::{ColorMap, Colors, Ranges, Scene, SlopeTaps, SlopeTier};

use super::{rounds, Row};

fn visible(x: &[f64]) -> Visible {
    Visible { view: [x[0], x[1], x[2]], mean: [x[3], x[4]], covariance: [x[5], x[6], x[7]] }
}

/// Mean and variance of the square of a component: over a normal density, times 1 + γ He₃/6 for the skewness γ, which
/// leaves all other moments up to the fourth.
fn squared(place: f64, variance: f64, third: f64) -> [f64; 2] {
    let deviation = variance.sqrt();
    let part = third / (6.0 * variance * deviation);
    let average = |function: &dyn Fn(f64) -> f64| {
        let weight = |z: f64| density(z) * (1.0 + part * z * (z * z - 3.0));
        let [sum] = integrate(-12.0, 12.0, 2.0, |z| [function((place + deviation * z).powi(2)) * weight(z)]);
        sum
    };
    let mean = average(&|square| square);
    [mean, average(&|square| (square - mean).powi(2))]
}

/// Mean of the sum of two independent components' squares, and its variance over the square of that.
fn square(place: [f64; 2], variances: [f64; 2], third: f64) -> [f64; 2] {
    let [along, across] = [squared(place[0], variances[0], 0.0), squared(place[1], variances[1], third)];
    let mean = along[0] + across[0];
    [mean, (along[1] + across[1]) / (mean * mean)]
}

/// The three parts by the moments of the visible slopes: the shift is that which would keep the third moment if that
/// went on as it begins, or is as large as the contract lets it be.
fn split(visible: &Visible) -> [f64; 7] {
    let (mean, covariance) = visible.moments();
    let mut frame = axes(covariance);
    // Along `footprint_direction`.
    let [xx, _, yy] = covariance;
    if frame[0][usize::from(xx < yy)] < 0.0 {
        frame = frame.map(|axis| axis.map(|part| -part));
    }
    let place = frame.map(|[x, y]| x * mean[0] + y * mean[1]);
    let [major, minor] = deviations(covariance);
    let thirds = frame.map(|axis| {
        let [_, deviation, skewness] = visible.moments_along(axis);
        skewness * deviation.powi(3)
    });
    let part = (minor / major).clamp(0.55, 1.0);
    let [apart, weight] = rounds::three(part);
    let away = apart * (1.0 - part * part).sqrt() * major;
    let outer = 2.0 * weight;
    let moment = |shift: f64, power: i32| {
        let back = -shift * outer / (1.0 - outer);
        weight * ((shift - away).powi(power) + (shift + away).powi(power)) + (1.0 - outer) * back.powi(power)
    };
    let step = 1e-4 * away;
    let gain = (moment(step, 3) - moment(-step, 3)) / (2.0 * step);
    let shift = (thirds[0] / gain.max(0.12 * major * major)).clamp(-0.2 * away, 0.2 * away);
    let back = shift * outer / (1.0 - outer);
    let whole = (part * major).powi(2);
    let along = (whole - (moment(shift, 2) - moment(0.0, 2))).max(0.25 * whole);
    let part = |off: f64| square([place[0] + off, place[1]], [along, minor * minor], thirds[1]);
    let [middle, before, behind] = [-back, shift - away, shift + away].map(part);
    [middle[0], before[0], behind[0], middle[1], before[1], behind[1], weight]
}

/// Neither axis of the visible slopes could be the major one, nor the other end of it the one that is named.
fn has_axis(x: &[f64]) -> bool {
    let (_, covariance) = visible(x).moments();
    let [major, minor] = deviations(covariance);
    let even = [[1.0, 0.0], [0.0, 1.0]].map(|axis| variance_along(covariance, axis));
    minor < 0.9 * major && (even[0] - even[1]).abs() > 1e-3 * major * major
}

pub(super) fn rows() -> Vec<Row> {
    let map = ColorMap::gradient([(0.2, [0.1, 0.9, 0.2, 0.0]), (0.9, [0.8, 0.1, 0.5, 1.0])]).expect("a ramp is a map");
    let ranges = Ranges { mean: (0.0, 1.0), deviation: 0.32 };
    // Of dynamic colors, whose axes do not depend on the map: the contract can name them.
    let scene = Scene::new("judged").steepness(map.clone()).colors(Colors::Dynamic).ranges(ranges);
    let table = |scene: Scene| scene.module().expect("the ranges are those of the contract").tables()[0].clone();
    let [three, ten] = [scene.clone().slope_taps(SlopeTaps::Three), scene.slope_tier(SlopeTier::Pair)].map(table);
    let map = map.reference();
    let lengths = map.clone();
    let reference = move |x: &[f64]| {
        let (mean_slope, covariance) = ([x[0], x[1]], [x[2], x[3], x[4]]);
        mean(&map, &Visible { view: [0.0, 0.0, 1.0], covariance, mean: mean_slope })
    };
    vec![
        Row::new("rice_five", reference).table(ten, Address::Clamp),
        Row::new("rice_split", |x| split(&visible(x))).only_where(has_axis),
        Row::new("rice_three", move |x| mean(&lengths, &visible(x))).table(three, Address::Clamp),
    ]
}
