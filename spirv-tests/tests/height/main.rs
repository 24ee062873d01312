//! Color by height: each tier on the device against the f64 integral, from directions to colors.

mod anywhere;
mod driven;
mod extremes;
mod figures;
mod percentile;
mod perturbed;
mod scenes;
mod skewed;
mod tilted;
mod visibility;

use std::error::Error;

use prefilter::gpu::Device;
use prefilter::reference::height::mean;
use prefilter::reference::perturbed::mean as perturbed_mean;
use prefilter::reference::smith::Along;
use prefilter::reference::texture::PiecewiseLinear;
use prefilter::reference::visibility::{azimuth, independence};
use prefilter::{ColorMap, Kernel, Ranges, Scene, Tier};
use spirv_tests::exports::ExportKernel;
use spirv_tests::random::Random;

type Fault = Box<dyn Error + Send + Sync>;
type Outcome = Result<(), Fault>;

const FAST: Tier = Tier::ClosedForm(Kernel::Fast);
const EXACT: Tier = Tier::ClosedForm(Kernel::Exact);

/// A unit vector above the horizon; its height over it is even in its logarithm down to 1e-6, or in itself.
fn direction(random: &mut Random) -> [f32; 3] {
    let z = if random.pick([true, false]) { random.between(1e-6, 1.0) } else { random.unit() };
    let (radius, azimuth) = (((1.0 - z) * (1.0 + z)).sqrt(), std::f64::consts::TAU * random.unit());
    [radius * azimuth.cos(), radius * azimuth.sin(), z].map(|value| value as f32)
}

/// Slope deviations from 0.05 to 1.5 and correlations up to 0.9.
fn covariance(random: &mut Random) -> [f32; 3] {
    let [x, y] = [random.between(0.05, 1.5), random.between(0.05, 1.5)];
    let correlation = 0.9 * (2.0 * random.unit() - 1.0);
    [x * x, correlation * x * y, y * y].map(|value| value as f32)
}

/// A call of `NAME_height` with its sum of Λ.
#[derive(Clone)]
struct Call {
    numbers: [f32; 11],
    /// That of the mean surface, for scenes that take it.
    mean_slope: [f32; 2],
    /// Mean and deviation of the noise, likewise.
    noise: [f32; 2],
    /// Λ of view and light.
    parts: [f64; 2],
    lambda: f64,
}

/// Λ of a direction by its definition: the quadrature over slopes.
fn lambda(direction: [f32; 3], covariance: [f32; 3]) -> f64 {
    along(direction, covariance, [0.0; 2]).lambda()
}

fn along(direction: [f32; 3], covariance: [f32; 3], mean_slope: [f32; 2]) -> Along {
    Along::new(direction.map(f64::from), covariance.map(f64::from), mean_slope.map(f64::from))
}

impl Call {
    fn new(mean: f32, deviation: f32, [xx, xy, yy]: [f32; 3], view: [f32; 3], light: [f32; 3]) -> Self {
        let parts = [view, light].map(|direction| lambda(direction, [xx, xy, yy]));
        let ([a, b, c], [d, e, f]) = (view, light);
        let numbers = [mean, deviation, xx, xy, yy, a, b, c, d, e, f];
        Self { numbers, mean_slope: [0.0; 2], noise: [0.0; 2], parts, lambda: parts[0] + parts[1] }
    }

    fn three(&self, at: usize) -> [f32; 3] {
        [self.numbers[at], self.numbers[at + 1], self.numbers[at + 2]]
    }

    /// The same over a mean surface with a slope, where both directions win as much over it as bounds ask for.
    fn tilted(self, mean_slope: [f32; 2]) -> Option<Self> {
        let rise = |[x, y, z]: [f32; 3]| z - x * mean_slope[0] - y * mean_slope[1];
        let directions = [self.three(5), self.three(8)];
        if directions.iter().any(|&direction| rise(direction) < 0.0101) {
            return None;
        }
        let parts = directions.map(|direction| along(direction, self.three(2), mean_slope).lambda());
        Some(Self { mean_slope, parts, lambda: parts[0] + parts[1], ..self })
    }

