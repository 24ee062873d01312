//! Shares of a rough surface that are seen and lit: integrals over its heights h, of which P(h)^Λ are in sight.

use super::normal::density;
use super::quadrature::integrate;

/// Beyond this many deviations lies less than 1e-18 of the heights.
const HEIGHTS: f64 = 9.0;

/// ln P(h): above the mean by way of the rest 1 − P, whose digits P has lost.
fn logarithm(height: f64) -> f64 {
    let rest = 0.5 * libm::erfc(height.abs() * std::f64::consts::FRAC_1_SQRT_2);
    if height < 0.0 {
        rest.ln()
    } else {
        libm::log1p(-rest)
    }
}

/// The share of all points in sight, ∫ p(h) P(h)^Λ dh. For two directions Λ is the sum of theirs.
pub fn masking(lambda: f64) -> f64 {
    let [share] = integrate(-HEIGHTS, HEIGHTS, 0.5, |h| [density(h) * (lambda * logarithm(h)).exp()]);
    share
}

/// The share of the seen points that are lit: ∫ p P^Λo P^Λi dh / ∫ p P^Λo dh.
pub fn shadowing(view_lambda: f64, light_lambda: f64) -> f64 {
    let [lit, seen] = integrate(-HEIGHTS, HEIGHTS, 0.5, |h| {
        let logarithm = logarithm(h);
        let seen = density(h) * (view_lambda * logarithm).exp();
        [seen * (light_lambda * logarithm).exp(), seen]
    });
    lit / seen
}

/// The angle in [0, π] between the azimuths of two directions.
pub fn azimuth(view: [f64; 3], light: [f64; 3]) -> f64 {
    let apart = (libm::atan2(view[1], view[0]) - libm::atan2(light[1], light[0])).abs();
    apart.min(std::f64::consts::TAU - apart)
}

/// How independent the visibilities of two directions are whose azimuths are that far apart.
///
/// Source: van Ginneken, Stavridi and Koenderink 1998, "Diffuse and specular reflectance from rough surfaces".
pub fn independence(azimuth: f64) -> f64 {
    1.0 - 1.0 / (1.0 + 4.41 * azimuth)
}
