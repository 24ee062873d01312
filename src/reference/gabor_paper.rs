//! Solid Gabor noise as its paper filters it: a slice by the surface's plane, in coordinates of the plane.

use std::f64::consts::{PI, TAU};

use super::gabor::{power, Seen};
use super::gabor_kernel::{cross, product, BANDWIDTH, REACH};
use super::gabor_spectrum::Spectrum;

/// A covariance in the plane: xx, xy, yy.
type Plane = [f64; 3];

fn determinant([xx, xy, yy]: Plane) -> f64 {
    xx * yy - xy * xy
}

fn inverse(of: Plane) -> Plane {
    let [xx, xy, yy] = of;
    [yy, -xy, xx].map(|part| part / determinant(of))
}

fn times([xx, xy, yy]: Plane, [x, y]: [f64; 2]) -> [f64; 2] {
    [xx * x + xy * y, xy * x + yy * y]
}

fn plus(a: Plane, b: Plane) -> Plane {
    [0, 1, 2].map(|part| a[part] + b[part])
}

/// The unit normal of the plane of two vectors.
pub fn normal([across, along]: [[f64; 3]; 2]) -> [f64; 3] {
    let normal = cross(across, along);
    let length = product(normal, normal).sqrt();
    normal.map(|part| part / length)
}

/// A kernel sliced, equation 6, and filtered, equation 10, by the plane with a normal.
fn filtered(apart: [f64; 3], frequency: [f64; 3], phase: f64, normal: [f64; 3], footprint: [[f64; 3]; 2]) -> f64 {
    // Any axis that is not the normal begins a frame of the plane.
    let axis = if normal[0].abs() < 0.6 { [1.0, 0.0, 0.0] } else { [0.0, 1.0, 0.0] };
    let tangent = cross(normal, axis);
    let length = product(tangent, tangent).sqrt();
    let tangent = tangent.map(|part| part / length);
    let frame = [tangent, cross(normal, tangent)];
    let flat = |vector: [f64; 3]| frame.map(|axis| product(axis, vector));
    let depth = product(normal, apart);
    let weight = libm::exp(-PI * (BANDWIDTH * depth).powi(2));
    let sliced_phase = phase + TAU * depth * product(normal, frequency);

    let spread = footprint.map(flat).map(|[x, y]| [x * x, x * y, y * y]);
    let filter = plus(spread[0], spread[1]);
    let kernel = [BANDWIDTH * BANDWIDTH / TAU, 0.0, BANDWIDTH * BANDWIDTH / TAU];
    let spectral = inverse(filter).map(|part| part / (TAU * TAU));
    let both = inverse(plus(inverse(kernel), inverse(spectral)));
    let center = times(both, times(inverse(kernel), flat(frequency)));
    let apart_spectra = plus(kernel, spectral);
    let [x, y] = flat(frequency);
    let [u, v] = times(inverse(apart_spectra), [x, y]);
    let gauss = libm::exp(-0.5 * (x * u + y * v)) / (TAU * determinant(apart_spectra).sqrt());
    let amplitude = gauss / (TAU * determinant(filter).sqrt());
    let width = TAU * determinant(both).sqrt();
    let [x, y] = flat(apart);
    weight
        * amplitude
        * libm::exp(-PI * width * (x * x + y * y))
        * libm::cos(TAU * (center[0] * x + center[1] * y) + sliced_phase)
}

/// The square of a kernel's distance in the metric of its round envelope: that along the normal, and of the rest the
/// share by which the envelope's square grows.
pub fn distance(apart: [f64; 3], normal: [f64; 3], [across, along]: [[f64; 3]; 2]) -> f64 {
    let narrow = TAU * BANDWIDTH * BANDWIDTH;
    let [xx, xy, yy] = [product(across, across), product(across, along), product(along, along)];
    let grown = determinant([1.0 + narrow * xx, narrow * xy, 1.0 + narrow * yy]).sqrt();
    let depth = product(normal, apart);
    depth * depth + (product(apart, apart) - depth * depth) / grown
}

/// The sum of kernels that a point sees, each 0 beyond its reach in the metric of its round envelope.
pub fn sum(seen: &[Seen], spectrum: &Spectrum, footprint: [[f64; 3]; 2]) -> f64 {
    let normal = normal(footprint);
    let near = seen.iter().filter(|(apart, _)| distance(*apart, normal, footprint) < REACH * REACH);
    let kernel = |(apart, words): &Seen| {
        let phase = TAU * f64::from(words[1] >> 16) / 65_536.0;
        filtered(*apart, spectrum.frequency(*words), phase, normal, footprint)
    };
    near.map(kernel).sum()
}

/// Noise at kernels that a point sees, in units of its deviation.
pub fn noise(seen: &[Seen], kernels: u32, spectrum: &Spectrum, footprint: [[f64; 3]; 2]) -> f64 {
    sum(seen, spectrum, footprint) / (f64::from(kernels) * power()).sqrt()
}
