//! Kernels of Gabor noise, each integrated over the footprint.

use prefilter::reference::gabor_kernel::{counted, distance, place, spread, words, REACH};

use super::gabor_spectrum::{footprint, spectrum};
use super::Row;

pub(super) fn vector(parts: &[f64]) -> [f64; 3] {
    [parts[0], parts[1], parts[2]]
}

/// Whether a kernel ends so close to a point that rounding decides.
pub(super) fn ends(apart: [f64; 3], footprint: [[f64; 3]; 2]) -> bool {
    (distance(apart, footprint) - REACH * REACH).abs() < 1e-5
}

/// Value and gradient as the shelf adds them up.
pub(super) fn spread_out((value, gradient): (f64, [f64; 3]), footprint: [[f64; 3]; 2]) -> [f64; 4] {
    let [x, y, z] = spread(gradient, footprint);
    [value, x, y, z]
}

pub(super) fn rows() -> Vec<Row> {
    vec![
        Row::new("gabor_kernel_words", |x| {
            words([0, 1, 2].map(|axis| (x[axis] + x[axis + 3]) as i64), x[6] as u32).map(f64::from)
        }),
        Row::new("gabor_kernel_place", |x| place(x[0] as u32)),
        Row::new("gabor_kernel", |x| {
            let footprint = footprint(&x[11..]);
            spread_out(counted(vector(x), [x[3] as u32, x[4] as u32], &spectrum(&x[5..]), footprint), footprint)
        })
        .only_where(|x| !ends(vector(x), footprint(&x[11..]))),
    ]
}
