//! Lines along two axes: the shares on both by an integral, waves by quadrature over a line.

use prefilter::reference::crossing::covariance;
use prefilter::reference::quadrature::integrate;

use super::Row;

/// Position, duties and footprint.
fn lines(x: &[f64]) -> f64 {
    covariance([x[0], x[1]], [x[2], x[3]].map(|duty| duty.clamp(0.0, 1.0)), [x[4], x[5], x[6]])
}

/// The covariance of the odd waves alone: of half the difference of lines and lines half a period on.
fn odd(x: &[f64]) -> f64 {
    let shifted = |across: f64, down: f64| lines(&[&[x[0] + across, x[1] + down], &x[2..7]].concat());
    0.25 * (shifted(0.0, 0.0) - shifted(0.5, 0.0) - shifted(0.0, 0.5) + shifted(0.5, 0.5))
}

/// A quarter of a period is where waves take over from corners.
fn is_narrow(x: &[f64]) -> bool {
    x[4].max(x[6]) < 0.0625
}

fn is_wide(x: &[f64]) -> bool {
    x[4].max(x[6]) >= 0.0625
}

/// Densities at corners by the inverse of the correlation matrix.
fn corners(x: &[f64]) -> f64 {
    let correlation = libm::sin(x[8]);
    let determinant = 1.0 - correlation * correlation;
    let mut sum = 0.0;
    for (i, j) in (0..4).flat_map(|i| (0..4).map(move |j| (i, j))) {
        let (a, b) = (x[i], x[4 + j]);
        let square = (a * (a - correlation * b) + b * (b - correlation * a)) / determinant;
        sum += (if (i + j) % 2 == 0 { 1.0 } else { -1.0 }) * libm::exp(-0.5 * square);
    }
    sum
}

fn wave(number: f64, duty: f64) -> f64 {
    if number == 0.0 {
        return 0.0;
    }
    integrate(0.0, 0.5 * duty, 0.02, |at| [2.0 * libm::cos(std::f64::consts::TAU * number * at)])[0]
}

pub(super) fn rows() -> Vec<Row> {
    let squares = |x: &[f64]| lines(&[x[0], x[1], 0.5, 0.5, x[2], x[3], x[4]]);
    vec![
        Row::new("crossing_lines", |x| [lines(x)]),
        Row::new("crossing_squares", move |x| [squares(x)]),
        Row::new("crossing_near", |x| [lines(x)]).only_where(is_narrow),
        Row::new("crossing_corners", |x| [corners(x)]),
        Row::new("crossing_waves", |x| [if x[7] == 2.0 { odd(x) } else { lines(x) }]).only_where(is_wide),
        Row::new("crossing_wave", |x| [wave(x[0], x[1])]),
    ]
}
