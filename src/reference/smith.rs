//! Smith's Λ: the definition by quadrature over slopes, and directions by their angles.

use super::normal::{density, REACH};
use super::quadrature::integrate;

/// The slope of a direction and the slopes of the surface along its azimuth φ.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Along {
    /// cot θ, θ being the angle from the macroscopic normal; infinite along it.
    pub cotangent: f64,
    /// The mean of the surface's slopes along φ.
    pub mean: f64,
    /// The deviation of the surface's slopes along φ.
    pub deviation: f64,
}

impl Along {
    /// The surface along a unit direction; covariances are (xx, xy, yy), normals ∝ (−s.x, −s.y, 1) for a slope s.
    pub fn new(direction: [f64; 3], covariance: [f64; 3], mean_slope: [f64; 2]) -> Self {
        let [x, y, z] = direction;
        let theta = libm::atan2(libm::hypot(x, y), z);
        let (sin, cos) = libm::sincos(libm::atan2(y, x));
        let [xx, xy, yy] = covariance;
        let variance = cos * cos * xx + sin * sin * yy + 2.0 * cos * sin * xy;
        Self {
            cotangent: if theta == 0.0 { f64::INFINITY } else { libm::cos(theta) / libm::sin(theta) },
            mean: cos * mean_slope[0] + sin * mean_slope[1],
            deviation: variance.max(0.0).sqrt(),
        }
    }

    /// The visibility parameter (cot θ − mean) / (√2 deviation): infinite where nothing is hidden, not positive at and
    /// below the horizon of the mean surface.
    pub fn parameter(self) -> f64 {
        (self.cotangent - self.mean) / (std::f64::consts::SQRT_2 * self.deviation)
    }

    /// Smith's Λ by its definition: ∫ (s − cot θ) p(s) ds over steeper slopes s, divided by cot θ − mean.
    ///
    /// For directions above the horizon and deviations above 0.
    pub fn lambda(self) -> f64 {
        let Self { cotangent, mean, deviation } = self;
        let rise = cotangent - mean;
        let to = (mean + REACH * deviation).max(cotangent + 3.0 * deviation);
        let [excess] = integrate(cotangent, to, deviation, |slope| {
            [(slope - cotangent) * density((slope - mean) / deviation) / deviation]
        });
        excess / rise
    }
}

/// Smith's Λ for a visibility parameter above 0, by quadrature of its definition for slopes of the deviation 1.
pub fn lambda(parameter: f64) -> f64 {
    Along { cotangent: std::f64::consts::SQRT_2 * parameter, mean: 0.0, deviation: 1.0 }.lambda()
}

/// Smith's Λ for a visibility parameter above 0, from libm's complementary error function.
///
/// Cancels: the relative error grows as the square of the parameter.
///
/// Source: Heitz et al. 2014, "Filtering Non-Linear Transfer Functions on Surfaces", equation 2.
pub fn lambda_by_parts(parameter: f64) -> f64 {
    let a = parameter;
    (-a * a).exp() / (2.0 * std::f64::consts::PI.sqrt() * a) - 0.5 * libm::erfc(a)
}
