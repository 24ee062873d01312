//! Irradiance over visible normals: light from an environment of order 2, and one directional light.

use super::normal::density;
use super::normals::average;
use super::quadrature::integrate;
use super::slopes::Visible;
use super::texture::{mean, PiecewiseLinear};

/// The real spherical harmonics up to order 2 of a direction: by order, in each from the lowest degree.
///
/// Source: Ramamoorthi and Hanrahan 2001, "An Efficient Representation for Irradiance Environment Maps", equation 3.
pub fn harmonics([x, y, z]: [f64; 3]) -> [f64; 9] {
    let [zero, one, two] = [1.0, 3.0, 15.0].map(|ratio: f64| (ratio / std::f64::consts::PI).sqrt() / 2.0);
    let flat = (5.0 / std::f64::consts::PI).sqrt() / 4.0;
    let second = [two * x * y, two * y * z, flat * (3.0 * z * z - 1.0), two * x * z, 0.5 * two * (x * x - y * y)];
    [zero, one * y, one * z, one * x, second[0], second[1], second[2], second[3], second[4]]
}

/// The irradiance on a plane of a unit normal from the radiance Σ Lᵢ Yᵢ: the integral of radiance times cosine over the
/// hemisphere, in polar coordinates about the normal.
pub fn from_radiance(radiance: [f64; 9], normal: [f64; 3]) -> f64 {
    let [x, y, z] = normal;
    // Two directions across the normal, the first not near it.
    let other = if z.abs() < 0.6 { [0.0, 0.0, 1.0] } else { [1.0, 0.0, 0.0] };
    let cross =
        |a: [f64; 3], b: [f64; 3]| [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
    let across = cross(normal, other);
    let length = across.iter().map(|part| part * part).sum::<f64>().sqrt();
    let u = across.map(|part| part / length);
    let v = cross([x, y, z], u);
    let [sum] = integrate(0.0, 1.0, 1.0, |cosine| {
        let sine = (1.0 - cosine * cosine).sqrt();
        // Eight equal steps are exact for what turns at most twice around.
        let ring = (0..8).map(|step| {
            let (sin, cos) = (0.25 * std::f64::consts::PI * f64::from(step)).sin_cos();
            let direction = [0, 1, 2].map(|i| cosine * normal[i] + sine * (cos * u[i] + sin * v[i]));
            harmonics(direction).iter().zip(radiance).map(|(harmonic, part)| harmonic * part).sum::<f64>()
        });
        [cosine * 0.25 * std::f64::consts::PI * ring.sum::<f64>()]
    });
    sum
}

/// The mean irradiance over visible normals; the frame holds the axes that the tangent frame's slopes refer to.
pub fn over(visible: &Visible, radiance: [f64; 9], frame: [[f64; 3]; 3]) -> f64 {
    let [sum] = average(visible, |[sx, sy]| {
        let length = (1.0 + sx * sx + sy * sy).sqrt();
        let normal = [0, 1, 2].map(|i| (frame[2][i] - sx * frame[0][i] - sy * frame[1][i]) / length);
        [from_radiance(radiance, normal)]
    });
    sum
}

/// The mean of Lambert's cosine max(n · l, 0) of a directional light over visible normals. Where the cosine bends the
/// integral across the view is split.
pub fn lambert(visible: &Visible, light: [f64; 3]) -> f64 {
    let [ex, ey, fx, fy] = visible.factor();
    let from = (-visible.parameter()).max(-9.0);
    let to = (from.max(0.0).powi(2) + 80.0).sqrt();
    let [sum, whole] = integrate(from, to, (to - from) / 12.0, |u| {
        let rise = if visible.parameter().is_finite() { u + visible.parameter() } else { 1.0 };
        let weight = rise * (-0.5 * (u * u - from.max(0.0).powi(2))).exp();
        let (x, y) = (visible.mean[0] + ex * u, visible.mean[1] + ey * u);
        let (facing, change) = (light[2] - x * light[0] - y * light[1], -fx * light[0] - fy * light[1]);
        let bend = (-facing / change).clamp(-8.0, 8.0);
        let part = |from: f64, to: f64| {
            let [sum] = integrate(from, to, 2.0, |w| {
                let (sx, sy) = (x + fx * w, y + fy * w);
                let cosine = (facing + change * w).max(0.0) / (1.0 + sx * sx + sy * sy).sqrt();
                [cosine * density(w)]
            });
            sum
        };
        let bend = if bend.is_finite() { bend } else { 0.0 };
        [weight * (part(-8.0, bend) + part(bend, 8.0)), weight]
    });
    sum / whole
}

/// The mean of a normal variable where it is positive, 0 elsewhere.
pub fn ramp(center: f64, deviation: f64) -> f64 {
    let far = center.abs() + 20.0 * deviation;
    let map = PiecewiseLinear { knots: vec![(0.0, [0.0; 4], [0.0; 4]), (far, [far; 4], [far; 4])] };
    mean(&map, center, deviation)[0]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Irradiance is radiance with each order scaled by π, 2π/3 and π/4: Ramamoorthi and Hanrahan 2001, equation 8.
    #[test]
    fn orders_are_scaled() {
        let normal = [0.48, -0.6, 0.64];
        let scales = [1.0, 2.0 / 3.0, 0.25].map(|scale| scale * std::f64::consts::PI);
        for term in 0..9 {
            let mut radiance = [0.0; 9];
            radiance[term] = 1.3;
            let order = [0, 1, 1, 1, 2, 2, 2, 2, 2][term];
            let expected = 1.3 * scales[order] * harmonics(normal)[term];
            let found = from_radiance(radiance, normal);
            assert!((found - expected).abs() < 1e-9, "{term}: {found} {expected}");
        }
    }
}
