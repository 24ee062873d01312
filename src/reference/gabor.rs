//! Solid random-phase Gabor noise, by its definition: kernels in the cells about a point.

use std::f64::consts::TAU;

use super::gabor_kernel::{counted, place, words, BANDWIDTH};
use super::gabor_spectrum::Spectrum;
use super::hash;
use super::quadrature::integrate;

/// A kernel as a point sees it: where the point is from it, and its words.
pub type Seen = ([f64; 3], [u32; 2]);

/// Every kernel of a cell about a point that is `apart` from the cell's low corner.
pub fn within(apart: [f64; 3], words: [u32; 3], kernels: u32) -> Vec<Seen> {
    let mut next = words;
    let kernel = |_| {
        next = hash::triple(next);
        let place = place(next[0]);
        ([0, 1, 2].map(|axis| apart[axis] - place[axis]), [next[1], next[2]])
    };
    (0..kernels).map(kernel).collect()
}

/// Every kernel of the 4³ cells about a point.
pub fn about(position: [f64; 3], kernels: u32, seed: u32) -> Vec<Seen> {
    let first = position.map(|part| (part - 1.5).floor() as i64);
    let range = |axis: usize| first[axis]..first[axis] + 4;
    let cells = range(0).flat_map(|x| range(1).flat_map(move |y| range(2).map(move |z| [x, y, z])));
    let kernels = |cell: [i64; 3]| {
        let apart = [0, 1, 2].map(|axis| position[axis] - cell[axis] as f64);
        within(apart, words(cell, seed), kernels)
    };
    cells.flat_map(kernels).collect()
}

/// The sum of kernels over a footprint and its gradient.
pub fn sum(seen: &[Seen], spectrum: &Spectrum, footprint: [[f64; 3]; 2]) -> (f64, [f64; 3]) {
    let each = seen.iter().map(|(apart, words)| counted(*apart, *words, spectrum, footprint));
    each.fold((0.0, [0.0; 3]), |sum, part| (sum.0 + part.0, [0, 1, 2].map(|axis| sum.1[axis] + part.1[axis])))
}

/// The mean square of one kernel over all places and phases: half the integral of the squared envelope over a cell's
/// volume of 1.
pub fn power() -> f64 {
    let [axis] = integrate(-5.0, 5.0, 0.5, |x| [libm::exp(-TAU * BANDWIDTH * BANDWIDTH * x * x)]);
    0.5 * axis.powi(3)
}

/// Noise and its gradient at a point, filtered over a footprint, in units of its deviation.
pub fn noise(
    position: [f64; 3],
    kernels: u32,
    seed: u32,
    spectrum: &Spectrum,
    footprint: [[f64; 3]; 2],
) -> (f64, [f64; 3]) {
    let scale = 1.0 / (f64::from(kernels) * power()).sqrt();
    let (value, gradient) = sum(&about(position, kernels, seed), spectrum, footprint);
    (scale * value, gradient.map(|part| scale * part))
}
