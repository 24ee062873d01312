//! Kernels of Gabor noise, each integrated over the footprint.

use prefilter::reference::gabor_kernel::{columns, counted, density, distance, place, product, spread, words, REACH};

use super::gabor_spectrum::{footprint, spectrum};
use super::Row;

pub(super) fn vector(parts: &[f64]) -> [f64; 3] {
    [parts[0], parts[1], parts[2]]
}

/// Whether a kernel ends so close to a point that rounding decides.
pub(super) fn ends(apart: [f64; 3], footprint: [[f64; 3]; 2]) -> bool {
    (distance(apart, footprint) - REACH * REACH).abs() < 1e-5
}

/// A sum as the shelf adds to it, of kernels over the density.
pub(super) fn added(sum: &[f64], kernels: (f64, [f64; 3]), footprint: [[f64; 3]; 2]) -> [f64; 3] {
    let density = density(footprint);
    let spread = spread(kernels.1, footprint);
    let [x, y] = columns(footprint).map(|column| product(column, spread));
    [sum[0] + kernels.0 / density, sum[1] + x / density, sum[2] + y / density]
}

pub(super) fn rows() -> Vec<Row> {
    vec![
        Row::new("gabor_kernel_words", |x| words([0, 1, 2].map(|axis| x[axis] as i64), x[3] as u32).map(f64::from)),
        Row::new("gabor_kernel_place", |x| place(x[0] as u32)),
        Row::new("gabor_kernel", |x| {
            let footprint = footprint(&x[14..]);
            let kernel = counted(vector(&x[3..]), [x[6] as u32, x[7] as u32], &spectrum(&x[8..]), footprint);
            added(x, kernel, footprint)
        })
        .only_where(|x| !ends(vector(&x[3..]), footprint(&x[14..]))),
    ]
}
