//! Roughness: mean squares of the slopes of Beckmann's distribution, by quadrature.

use std::f64::consts::PI;

use super::footprint::variance_along;
use super::quadrature::integrate;

/// Mean square of one component of the slopes of Beckmann's distribution, exp(−s²/α²)/(π α²).
fn component(roughness: f64) -> f64 {
    let ring = |slope: f64| {
        // The mean square of a component over a ring is half its square.
        let density = libm::exp(-slope * slope) / PI;
        [2.0 * PI * slope * density * 0.5 * slope * slope]
    };
    let [unit] = integrate(0.0, 7.0, 0.5, ring);
    unit * roughness * roughness
}

/// The roughness of the Beckmann distribution whose slopes have a mean square along an axis.
fn of_component(square: f64) -> f64 {
    (square / component(1.0)).sqrt()
}

/// The roughness with the mean square of all directions when slopes of a covariance are added.
pub fn round(roughness: f64, covariance: [f64; 3]) -> f64 {
    let directions = [0.1, 0.6].map(|turn: f64| variance_along(covariance, [(PI * turn).cos(), (PI * turn).sin()]));
    of_component(component(roughness) + 0.5 * (directions[0] + directions[1]))
}

/// The roughness along an axis when slopes of that deviation there are added.
pub fn along(roughness: f64, deviation: f64) -> f64 {
    of_component(component(roughness) + deviation * deviation)
}
