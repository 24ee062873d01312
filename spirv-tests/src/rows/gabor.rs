//! Gabor noise: kernels in the cells about a point, each integrated over the footprint.

use prefilter::reference::gabor::{about, noise, sum, within};
use prefilter::reference::gabor_kernel::{columns, density, eigenvalues, factor, farthest, product};

use super::gabor_kernel::{added, ends, vector};
use super::gabor_spectrum::{footprint, spectrum};
use super::Row;

/// The kernels of a cell: after the sum, where it is seen from, its words and their number.
fn cell(x: &[f64]) -> Vec<([f64; 3], [u32; 2])> {
    within(vector(&x[3..]), [6, 7, 8].map(|at| x[at] as u32), x[9] as u32)
}

pub(super) fn rows() -> Vec<Row> {
    vec![
        Row::new("gabor_covered", |x| {
            let footprint = footprint(x);
            let [[a, b, c], [d, e, _]] = columns(footprint);
            let [f, g, h, i] = factor(footprint);
            let [trace, area] = eigenvalues(footprint);
            [a, b, c, d, e, f, g, h, i, trace, area, density(footprint), farthest(footprint)]
        }),
        Row::new("gabor_cell", |x| {
            let footprint = footprint(&x[16..]);
            added(x, sum(&cell(x), &spectrum(&x[10..]), footprint), footprint)
        })
        .only_where(|x| !cell(x).iter().any(|(apart, _)| ends(*apart, footprint(&x[16..])))),
        Row::new("gabor_noise", |x| {
            let footprint = footprint(&x[11..]);
            let (value, gradient) = noise(vector(x), x[3] as u32, x[4] as u32, &spectrum(&x[5..]), footprint);
            [value, product(gradient, footprint[0]), product(gradient, footprint[1])]
        })
        .only_where(|x| {
            let all = about(vector(x), x[3] as u32, x[4] as u32);
            !all.iter().any(|(apart, _)| ends(*apart, footprint(&x[11..])))
        }),
    ]
}
