//! Two normal distributions of one deviation, found from the moments of their mixture by bisection.

/// How far apart the two are at most for the sake of the excess kurtosis, in deviations of both together.
pub const FARTHEST: f64 = 32.0;

/// The largest share of the variance that lies between the two.
pub const LARGEST_SHARE: f64 = 0.999;

/// Two normal distributions in units of the deviation and about the mean of both together.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pair {
    /// The means, the higher one first.
    pub offsets: [f64; 2],
    /// How much of the whole each is.
    pub weights: [f64; 2],
    /// The deviation of each.
    pub deviation: f64,
}

impl Pair {
    /// Two of mean 0 and deviation 1 together, where the share `between` of the variance lies between them and the
    /// higher one is `ratio` times as far from the mean as the lower one.
    fn new(between: f64, ratio: f64) -> Self {
        let lower = (between / ratio).sqrt();
        let share = 1.0 / (1.0 + ratio);
        let offsets = [ratio * lower, -lower];
        Self { offsets, weights: [share, 1.0 - share], deviation: (1.0 - between).sqrt() }
    }

    /// Mean, variance, skewness and excess kurtosis, from the moments of each.
    pub fn moments(&self) -> [f64; 4] {
        let v = self.deviation * self.deviation;
        let mut raw = [0.0; 4];
        for (weight, x) in self.weights.into_iter().zip(self.offsets) {
            let own = [x, x * x + v, x.powi(3) + 3.0 * x * v, x.powi(4) + 6.0 * x * x * v + 3.0 * v * v];
            raw.iter_mut().zip(own).for_each(|(sum, moment)| *sum += weight * moment);
        }
        let [mean, second, third, fourth] = raw;
        let variance = second - mean * mean;
        let skewness = third - 3.0 * mean * second + 2.0 * mean.powi(3);
        let kurtosis = fourth - 4.0 * mean * third + 6.0 * mean * mean * second - 3.0 * mean.powi(4);
        [mean, variance, skewness / variance.powf(1.5), kurtosis / (variance * variance) - 3.0]
    }

    /// The mixture with a skewness and an excess kurtosis, or else with that skewness and the nearest excess kurtosis
    /// of two that are as wide as [`LARGEST_SHARE`] leaves and no farther apart than [`FARTHEST`] for its sake.
    ///
    /// The excess kurtosis falls with the share between the two, and at a share the skewness rises with the ratio.
    /// Error below 1e-9 of one more than the result.
    pub fn with(skewness: f64, kurtosis: f64) -> Self {
        let skewed = |between: f64| {
            let lower = |logarithm: f64| Self::new(between, libm::exp(logarithm)).moments()[2] < skewness;
            let ratio = bisected([-40.0, 40.0], lower);
            Self::new(between, libm::exp(ratio))
        };
        if skewness == 0.0 && kurtosis >= 0.0 {
            return Self { offsets: [0.0; 2], weights: [0.5; 2], deviation: 1.0 };
        }
        let least = (skewness.abs() / FARTHEST).clamp(1e-9, LARGEST_SHARE);
        let logarithm = bisected([libm::log(least), libm::log(LARGEST_SHARE)], |logarithm| {
            skewed(libm::exp(logarithm)).moments()[3] > kurtosis
        });
        skewed(libm::exp(logarithm))
    }
}

/// Where a condition that holds at the low end stops to hold; an end where it holds or fails throughout.
fn bisected([mut low, mut high]: [f64; 2], holds: impl Fn(f64) -> bool) -> f64 {
    for _ in 0..44 {
        let middle = 0.5 * (low + high);
        if holds(middle) {
            low = middle;
        } else {
            high = middle;
        }
    }
    0.5 * (low + high)
}
