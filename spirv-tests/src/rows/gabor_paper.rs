//! Gabor noise as its paper filters it: slices, in coordinates of the surface's plane.

use prefilter::reference::gabor::{about, within, Seen};
use prefilter::reference::gabor_kernel::{cross, product, REACH};
use prefilter::reference::gabor_paper::{distance, noise, normal, sum};

use super::gabor_kernel::vector;
use super::gabor_spectrum::{footprint, spectrum};
use super::Row;

/// Whether the vectors of a footprint span a plane, far enough from a line for f32.
fn spans(x: &[f64]) -> bool {
    let [across, along] = footprint(x);
    let normal = cross(across, along);
    product(normal, normal) > (0.01 * product(across, across) * product(along, along)).max(1e-12)
}

/// Whether no kernel ends so close to the point that rounding decides.
fn clear(seen: &[Seen], x: &[f64]) -> bool {
    let footprint = footprint(x);
    let normal = normal(footprint);
    seen.iter().all(|(apart, _)| (distance(*apart, normal, footprint) - REACH * REACH).abs() > 1e-4)
}

fn one(x: &[f64]) -> Seen {
    (vector(x), [x[3] as u32, x[4] as u32])
}

fn cell(x: &[f64]) -> Vec<Seen> {
    within(vector(x), [3, 4, 5].map(|at| x[at] as u32), x[6] as u32)
}

fn all(x: &[f64]) -> Vec<Seen> {
    about(vector(x), x[3] as u32, x[4] as u32)
}

pub(super) fn rows() -> Vec<Row> {
    let noise = |x: &[f64]| [noise(&all(x), x[3] as u32, &spectrum(&x[5..]), footprint(&x[11..]))];
    vec![
        Row::new("gabor_paper_normal", |x| normal(footprint(x))).only_where(spans),
        Row::new("gabor_paper_kernel", |x| [sum(&[one(x)], &spectrum(&x[5..]), footprint(&x[11..]))])
            .only_where(|x| spans(&x[11..]) && clear(&[one(x)], &x[11..])),
        Row::new("gabor_paper_cell", |x| [sum(&cell(x), &spectrum(&x[7..]), footprint(&x[13..]))])
            .only_where(|x| spans(&x[13..]) && clear(&cell(x), &x[13..])),
        Row::new("gabor_paper_noise", noise).only_where(|x| spans(&x[11..]) && clear(&all(x), &x[11..])),
    ]
}
