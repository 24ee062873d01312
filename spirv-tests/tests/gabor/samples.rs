//! Means and variances over footprints from samples of the unfiltered noise on the device.

use prefilter::gpu::Device;
use prefilter::Module;
use spirv_tests::random::Random;

use crate::{moved, statistics, Found};

/// Values of the unfiltered noise at points.
pub fn values(device: &Device, module: &Module, points: &[[f64; 3]]) -> Found<Vec<f64>> {
    let footprints: Vec<[[f64; 3]; 3]> = points.iter().map(|&point| [point, [0.0; 3], [0.0; 3]]).collect();
    Ok(statistics(device, module, &footprints)?.into_iter().map(|[value, _]| value).collect())
}

/// The mean over footprints of the variance within them, by pairs of points of each, and its standard error.
pub fn within(device: &Device, module: &Module, footprints: &[[[f64; 3]; 3]], seed: u32) -> Found<[f64; 2]> {
    let mut random = Random::new(seed);
    let pair = |[at, across, along]: &[[f64; 3]; 3]| [0, 1].map(|_| moved(&mut random, *at, [*across, *along]));
    let points: Vec<[f64; 3]> = footprints.iter().flat_map(pair).collect();
    let values = values(device, module, &points)?;
    let halves = || values.chunks_exact(2).map(|pair| 0.5 * (pair[0] - pair[1]).powi(2));
    let count = footprints.len() as f64;
    let mean = halves().sum::<f64>() / count;
    let spread = halves().map(|half| (half - mean).powi(2)).sum::<f64>() / count;
    Ok([mean, (spread / count).sqrt()])
}

/// Mean and variance within each footprint, from `count` stratified points of each.
pub fn each(
    device: &Device,
    module: &Module,
    footprints: &[[[f64; 3]; 3]],
    side: usize,
    seed: u32,
) -> Found<Vec<[f64; 2]>> {
    let mut random = Random::new(seed);
    let mut points = Vec::with_capacity(footprints.len() * side * side);
    for [at, across, along] in footprints {
        for stratum in 0..side * side {
            let [u, v] = [stratum % side, stratum / side].map(|index| (index as f64 + random.unit()) / side as f64);
            let length = (-2.0 * (1.0 - u).ln()).sqrt();
            let (sin, cos) = (std::f64::consts::TAU * v).sin_cos();
            points.push([0, 1, 2].map(|axis| at[axis] + length * (cos * across[axis] + sin * along[axis])));
        }
    }
    let values = values(device, module, &points)?;
    let moments = values.chunks_exact(side * side).map(|values| {
        let count = values.len() as f64;
        let mean = values.iter().sum::<f64>() / count;
        [mean, values.iter().map(|value| (value - mean).powi(2)).sum::<f64>() / count]
    });
    Ok(moments.collect())
}
