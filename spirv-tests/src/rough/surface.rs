//! The rough surface: a sum of plane waves with random phases. Heights are in units of their deviation, and so is the
//! ground.

use crate::imaging::waves::{Spread, Waves};

/// The waves: enough for heights near normal. Variances fall with wave numbers that are spread evenly in logarithm, so
/// that the density of variance over plane wave vectors falls with their third power as of many reliefs.
const SPREAD: Spread = Spread { count: 128, periods: [6.0, 96.0], falling: -0.5 };

/// Deviation of slopes along either axis, about: masking and shadowing matter, and overhangs do not.
pub const SLOPE_DEVIATION: f64 = 0.6;

/// The surface of a seed: heights of mean 0 and variance 1.
pub fn surface(seed: u32) -> Waves {
    let waves = Waves::new(SPREAD, 1.0, seed);
    Waves { period: waves.slope_variance().sqrt() / SLOPE_DEVIATION, ..waves }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slopes_have_their_deviation() {
        let slopes = surface(3).slope_variance();
        assert!((slopes - SLOPE_DEVIATION.powi(2)).abs() < 1e-9, "{slopes}");
    }
}
