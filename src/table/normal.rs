//! The standard normal distribution, tabulated for whoever asks for it at many places.

use std::sync::OnceLock;

use crate::reference::normal::{cumulative, density};

/// Places a deviation, and the last deviation. The cubic between two places is off by less than h⁴/384 times the
/// largest fourth derivative, 3φ(0) of the density and less of the others: by 2e-10.
const PLACES: usize = 64;
const LAST: usize = 9;

/// The mean excess over a value, the probability below it, and the density there.
type Known = [f64; 3];

/// What is known at the places on both sides of a value that is not negative, and its part of their distance; `None`
/// for values beyond the last.
fn beside(value: f64) -> Option<(&'static [Known; 2], f64)> {
    static ALL: OnceLock<Vec<Known>> = OnceLock::new();
    let known = |place: usize| {
        let at = place as f64 / PLACES as f64;
        [density(at) - at * cumulative(-at), cumulative(at), density(at)]
    };
    let place = value * PLACES as f64;
    if !(place < (LAST * PLACES) as f64) {
        return None;
    }
    let all = ALL.get_or_init(|| (0..=LAST * PLACES).map(known).collect());
    all.get(place as usize..)?.first_chunk().map(|both| (both, place.fract()))
}

/// The cubic through both ends with the slopes there, of a distance of 1.
fn cubic([from, to]: [f64; 2], [start, end]: [f64; 2], at: f64) -> f64 {
    let (rise, left) = (to - from, 1.0 - at);
    from + at * (rise + left * (left * (start - rise) + at * (rise - end)))
}

/// The mean of max(z − value, 0) over a standard normal variable z, of a value that is not negative.
pub(super) fn excess(value: f64) -> f64 {
    let falls = |known: Known| (known[1] - 1.0) / PLACES as f64;
    beside(value).map_or(0.0, |(both, at)| cubic(both.map(|known| known[0]), both.map(falls), at))
}

/// The probability that a standard normal variable is below a value that is not negative, and its density there.
pub(super) fn below(value: f64) -> [f64; 2] {
    let step = 1.0 / PLACES as f64;
    let Some((&both, at)) = beside(value) else { return [1.0, 0.0] };
    let first = value - at * step;
    let rises = both.map(|known| step * known[2]);
    let falls = [-first * rises[0], -(first + step) * rises[1]];
    [cubic(both.map(|known| known[1]), rises, at), cubic(both.map(|known| known[2]), falls, at)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reference::normal;

    #[test]
    fn values_are_those_of_the_reference() {
        for index in 0..20_000 {
            let value = 1e-3 * f64::from(index) / 1.7;
            let [probability, height] = below(value);
            let apart = (probability - cumulative(value)).abs().max((height - density(value)).abs());
            assert!(apart < 2e-10, "{value}: {apart:e}");
        }
        for index in 0..400 {
            let value = 0.03 * f64::from(index) / 1.1;
            let apart = (excess(value) - normal::excess(value)).abs();
            assert!(apart < 1e-10, "{value}: {apart:e}");
        }
        assert_eq!((below(f64::INFINITY), excess(f64::INFINITY)), ([1.0, 0.0], 0.0));
    }
}
