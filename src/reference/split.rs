//! The scalar u of visible slopes as two normal distributions that keep steps and kinks near.

use crate::reference::least::least;
use crate::reference::normal::{cumulative as below, density};
use crate::reference::slopes::standard::{cumulative, moments};

/// Places a deviation, and where the first and the last are.
const PLACES: i32 = 25;
const FIRST: i32 = -5;
const LAST: i32 = 6;

/// The mean of max(at − x, 0) over a normal variable x about 0.
fn excess(at: f64, deviation: f64) -> f64 {
    at * below(at / deviation) + deviation * density(at / deviation)
}

/// The two normal distributions with equal shares that have the mean and variance of u together, and the least sum of
/// eighth powers of the errors of steps and of twice those of kinks in deviations of u: mean and variance of the lower
/// one, then of the higher.
pub fn nearest(parameter: f64) -> [f64; 4] {
    let [mean, variance, _] = moments(parameter);
    let deviation = variance.sqrt();
    let step = 1.0 / f64::from(PLACES);
    let places: Vec<f64> = (FIRST * PLACES..=LAST * PLACES).map(|place| step * f64::from(place)).collect();
    let edges: Vec<f64> = places.iter().map(|z| mean + deviation * z).collect();
    let steps = cumulative(parameter, &edges);
    // The mean of max(z − v, 0) is the integral of the cumulative function, by trapezoids.
    let mut kinks = vec![0.0];
    for pair in steps.windows(2) {
        kinks.push(kinks[kinks.len() - 1] + 0.5 * step * (pair[0] + pair[1]));
    }
    let pair = |[apart, uneven]: [f64; 2]| {
        let rest = 1.0 - 0.25 * apart * apart;
        [-0.5 * apart, rest * (1.0 - uneven), 0.5 * apart, rest * (1.0 + uneven)]
    };
    let errors = |numbers: [f64; 2]| -> Vec<f64> {
        let [low, narrow, high, wide] = pair(numbers);
        let [narrow, wide] = [narrow, wide].map(|variance| variance.max(1e-9).sqrt());
        let step = |(&z, truth): (&f64, &f64)| 0.5 * (below((z - low) / narrow) + below((z - high) / wide)) - truth;
        let kink = |(&z, truth): (&f64, &f64)| excess(z - low, narrow) + excess(z - high, wide) - 2.0 * truth;
        places.iter().zip(&steps).map(step).chain(places.iter().zip(&kinks).map(kink)).collect()
    };
    let [low, narrow, high, wide] = pair(least([1.1, 0.4], errors));
    [mean + low * deviation, narrow * variance, mean + high * deviation, wide * variance]
}
