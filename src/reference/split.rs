//! The scalar u of visible slopes as two normal distributions less a narrow one, which keep steps and kinks near.

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

/// Normal distributions: mean, variance and weight of each.
type Split = [[f64; 3]; 3];

/// Two of equal weights less a third of the weight `less`, of the mean 0 and the variance 1 together: how far apart the
/// two are, and by how much the higher one is wider.
fn split([apart, uneven, less]: [f64; 3], [mean, variance]: [f64; 2]) -> Split {
    let weight = 0.5 * (1.0 + less);
    let middle = 0.5 * less * mean / weight;
    let second = 1.0 + less * (variance + mean * mean);
    let rest = 0.5 * second / weight - middle * middle - 0.25 * apart * apart;
    let of = |side: f64| [middle + 0.5 * side * apart, rest * (1.0 + side * uneven), weight];
    [of(-1.0), of(1.0), [mean, variance, -less]]
}

/// The two normal distributions with equal weights and the third, of a given mean and variance in deviations of u, that
/// have the mean and variance of u together and the least sum of eighth powers of the errors of steps and of twice
/// those of kinks in deviations of u.
pub fn nearest(parameter: f64, third: [f64; 2]) -> [[f64; 3]; 3] {
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
    let errors = |numbers: [f64; 3]| -> Vec<f64> {
        let split = split(numbers, third).map(|[mean, variance, weight]| (mean, variance.max(1e-9).sqrt(), weight));
        let sum = |of: &dyn Fn(f64, f64) -> f64, z: f64| {
            split.iter().map(|&(mean, deviation, weight)| weight * of(z - mean, deviation)).sum::<f64>()
        };
        let step = |(&z, truth): (&f64, &f64)| sum(&|at, deviation| below(at / deviation), z) - truth;
        let kink = |(&z, truth): (&f64, &f64)| 2.0 * (sum(&excess, z) - truth);
        places.iter().zip(&steps).map(step).chain(places.iter().zip(&kinks).map(kink)).collect()
    };
    let found = split(least([0.9, 0.25, 0.05], errors), third);
    found.map(|[at, width, weight]| [mean + deviation * at, variance * width, weight])
}
