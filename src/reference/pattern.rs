//! Patterns of two values: shares of a footprint by what lies on, or beside, two sets of lines at once.

use super::crossing::both;
use super::pulse::Footprint;

/// Whether a point lies on the squares of a checker, of the side 1, that begin at an even sum of two whole numbers.
pub fn checker_at([x, y]: [f64; 2]) -> bool {
    (x.floor() + y.floor()).rem_euclid(2.0) == 0.0
}

/// Share of a Gaussian footprint on those squares: on stripes that begin at even numbers both ways, or on none.
pub fn checker([x, y]: [f64; 2], footprint: [f64; 3]) -> f64 {
    // Stripes of the period 1 are centered at a quarter of it.
    let stripes = [0.5 * x - 0.25, 0.5 * y - 0.25];
    let halved = footprint.map(|entry| 0.25 * entry);
    both(stripes, [0.5; 2], halved) + both(stripes.map(|at| at + 0.5), [0.5; 2], halved)
}

/// Whether a point lies on the lines of a grid, centered at whole numbers.
pub fn grid_at(position: [f64; 2], widths: [f64; 2]) -> bool {
    position.iter().zip(widths).any(|(at, width)| (at - at.round()).abs() < 0.5 * width)
}

/// Share of a Gaussian footprint on those lines: all but what lies in gaps both ways.
pub fn grid(position: [f64; 2], widths: [f64; 2], footprint: [f64; 3]) -> f64 {
    1.0 - both(position.map(|at| at + 0.5), widths.map(|width| 1.0 - width), footprint)
}

/// Share of a box along the axes on the squares of a checker.
pub fn checker_box(position: [f64; 2], widths: [f64; 2]) -> f64 {
    let on = |axis: usize, shift: f64| Footprint::Box(0.5 * widths[axis]).train(0.5 * position[axis] + shift, 0.5);
    on(0, 0.0) * on(1, 0.0) + on(0, 0.5) * on(1, 0.5)
}

/// Share of a box along the axes on the lines of a grid.
pub fn grid_box(position: [f64; 2], lines: [f64; 2], widths: [f64; 2]) -> f64 {
    let gap = |axis: usize| Footprint::Box(widths[axis]).train(position[axis] - 0.5 * lines[axis], 1.0 - lines[axis]);
    1.0 - gap(0) * gap(1)
}

/// Mean, variance, skewness and excess kurtosis of a value that is 1 with a probability and 0 else, as expectations.
pub fn moments(share: f64) -> [f64; 4] {
    let power = |power: i32| share * (1.0 - share).powi(power) + (1.0 - share) * (-share).powi(power);
    let variance = power(2);
    [share, variance, power(3) / variance.powf(1.5), power(4) / (variance * variance) - 3.0]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Means over a fine even set of points of the footprint, by quantiles of both normal coordinates.
    fn sampled(position: [f64; 2], [xx, xy, yy]: [f64; 3], inside: impl Fn([f64; 2]) -> bool) -> f64 {
        let (column, rest) = (xx.sqrt(), (yy - xy * xy / xx).sqrt());
        let count = 1200;
        let reach = 6.0;
        let at = |step: i32| reach * (2.0 * (f64::from(step) + 0.5) / f64::from(count) - 1.0);
        let (mut sum, mut total) = (0.0, 0.0);
        for (u, v) in (0..count).flat_map(|i| (0..count).map(move |j| (at(i), at(j)))) {
            let weight = libm::exp(-0.5 * (u * u + v * v));
            let point = [position[0] + column * u, position[1] + xy / column * u + rest * v];
            sum += weight * f64::from(u8::from(inside(point)));
            total += weight;
        }
        sum / total
    }

    #[test]
    fn shares_are_those_of_points() {
        for (x, y, correlation) in [(0.4, 0.3, 0.5), (1.1, 0.2, -0.9), (0.1, 0.15, 0.95)] {
            let footprint = [x * x, correlation * x * y, y * y];
            for position in [[0.3, 0.1], [-2.9, 0.95], [5.5, -1.2]] {
                let (own, other) = (checker(position, footprint), sampled(position, footprint, checker_at));
                assert!((own - other).abs() < 5e-3, "checker {position:?} {footprint:?}: {own} {other}");
                let widths = [0.1, 0.3];
                let own = grid(position, widths, footprint);
                let other = sampled(position, footprint, |point| grid_at(point, widths));
                assert!((own - other).abs() < 5e-3, "grid {position:?} {footprint:?}: {own} {other}");
            }
        }
    }

    #[test]
    fn boxes_within_a_square_are_points() {
        assert_eq!([[0.5, 0.5], [1.5, 0.5], [-0.5, 0.5]].map(|at| checker_box(at, [0.9, 0.2])), [1.0, 0.0, 0.0]);
        assert!((grid_box([0.3, 7.6], [0.1, 0.2], [0.2, 0.3])).abs() < 1e-12);
        assert!((grid_box([0.0, 7.6], [0.1, 0.2], [1.0, 1.0]) - (1.0 - 0.9 * 0.8)).abs() < 1e-12);
    }

    #[test]
    fn a_fair_coin_has_the_least_kurtosis() {
        assert_eq!(moments(0.5), [0.5, 0.25, 0.0, -2.0]);
    }
}
