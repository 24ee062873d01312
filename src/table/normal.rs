//! The standard normal distribution, tabulated for whoever asks for it at many places.

use std::sync::OnceLock;

use crate::reference::normal::{cumulative, density};

/// Steps of the tabulation up to the last value: the cubic between two is off by less than 1e-10.
const STEPS: usize = 1024;
const LAST: f64 = 9.0;

/// The probability that a standard normal variable is below a value that is not negative, and its density there.
pub(super) fn below(value: f64) -> [f64; 2] {
    static NODES: OnceLock<Vec<[f64; 2]>> = OnceLock::new();
    let step = LAST / STEPS as f64;
    let node = |index: usize| step * index as f64;
    let nodes =
        NODES.get_or_init(|| (0..=STEPS).map(|index| [cumulative(node(index)), density(node(index))]).collect());
    let place = value / step;
    if !(place < STEPS as f64) {
        return [1.0, 0.0];
    }
    let index = place as usize;
    let ([from, to], t) = ([nodes[index], nodes[index + 1]], place - index as f64);
    // The cubics through both values with both slopes, which are φ of Φ and −zφ of φ.
    let between = |at: usize, slopes: [f64; 2]| {
        let rise = to[at] - from[at];
        let [start, end] = [step * slopes[0] - rise, rise - step * slopes[1]];
        from[at] + t * (rise + (1.0 - t) * ((1.0 - t) * start + t * end))
    };
    let falls = [-node(index) * from[1], -node(index + 1) * to[1]];
    [between(0, [from[1], to[1]]), between(1, falls)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_are_those_of_the_reference() {
        for index in 0..20_000 {
            let value = 1e-3 * f64::from(index) / 1.7;
            let [probability, height] = below(value);
            let apart = (probability - cumulative(value)).abs().max((height - density(value)).abs());
            assert!(apart < 1e-10, "{value}: {apart:e}");
        }
        assert_eq!(below(f64::INFINITY), [1.0, 0.0]);
    }
}
