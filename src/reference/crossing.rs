//! Lines along two axes over one Gaussian footprint: an integral across one of them, of the other's conditional share.

use super::normal::{cumulative, density};
use super::quadrature::integrate;

/// Beyond this many deviations, 3e-12 of the footprint, integrals stop.
const REACH: f64 = 7.0;

/// Share of a normal distribution on the lines of the share `duty` of the period 1, centered at whole numbers.
pub fn line(position: f64, duty: f64, deviation: f64) -> f64 {
    // Nothing is left of the lines beyond: the first wave is down to 4e-13.
    if deviation > 1.2 {
        return duty;
    }
    let [first, last] = [-1.0, 1.0].map(|side| (position + side * (REACH * deviation + 0.5)).round());
    let lines = (0..=(last - first) as u32).map(|line| first + f64::from(line));
    lines.map(|center| covered(center - position, duty, deviation)).sum()
}

/// Share of a normal distribution around 0 within half a width of a center.
fn covered(center: f64, width: f64, deviation: f64) -> f64 {
    let [low, high] = [center - 0.5 * width, center + 0.5 * width];
    if deviation == 0.0 {
        return f64::from(u8::from(low <= 0.0 && 0.0 < high));
    }
    // From the side where probabilities are small.
    let [low, high] = if low > 0.0 { [-high, -low] } else { [low, high] };
    cumulative(high / deviation) - cumulative(low / deviation)
}

/// Share of a footprint that lies on lines across x and on lines across y.
pub fn both(position: [f64; 2], duties: [f64; 2], footprint: [f64; 3]) -> f64 {
    let [xx, xy, yy] = footprint;
    // The axis with fewer lines outside.
    let ([x, y], [a, b], [xx, yy]) = if xx > yy {
        ([position[1], position[0]], [duties[1], duties[0]], [yy, xx])
    } else {
        (position, duties, [xx, yy])
    };
    let deviation = xx.sqrt();
    let along = xy / xx;
    let rest = (yy - xy * along).max(0.0).sqrt();
    // What changes first: the footprint's density, or the lines inside as the position moves along with it.
    let panel = 2.0 * deviation.min(rest / along.abs().max(1e-12)).max(1e-3 * deviation);
    let [first, last] = [-1.0, 1.0].map(|side| (x + side * (REACH * deviation + 0.5)).round());
    let lines = (0..=(last - first) as u32).map(|line| first + f64::from(line));
    let on = |center: f64| {
        let [low, high] = [-0.5, 0.5].map(|side| center + side * a - x);
        let [low, high] = [low.max(-REACH * deviation), high.min(REACH * deviation)];
        integrate(low, high, panel, |at| [density(at / deviation) / deviation * line(y + along * at, b, rest)])[0]
    };
    lines.map(on).sum()
}

/// Covariance of being on a line across x and on one across y.
pub fn covariance(position: [f64; 2], duties: [f64; 2], footprint: [f64; 3]) -> f64 {
    let [x, y] = [(0, 0), (1, 2)].map(|(axis, at)| line(position[axis], duties[axis], footprint[at].sqrt()));
    both(position, duties, footprint) - x * y
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reference::pulse::Footprint;
    use std::f64::consts::{PI, TAU};

    #[test]
    fn lines_are_trains_of_pulses() {
        for (position, duty, deviation) in [(0.3, 0.5, 0.2), (-3.71, 0.03, 0.011), (12.9, 0.8, 1.1), (0.02, 1.0, 1.3)] {
            let train = Footprint::Gaussian(deviation).train(position + 0.5 * duty, duty);
            let own = line(position, duty, deviation);
            assert!((own - train).abs() < 1e-11, "{position} {duty} {deviation}: {own} {train}");
        }
    }

    /// The double Fourier series, to its end.
    fn series([x, y]: [f64; 2], [a, b]: [f64; 2], [xx, xy, yy]: [f64; 3]) -> f64 {
        let coefficient = |number: i32, duty: f64| match number {
            0 => duty,
            _ => libm::sin(PI * f64::from(number) * duty) / (PI * f64::from(number)),
        };
        let mut sum = 0.0;
        for (m, n) in (-60..=60).flat_map(|m| (-60..=60).map(move |n| (m, n))) {
            let (u, v) = (f64::from(m), f64::from(n));
            let fade = libm::exp(-2.0 * PI * PI * (u * u * xx + 2.0 * u * v * xy + v * v * yy));
            sum += coefficient(m, a) * coefficient(n, b) * fade * libm::cos(TAU * (u * x + v * y));
        }
        sum
    }

    #[test]
    fn shares_of_both_are_their_series() {
        for (duties, [x, y, correlation]) in [
            ([0.5, 0.5], [0.2, 0.3, 0.7]),
            ([0.1, 0.3], [0.9, 0.25, -0.9]),
            ([0.8, 0.05], [0.4, 0.8, 0.97]),
            ([0.2, 0.3], [0.3, 1.7, 0.98]),
            ([0.02, 0.5], [0.1, 0.1, 0.0]),
        ] {
            let footprint = [x * x, correlation * x * y, y * y];
            for position in [[0.13, 0.41], [-2.3, 0.02], [0.5, 7.0]] {
                let (own, other) = (both(position, duties, footprint), series(position, duties, footprint));
                assert!((own - other).abs() < 1e-10, "{position:?} {duties:?} {footprint:?}: {own} {other}");
            }
        }
    }

    #[test]
    fn a_line_of_a_footprint_without_width_is_covered_where_it_is() {
        // Along the diagonal: both lines at once.
        let own = both([0.0, 0.0], [0.2, 0.2], [0.01, 0.01 * (1.0 - 1e-9), 0.01]);
        assert!((own - line(0.0, 0.2, 0.1)).abs() < 1e-4, "{own}");
        assert!((both([0.1, 0.9], [1.0, 1.0], [0.3, 0.1, 0.2]) - 1.0).abs() < 1e-11);
    }
}
