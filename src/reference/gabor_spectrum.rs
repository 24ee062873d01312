//! Spectra of solid Gabor noise, and what a footprint leaves of the variance: means over frequencies.

use std::f64::consts::TAU;

use super::gabor_kernel::{convolved, Wave, BANDWIDTH};
use super::quadrature::integrate;

/// Ranges of frequencies in polar coordinates, each a start and an extent.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spectrum {
    /// Lengths in cycles a cell.
    pub frequency: [f64; 2],
    /// Angles about the third axis, in radians.
    pub azimuth: [f64; 2],
    /// Cosines of the angle to the third axis.
    pub height: [f64; 2],
}

/// The place of a number of 16 bits in a range: the middle of its share.
fn place([start, extent]: [f64; 2], bits: u32) -> f64 {
    start + extent * (f64::from(bits) + 0.5) / 65_536.0
}

impl Spectrum {
    /// Of each range the middle of the first of its 65536 shares, and how far the next is.
    pub fn shares(&self) -> [f64; 6] {
        let [f, a, h] = [self.frequency, self.azimuth, self.height].map(|range| [place(range, 0), place(range, 1)]);
        [f[0], f[1] - f[0], a[0], a[1] - a[0], h[0], h[1] - h[0]]
    }

    /// The frequency of a kernel with these random words.
    pub fn frequency(&self, words: [u32; 2]) -> [f64; 3] {
        let [azimuth, height] = [place(self.azimuth, words[0] >> 16), place(self.height, words[0] & 0xffff)];
        let length = place(self.frequency, words[1] & 0xffff);
        let inclination = libm::acos(height.clamp(-1.0, 1.0));
        let (level, up) = libm::sincos(inclination);
        let (sin, cos) = libm::sincos(azimuth);
        [length * level * cos, length * level * sin, length * up]
    }
}

/// What is left of the variance of waves of a frequency: the mean of their correlation, a wave of twice the variance,
/// over the differences of two points of the footprint.
fn left(frequency: [f64; 3], footprint: [[f64; 3]; 2]) -> f64 {
    let correlation = Wave { bandwidth: BANDWIDTH / 2f64.sqrt(), frequency, phase: 0.0 };
    convolved(&correlation, [0.0; 3], footprint.map(|vector| vector.map(|part| part * 2f64.sqrt())))
}

/// A value and its fall with the logarithm of the footprint's covariance, by a difference of fourth order.
fn with_fall<const N: usize>(footprint: [[f64; 3]; 2], of: impl Fn([[f64; 3]; 2]) -> [f64; N]) -> [[f64; N]; 2] {
    const STEP: f64 = 1e-2;
    let scaled = |steps: f64| {
        let scale = libm::exp(0.5 * STEP * steps);
        of(footprint.map(|vector| vector.map(|part| part * scale)))
    };
    let [twice, once, back, far] = [2.0, 1.0, -1.0, -2.0].map(scaled);
    let fall = |at: usize| (twice[at] - far[at] - 8.0 * (once[at] - back[at])) / (12.0 * STEP);
    [of(footprint), std::array::from_fn(fall)]
}

/// Share of the variance that is left, and its fall with the logarithm of the footprint's covariance.
pub fn retained(frequency: [f64; 3], footprint: [[f64; 3]; 2]) -> [f64; 2] {
    let [[value], [fall]] = with_fall(footprint, |footprint| [left(frequency, footprint)]);
    [value, fall]
}

/// Logarithms of what is left: of no frequency, and how much less of frequencies ω, a quadratic form in ω by its values
/// for the axes and for the sums of two of them: (none, xx, yy, zz, xy, xz, yz).
fn logarithms(footprint: [[f64; 3]; 2]) -> [f64; 7] {
    // Short enough for a share that f64 holds, long enough for one that is not 1.
    const LENGTH: f64 = 0.25;
    let none = left([0.0; 3], footprint).ln();
    let less = |direction: [f64; 3]| {
        let frequency = direction.map(|part| part * LENGTH);
        (none - left(frequency, footprint).ln()) / (LENGTH * LENGTH)
    };
    let [x, y, z] = [less([1.0, 0.0, 0.0]), less([0.0, 1.0, 0.0]), less([0.0, 0.0, 1.0])];
    let [xy, xz, yz] = [less([1.0, 1.0, 0.0]), less([1.0, 0.0, 1.0]), less([0.0, 1.0, 1.0])];
    [none, x, y, z, xy - x - y, xz - x - z, yz - y - z]
}

/// The same for frequencies of one length in all directions, by quadrature over half the sphere.
pub fn retained_evenly(length: f64, footprint: [[f64; 3]; 2]) -> [f64; 2] {
    const AROUND: usize = 64;
    let [logarithms, falls] = with_fall(footprint, logarithms);
    let form = |of: &[f64; 7], [x, y, z]: [f64; 3]| {
        of[1] * x * x + of[2] * y * y + of[3] * z * z + of[4] * x * y + of[5] * x * z + of[6] * y * z
    };
    let circle: Vec<(f64, f64)> = (0..AROUND).map(|at| libm::sincos(TAU * at as f64 / AROUND as f64)).collect();
    let ring = |height: f64| {
        let level = (1.0 - height * height).sqrt();
        let parts = circle.iter().map(|(sin, cos)| {
            let frequency = [level * cos, level * sin, height].map(|part| part * length);
            let share = libm::exp(-form(&logarithms, frequency));
            // The logarithm of what is left falls by its own fall, and rises by that of the form.
            [share, share * (falls[0] - form(&falls, frequency))]
        });
        parts.fold([0.0; 2], |sum, part| [0, 1].map(|at| sum[at] + part[at] / AROUND as f64))
    };
    integrate(0.0, 1.0, 0.25, ring).map(|mean| mean * libm::exp(logarithms[0]))
}

/// The variance of the noise within a footprint, given the noise's derivatives along its vectors.
pub fn variance(retained: [f64; 2], slopes: [f64; 2]) -> f64 {
    let lost = 1.0 - retained[0];
    let beyond = slopes[0].powi(2) + slopes[1].powi(2) - retained[1];
    (lost + beyond).max(0.0)
}
