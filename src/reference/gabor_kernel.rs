//! Kernels of solid Gabor noise, by their definition, and their integrals over a footprint.

use std::f64::consts::{PI, TAU};

use super::gabor_spectrum::Spectrum;
use super::lattice::gradient;

/// Bandwidth of a kernel, in 1/cells.
pub const BANDWIDTH: f64 = 0.8;

/// How far a kernel reaches, in cells.
pub const REACH: f64 = 1.5;

/// A kernel: exp(−π a² |r|²) cos(2π ω·r + φ).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wave {
    /// a, in 1/cells.
    pub bandwidth: f64,
    /// ω, in cycles a cell.
    pub frequency: [f64; 3],
    /// φ, in radians.
    pub phase: f64,
}

/// The scalar product.
pub fn product(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// A kernel at a distance from its center.
pub fn kernel(wave: &Wave, apart: [f64; 3]) -> f64 {
    let Wave { bandwidth, frequency, phase } = *wave;
    libm::exp(-PI * bandwidth * bandwidth * product(apart, apart)) * libm::cos(TAU * product(frequency, apart) + phase)
}

/// The mean of a kernel over the points apart + u across + v along, u and v being standard normal and independent.
///
/// With w = (u, v) the kernel is the real part of exp(c + bᵀw − ½ wᵀK w), and the mean that of
/// exp(c + ½ bᵀ(I + K)⁻¹b)/√|I + K|: the integral of a Gaussian in the plane of u and v, with complex b.
pub fn convolved(wave: &Wave, apart: [f64; 3], footprint: [[f64; 3]; 2]) -> f64 {
    let Wave { bandwidth, frequency, phase } = *wave;
    let narrow = TAU * bandwidth * bandwidth;
    let (determinant, form) = plane(narrow, footprint);
    let real = footprint.map(|vector| -narrow * product(apart, vector));
    let imaginary = footprint.map(|vector| TAU * product(frequency, vector));
    let exponent = -0.5 * narrow * product(apart, apart) + 0.5 * (form(real, real) - form(imaginary, imaginary));
    let angle = TAU * product(frequency, apart) + phase + form(real, imaginary);
    libm::exp(exponent) * libm::cos(angle) / determinant.sqrt()
}

/// The determinant of I + K, and the form aᵀ(I + K)⁻¹b: of two vectors K has the products, times `narrow`.
fn plane(narrow: f64, [across, along]: [[f64; 3]; 2]) -> (f64, impl Fn([f64; 2], [f64; 2]) -> f64) {
    let [uu, uv, vv] = [product(across, across), product(across, along), product(along, along)];
    let area = cross(across, along);
    // Lagrange's identity: the product of the diagonal less a square loses it where both are long.
    let determinant = 1.0 + narrow * (uu + vv) + narrow * narrow * product(area, area);
    let [uu, uv, vv] = [1.0 + narrow * uu, narrow * uv, 1.0 + narrow * vv];
    let form = move |a: [f64; 2], b: [f64; 2]| {
        (vv * a[0] * b[0] - uv * (a[0] * b[1] + a[1] * b[0]) + uu * a[1] * b[1]) / determinant
    };
    (determinant, form)
}

/// The square of a kernel's distance in the metric of its filtered envelope, rᵀ(I + 2π a² Σ)⁻¹r.
pub fn distance(apart: [f64; 3], footprint: [[f64; 3]; 2]) -> f64 {
    let narrow = TAU * BANDWIDTH * BANDWIDTH;
    let along = footprint.map(|vector| product(apart, vector));
    product(apart, apart) - narrow * plane(narrow, footprint).1(along, along)
}

/// The inverse of a matrix, by the cross products of its rows.
fn inverse([x, y, z]: [[f64; 3]; 3]) -> [[f64; 3]; 3] {
    let columns = [cross(y, z), cross(z, x), cross(x, y)];
    let determinant = product(x, columns[0]);
    [0, 1, 2].map(|row| [0, 1, 2].map(|column| columns[column][row] / determinant))
}

/// The cross product.
pub fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// The angle by which a footprint's vectors are turned, and turned: until the second has no third part, and the first
/// a positive one, if any is more than nothing.
fn level([across, along]: [[f64; 3]; 2]) -> (f64, [[f64; 3]; 2]) {
    let steep = TAU.sqrt() * BANDWIDTH * libm::hypot(across[2], along[2]) > 1e-15;
    let angle = if steep { libm::atan2(along[2], across[2]) } else { 0.0 };
    let (sin, cos) = libm::sincos(angle);
    let first = [0, 1, 2].map(|axis| cos * across[axis] + sin * along[axis]);
    let [x, y] = [0, 1].map(|axis| cos * along[axis] - sin * across[axis]);
    (angle, [first, [x, y, 0.0]])
}

/// The columns of N with N Nᵀ = I − M, M being (I + 2π a² Σ)⁻¹: the second is that of the level vector alone, the first
/// what the other adds.
pub fn columns(footprint: [[f64; 3]; 2]) -> [[f64; 3]; 2] {
    let (_, [first, second]) = level(footprint);
    let metric = |footprint| inverse(grown(footprint));
    let [none, one, both] = [[[0.0; 3]; 2], [second, [0.0; 3]], [first, second]].map(metric);
    // The vector v of a difference v vᵀ of two matrices, on whose line `toward` has a part.
    let difference = |from: [[f64; 3]; 3], to: [[f64; 3]; 3], toward: [f64; 3]| {
        let image: [f64; 3] = std::array::from_fn(|row| product(from[row], toward) - product(to[row], toward));
        let length = product(image, toward).max(0.0).sqrt();
        image.map(|part| if length > 0.0 { part / length } else { 0.0 })
    };
    [difference(one, both, first), difference(none, one, second)]
}

/// The columns of F with (across along)ᵀM = F Nᵀ/(2π a²).
///
/// F Fᵀ/(2π a²) is the inverse of I + 2π a² JᵀJ, J having the columns across and along; turned back, F is triangular.
pub fn factor(footprint: [[f64; 3]; 2]) -> [f64; 4] {
    let (angle, [first, second]) = level(footprint);
    let narrow = TAU * BANDWIDTH * BANDWIDTH;
    let [uu, uv, vv] = [product(first, first), product(first, second), product(second, second)].map(|x| narrow * x);
    let flat = inverse([[1.0 + uu, uv, 0.0], [uv, 1.0 + vv, 0.0], [0.0, 0.0, 1.0]]).map(|row| row.map(|x| narrow * x));
    let x = flat[0][0].sqrt();
    let y = flat[0][1] / x;
    let z = (flat[1][1] - y * y).max(0.0).sqrt();
    let (sin, cos) = libm::sincos(angle);
    [cos * x - sin * y, sin * x + cos * y, -sin * z, cos * z]
}

/// Sum and product of the two eigenvalues of I − M that are not 0.
pub fn eigenvalues(footprint: [[f64; 3]; 2]) -> [f64; 2] {
    let inverse = inverse(grown(footprint));
    let trace = (0..3).map(|axis| 1.0 - inverse[axis][axis]).sum::<f64>();
    // (1 − p)(1 − q) = 1 − p − q + p q, of the eigenvalues 1 − p and 1 − q.
    [trace, trace - 1.0 + density(footprint).powi(2)]
}

/// √|M|: what the largest value of a filtered kernel is.
pub fn density(footprint: [[f64; 3]; 2]) -> f64 {
    let [x, y, z] = inverse(grown(footprint));
    product(x, cross(y, z)).sqrt()
}

/// The square of how far a kernel reaches along the longest axis.
pub fn farthest(footprint: [[f64; 3]; 2]) -> f64 {
    REACH * REACH * longest(grown(footprint))
}

/// The largest eigenvalue of a symmetric matrix whose eigenvalues are positive, by squaring it again and again.
fn longest(matrix: [[f64; 3]; 3]) -> f64 {
    let times = |a: [[f64; 3]; 3], b: [[f64; 3]; 3]| a.map(|row| [0, 1, 2].map(|at| product(row, b[at])));
    let trace = |m: [[f64; 3]; 3]| m[0][0] + m[1][1] + m[2][2];
    let power = (0..48).fold(matrix, |power, _| {
        let scale = trace(power);
        let scaled = power.map(|row| row.map(|part| part / scale));
        times(scaled, scaled)
    });
    trace(times(power, matrix)) / trace(power)
}

/// I + 2π a² Σ.
fn grown(footprint: [[f64; 3]; 2]) -> [[f64; 3]; 3] {
    let narrow = TAU * BANDWIDTH * BANDWIDTH;
    let entry = |row: usize, column: usize| {
        f64::from(u8::from(row == column)) + narrow * footprint.iter().map(|v| v[row] * v[column]).sum::<f64>()
    };
    [0, 1, 2].map(|row| [0, 1, 2].map(|column| entry(row, column)))
}

/// The kernel with these random words, 0 beyond its reach, and its gradient.
pub fn counted(apart: [f64; 3], words: [u32; 2], spectrum: &Spectrum, footprint: [[f64; 3]; 2]) -> (f64, [f64; 3]) {
    if distance(apart, footprint) >= REACH * REACH {
        return (0.0, [0.0; 3]);
    }
    let phase = TAU * f64::from(words[1] >> 16) / 65_536.0;
    let wave = Wave { bandwidth: BANDWIDTH, frequency: spectrum.frequency(words), phase };
    let at = |apart| convolved(&wave, apart, footprint);
    (at(apart), gradient(apart, at))
}

/// The gradient before the footprint's matrix: the vector g with the gradient −2π (I + 2π a² Σ)⁻¹ g.
pub fn spread(gradient: [f64; 3], footprint: [[f64; 3]; 2]) -> [f64; 3] {
    grown(footprint).map(|row| -product(row, gradient) / TAU)
}

/// The words of a cell.
pub fn words(cell: [i64; 3], seed: u32) -> [u32; 3] {
    let moved = [2_654_435_769u32, 2_246_822_507, 3_266_489_909].map(|odd| odd.wrapping_mul(seed));
    [0, 1, 2].map(|axis| (cell[axis] as u32).wrapping_add(moved[axis]))
}

/// The place of a kernel in its cell, by the bits of a word.
pub fn place(word: u32) -> [f64; 3] {
    let bits = [(word >> 21, 2048.0), (word >> 10 & 2047, 2048.0), (word & 1023, 1024.0)];
    bits.map(|(bits, count)| (f64::from(bits) + 0.5) / count)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Across a long footprint a distance is what it is without one, along it next to nothing: kernels beyond it do not
    /// count however long it is.
    #[test]
    fn long_footprints_leave_distances_across_them() {
        let [along, aside] = [[0.415, -0.594, -0.689], [0.82, 0.572_869_565_217_391_3, 0.0]];
        assert!(product(along, aside).abs() < 1e-4);
        for length in [1.0, 1e2, 1e4, 1e6] {
            let footprint = [[0.0; 3], along.map(|part| length * part)];
            let direct = |apart| {
                let part = product(apart, along) / product(along, along);
                let rest: [f64; 3] = std::array::from_fn(|axis| apart[axis] - part * along[axis]);
                let narrow = 1.0 + TAU * BANDWIDTH * BANDWIDTH * length * length * product(along, along);
                product(rest, rest) + part * part * product(along, along) / narrow
            };
            for apart in [aside, along, [1.2, 0.3, -0.7]] {
                let (found, exact) = (distance(apart, footprint), direct(apart));
                assert!((found - exact).abs() < 1e-9 * (1.0 + exact), "{length}: {found} for {exact}");
            }
        }
    }
}
