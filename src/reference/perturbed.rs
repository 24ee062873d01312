//! Ch of heights with noise on them: the mean of a color map over the sum of a visible height and independent normal
//! noise, section 5.1 of Heitz et al. 2014, in both orders of integration.

use super::height;
use super::heights::{cumulative, density, moments, range};
use super::normal::density as normal_density;
use super::quadrature::integrate;
use super::tails;
use super::texture::{self, PiecewiseLinear};

/// The mean of the map over the visible heights with normal noise of a mean and a deviation on them.
///
/// Integrates last over what spreads less, for the inner mean to be the smoother one.
pub fn mean(map: &PiecewiseLinear, mean: f64, deviation: f64, lambda: f64, noise: [f64; 2]) -> [f64; 4] {
    if noise[1] < deviation {
        over_noise(map, mean, deviation, lambda, noise)
    } else {
        over_heights(map, mean, deviation, lambda, noise)
    }
}

/// The integral over the noise of the mean over heights. Error below 1e-10 for noise that spreads no more than they.
pub fn over_noise(map: &PiecewiseLinear, mean: f64, deviation: f64, lambda: f64, noise: [f64; 2]) -> [f64; 4] {
    integrate(-8.5, 8.5, 1.0, |z| {
        let color = height::mean(map, mean + noise[0] + noise[1] * z, deviation, lambda);
        color.map(|channel| normal_density(z) * channel)
    })
}

/// The integral over heights of the mean over the noise. Error below 1e-10 for noise that spreads no less than they.
pub fn over_heights(map: &PiecewiseLinear, mean: f64, deviation: f64, lambda: f64, noise: [f64; 2]) -> [f64; 4] {
    let [low, high] = range(lambda);
    integrate(low, high, (high - low) / 16.0, |z| {
        let color = texture::mean(map, mean + noise[0] + deviation * z, noise[1]);
        color.map(|channel| density(z, lambda) * channel)
    })
}

/// [`tails::nearest_tails`] of visible heights with noise of a deviation in those of all heights on them, where the
/// sum has the deviation given first.
pub fn nearest_tails(deviation: f64, lambda: f64, noise_deviation: f64) -> [f64; 10] {
    let [mean, own, ..] = moments(lambda);
    let [from, to] = range(lambda);
    let reach = 8.0 * noise_deviation;
    tails::tails(deviation, [mean, own.hypot(noise_deviation)], [from - reach, to + reach], |at| {
        let [below] = integrate(-8.0, 8.0, 2.0, |z| [normal_density(z) * cumulative(at - noise_deviation * z, lambda)]);
        below
    })
}