    /// The numbers that an export takes, by its signature.
    fn arguments(&self, signature: &str) -> Vec<f32> {
        let part = |name: &str, numbers: &[f32]| if signature.contains(name) { numbers.to_vec() } else { Vec::new() };
        let (heights, slopes) = (part("(mean:", &self.numbers[..2]), &self.numbers[2..8]);
        let (noise, tilt) = (part("noise_mean:", &self.noise), part("mean_slope:", &self.mean_slope));
        let light = part("light:", &self.numbers[8..]);
        [heights, noise, tilt, slopes.to_vec(), light].concat()
    }

    /// Heights with noise whose sum has the mean and the deviation that the heights had: those have a mean of their own
    /// and a share of the variance.
    fn perturbed(mut self, mean: f32, share: f64) -> Self {
        let [at, deviation, ..] = self.numbers;
        let part = |share: f64| (0.999_999 * f64::from(deviation) * share.sqrt()) as f32;
        self.noise = [at - mean, part(1.0 - share)];
        self.numbers[..2].copy_from_slice(&[mean, part(share)]);
        self
    }

    /// The map's mean by quadratures.
    fn truth(&self, map: &PiecewiseLinear) -> [f64; 4] {
        let [at, deviation, ..] = self.numbers.map(f64::from);
        match self.noise {
            [0.0, 0.0] => mean(map, at, deviation, self.lambda),
            noise => perturbed_mean(map, at, deviation, self.lambda, noise.map(f64::from)),
        }
    }

    /// The same where nothing casts shadows.
    fn unlit(self) -> Self {
        Self { lambda: self.parts[0], ..self }
    }

    /// The same with visibilities that are correlated by their azimuths.
    fn hot(self) -> Self {
        let direction = |at: usize| self.three(at).map(f64::from);
        let independence = independence(azimuth(direction(5), direction(8)));
        let [seen, lit] = self.parts;
        Self { lambda: seen.max(lit) + independence * seen.min(lit), ..self }
    }
}

/// Calls within ranges from a deviation on: heights about the map's knots and anywhere, Λ up to 1e4.
fn calls(random: &mut Random, map: &ColorMap, ranges: Ranges, floor: f32, count: usize) -> Vec<Call> {
    let (low, high) = ranges.mean;
    let mut calls = Vec::new();
    while calls.len() < count {
        let deviation = random.between(floor.into(), ranges.deviation.into());
        let knot = f64::from(map.knots()[random.word() as usize % map.knots().len()].position);
        let at = match random.word() % 3 {
            0 => f64::from(low) + random.unit() * f64::from(high - low),
            _ => knot - deviation * (8.0 * random.unit() - 2.5),
        };
        let (deviation, at) = ((deviation as f32).min(ranges.deviation), at as f32);
        let call = Call::new(at, deviation, covariance(random), direction(random), direction(random));
        if (low..=high).contains(&at) && deviation >= floor && call.lambda <= 1e4 {
            calls.push(call);
        }
    }
    calls
}

/// The largest error of a scene's colors, which stay in the map's hull.
fn error(device: &Device, scene: &Scene, calls: &[Call]) -> Result<f64, Fault> {
    let (module, map) = (scene.module()?, scene.map().ok_or("no map")?);
    let export = &module.exports()[0];
    let numbers: Vec<f32> = calls.iter().flat_map(|call| call.arguments(&export.signature)).collect();
    let colors = ExportKernel::new(device, &module, export)?.run(&numbers)?;
    let (reference, (low, high)) = (map.reference(), map.hull());
    assert!(!colors.is_empty() && colors.len() == calls.len());
    let halves = if module.tables().is_empty() { 0.0 } else { 5e-4 };
    let mut worst = 0.0f64;
    for (color, call) in colors.iter().zip(calls) {
        let truth = call.truth(&reference);
        for channel in 0..map.channels() {
            let slack = halves * high[channel].abs().max(low[channel].abs());
            let hull = low[channel] - slack..=high[channel] + slack;
            assert!(hull.contains(&color[channel]), "{color:?} leaves the hull at {:?}", call.numbers);
            worst = worst.max((f64::from(color[channel]) - truth[channel]).abs());
        }
    }
    Ok(worst)
}
