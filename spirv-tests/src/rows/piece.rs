//! What pieces of curves add to moments over a normal variable, by quadrature.

use prefilter::reference::piece::{mass, moments, part};

use super::Row;

/// A polynomial and its slope, by powers.
pub(super) fn polynomial(coefficients: &[f64], x: f64) -> [f64; 2] {
    let powers = || coefficients.iter().zip(0..);
    let value = powers().map(|(coefficient, power)| coefficient * x.powi(power)).sum();
    let slope = powers().skip(1).map(|(coefficient, power)| coefficient * f64::from(power) * x.powi(power - 1)).sum();
    [value, slope]
}

/// The part between 0 and an end of a polynomial, from a mean, a deviation, the coefficients and what all is about.
pub(super) fn piece<const DEGREE: usize>(x: &[f64], end: f64) -> [f64; 4] {
    let (coefficients, about) = x[2..].split_at(DEGREE + 1);
    part([0.0, end], [x[0], x[1]], |at| polynomial(coefficients, at), [about[0], about[1]])
}

fn flat(x: &[f64]) -> [f64; 4] {
    let mass = mass([x[0], x[1]], [0.0, 1.0]);
    [mass * x[2], mass * x[2].powi(2), mass * x[3], mass * x[3].powi(2)]
}

pub(super) fn rows() -> Vec<Row> {
    // Where nodes and moments take turns, and where a piece is out of reach.
    let lines = [[0.5, 1.0, 0.3, 0.7, -0.2, 0.4], [1.2, 0.2, 0.3, 0.7, -0.2, 0.4], [-0.5, 0.1, 0.3, 0.7, -0.2, 0.4]];
    let halves = [-8.0, -10.0, 10.0, 0.0].map(|away| [0.1 * away, 0.1, 0.3, 0.7, -0.4, -0.2, 0.4]);
    vec![
        Row::new("piece_curve", |x| polynomial(&x[1..], x[0])),
        Row::new("piece_mass", |x| [mass([x[0], x[1]], [0.0, 1.0])]).only_where(|x| x[0] <= x[1]).at([[-8.0, 8.0]]),
        Row::new("piece_flat", flat).only_where(|x| x[0] <= x[1]).at([[-8.0, 8.0, 0.5, 0.5]]),
        Row::new("piece_line", |x| piece::<1>(x, 1.0)).at(lines),
        Row::new("piece_half", |x| piece::<2>(x, f64::INFINITY)).at(halves),
        Row::new("piece_whole", |x| moments(&[], |at| polynomial(&x[2..], at), x[0], x[1])),
        Row::new("piece_statistics", |x| {
            let variance = |mean: f64, square: f64| (square - mean * mean).max(0.0);
            [x[4] + x[0], variance(x[0], x[1]), x[5] + x[2], variance(x[2], x[3])]
        }),
    ]
}
