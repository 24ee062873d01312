//! Gabor noise: kernels in the cells about a point, each integrated over the footprint.

use prefilter::reference::gabor::{about, noise, sum, within};
use prefilter::reference::gabor_kernel::factored;

use super::gabor_kernel::{ends, spread_out, vector};
use super::gabor_spectrum::{footprint, spectrum};
use super::Row;

/// The kernels of a cell: where it is seen from, its words and their number.
fn cell(x: &[f64]) -> Vec<([f64; 3], [u32; 2])> {
    within(vector(x), [3, 4, 5].map(|at| x[at] as u32), x[6] as u32)
}

pub(super) fn rows() -> Vec<Row> {
    vec![
        Row::new("gabor_covered", |x| factored(footprint(x))),
        Row::new("gabor_cell", |x| {
            let footprint = footprint(&x[13..]);
            spread_out(sum(&cell(x), &spectrum(&x[7..]), footprint), footprint)
        })
        .only_where(|x| !cell(x).iter().any(|(apart, _)| ends(*apart, footprint(&x[13..])))),
        Row::new("gabor_noise", |x| {
            let footprint = footprint(&x[11..]);
            let (value, [a, b, c]) = noise(vector(x), x[3] as u32, x[4] as u32, &spectrum(&x[5..]), footprint);
            [value, a, b, c]
        })
        .only_where(|x| {
            let all = about(vector(x), x[3] as u32, x[4] as u32);
            !all.iter().any(|(apart, _)| ends(*apart, footprint(&x[11..])))
        }),
    ]
}
