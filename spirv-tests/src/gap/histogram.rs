//! Weighted heights: their moments and how they are distributed.

use prefilter::reference::normal::cumulative as normal_cumulative;

const BINS: usize = 2400;
/// Heights beyond are counted at the end.
const REACH: f64 = 6.0;

/// Weighted heights in bins of 0.005, with exact sums of their powers.
#[derive(Clone, Debug)]
pub struct Histogram {
    bins: Vec<f64>,
    powers: [f64; 4],
}

impl Default for Histogram {
    fn default() -> Self {
        Self { bins: vec![0.0; BINS], powers: [0.0; 4] }
    }
}

impl Histogram {
    /// Adds a weight at a height.
    pub fn add_height(&mut self, height: f64, weight: f64) {
        let bin = (height + REACH) * (BINS as f64 / (2.0 * REACH));
        self.bins[bin.clamp(0.0, BINS as f64 - 1.0) as usize] += weight;
        let mut term = weight;
        for power in &mut self.powers {
            *power += term;
            term *= height;
        }
    }

    /// Adds a weight spread evenly between two heights, by Gauss's two points: exact up to the third power.
    pub fn add_ramp(&mut self, from: f64, to: f64, weight: f64) {
        let (middle, off) = (0.5 * (from + to), (to - from) * (0.5 / 3f64.sqrt()));
        self.add_height(middle - off, 0.5 * weight);
        self.add_height(middle + off, 0.5 * weight);
    }

    /// Adds another one.
    pub fn add(&mut self, other: &Self) {
        self.bins.iter_mut().zip(&other.bins).for_each(|(bin, other)| *bin += other);
        self.powers.iter_mut().zip(other.powers).for_each(|(power, other)| *power += other);
    }

    /// The whole weight.
    pub fn weight(&self) -> f64 {
        self.powers[0]
    }

    /// Mean, deviation and skewness.
    pub fn moments(&self) -> [f64; 3] {
        let [mean, second, third] = [1, 2, 3].map(|power| self.powers[power] / self.powers[0]);
        let variance = second - mean * mean;
        [mean, variance.sqrt(), (third - mean * (3.0 * variance + mean * mean)) / variance.powf(1.5)]
    }

    /// The shares below some rising heights, of a bin that holds one in proportion.
    pub fn below(&self, heights: &[f64]) -> Vec<f64> {
        let mut sums = Vec::with_capacity(BINS + 1);
        let mut sum = 0.0;
        sums.push(0.0);
        for bin in &self.bins {
            sum += bin / self.powers[0];
            sums.push(sum);
        }
        let at = |height: &f64| {
            let place = ((height + REACH) * (BINS as f64 / (2.0 * REACH))).clamp(0.0, BINS as f64 - 1e-6);
            let bin = place as usize;
            sums[bin] + place.fract() * (sums[bin + 1] - sums[bin])
        };
        heights.iter().map(at).collect()
    }

    /// The largest difference between the share of these heights below a height and a cumulative function. What `all`
    /// heights of the same fields lack of a normal distribution is taken off: chance, which both have.
    pub fn step_error(&self, all: &Self, cumulative: impl Fn(f64) -> f64) -> f64 {
        self.step_error_of(all, normal_cumulative, cumulative)
    }

    /// The same for quantities of which `all` are distributed as `ideal` says but for chance.
    pub fn step_error_of(&self, all: &Self, ideal: impl Fn(f64) -> f64, cumulative: impl Fn(f64) -> f64) -> f64 {
        let (mut below, mut all_below, mut worst) = (0.0, 0.0, 0f64);
        for (index, (bin, all_bin)) in self.bins.iter().zip(&all.bins).enumerate() {
            below += bin / self.powers[0];
            all_below += all_bin / all.powers[0];
            let height = (index + 1) as f64 * (2.0 * REACH / BINS as f64) - REACH;
            let chance = all_below - ideal(height);
            worst = worst.max((below - chance - cumulative(height)).abs());
        }
        worst
    }
}
