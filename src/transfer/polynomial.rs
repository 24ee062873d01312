//! A piece of a curve: a cubic between two values.

/// A polynomial of degree 3 or less of t = (f − origin)/unit, for f from `from` up to `to`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Piece {
    /// The least f; −∞ of the first piece.
    pub from: f64,
    /// Where the next piece begins; ∞ of the last.
    pub to: f64,
    /// Where t is 0: the finite end, `from` of two; 0 without any.
    pub origin: f64,
    /// How far f goes while t grows by 1: the length of a piece with two ends, 1 otherwise.
    pub unit: f64,
    /// Of 1, t, t² and t³.
    pub coefficients: [f64; 4],
}

impl Piece {
    /// The piece between two values, in powers of t that runs from 0 to 1.
    pub fn between(from: f64, to: f64, coefficients: [f64; 4]) -> Self {
        Self { from, to, origin: from, unit: to - from, coefficients }
    }

    /// The piece below a value, in powers of the distance to it.
    pub fn below(to: f64, coefficients: [f64; 4]) -> Self {
        Self { from: f64::NEG_INFINITY, to, origin: to, unit: 1.0, coefficients }
    }

    /// The piece from a value on, in powers of the distance from it.
    pub fn above(from: f64, coefficients: [f64; 4]) -> Self {
        Self { from, to: f64::INFINITY, origin: from, unit: 1.0, coefficients }
    }

    /// The piece that is all of a curve.
    pub fn everywhere(coefficients: [f64; 4]) -> Self {
        Self { from: f64::NEG_INFINITY, to: f64::INFINITY, origin: 0.0, unit: 1.0, coefficients }
    }

    /// The cubic between two values with the heights and the slopes of its ends.
    pub fn hermite([from, to]: [f64; 2], [low, high]: [f64; 2], slopes: [f64; 2]) -> Self {
        let rise = high - low;
        let [start, end] = slopes.map(|slope| slope * (to - from));
        Self::between(from, to, [low, start, 3.0 * rise - 2.0 * start - end, start + end - 2.0 * rise])
    }

    /// The height at a value, a limit at an infinite one.
    pub fn height(&self, value: f64) -> f64 {
        horner(&self.coefficients, (value - self.origin) / self.unit)
    }

    /// The slope at a value, a limit at an infinite one.
    pub fn slope(&self, value: f64) -> f64 {
        horner(&self.derivative(), (value - self.origin) / self.unit) / self.unit
    }

    /// Whether it has the slope 0.
    pub fn is_level(&self) -> bool {
        self.coefficients[1..].iter().all(|coefficient| *coefficient == 0.0)
    }

    /// Height and slope at a finite value.
    pub fn at(&self, value: f64) -> (f64, f64) {
        let ([a, b, c, d], t) = (self.coefficients, (value - self.origin) / self.unit);
        (a + t * (b + t * (c + t * d)), (b + t * (2.0 * c + t * 3.0 * d)) / self.unit)
    }

    /// The values strictly within where the height has an extremum, and those where the slope has one.
    pub fn turns(&self) -> [Vec<f64>; 2] {
        let [constant, linear, square] = self.derivative();
        let within = |t: &f64| (self.from..self.to).contains(t) && *t > self.from;
        let places = |roots: Vec<f64>| -> Vec<f64> {
            roots.into_iter().map(|t| self.origin + self.unit * t).filter(within).collect()
        };
        let bend = if square == 0.0 { Vec::new() } else { vec![-0.5 * linear / square] };
        [places(roots(constant, linear, square)), places(bend)]
    }

    /// The piece of offset + amplitude · g.
    pub fn scaled(self, amplitude: f64, offset: f64) -> Self {
        let mut coefficients = self.coefficients.map(|coefficient| amplitude * coefficient);
        coefficients[0] += offset;
        Self { coefficients, ..self }
    }

    /// By t.
    fn derivative(&self) -> [f64; 3] {
        let [_, linear, square, cube] = self.coefficients;
        [linear, 2.0 * square, 3.0 * cube]
    }
}

/// A polynomial; where t is infinite its limit.
fn horner(coefficients: &[f64], t: f64) -> f64 {
    // What is 0 so far stays out, because 0 · ∞ is no number.
    coefficients.iter().rev().fold(0.0, |sum, &next| if sum == 0.0 { next } else { sum * t + next })
}

/// The roots of constant + linear t + square t².
fn roots(constant: f64, linear: f64, square: f64) -> Vec<f64> {
    let within = linear * linear - 4.0 * square * constant;
    if within < 0.0 {
        return Vec::new();
    }
    let sum = -0.5 * (linear + linear.signum() * within.sqrt());
    [constant / sum, sum / square].into_iter().filter(|root| root.is_finite()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn turns_are_where_derivatives_vanish() {
        // t³ − 1.2 t² + 0.41 t over t = (f − 1)/2 has its extrema at 0.4 ± √(0.07)/√3 and bends at 0.4.
        let piece = Piece::between(1.0, 3.0, [0.3, 0.41, -1.2, 1.0]);
        let [mut extrema, bends] = piece.turns();
        extrema.sort_by(f64::total_cmp);
        let apart = (0.16f64 - 0.41 / 3.0).sqrt();
        let expected = [1.8 - 2.0 * apart, 1.8 + 2.0 * apart];
        assert_eq!(extrema.len(), 2);
        assert!(extrema.iter().zip(expected).all(|(found, expected)| (found - expected).abs() < 1e-12), "{extrema:?}");
        assert!(bends.len() == 1 && (bends[0] - 1.8).abs() < 1e-12, "{bends:?}");
        assert_eq!(Piece::above(2.0, [0.3, -0.5, 0.25, 0.0]).turns(), [vec![3.0], vec![]]);
        assert_eq!(Piece::above(4.0, [0.3, 0.5, 0.25, 0.0]).turns(), [vec![], vec![]]);
    }

    #[test]
    fn limits_are_those_of_the_highest_power() {
        let piece = Piece::everywhere([1.0, 5.0, 0.0, -2.0]);
        assert_eq!([f64::INFINITY, f64::NEG_INFINITY].map(|f| piece.height(f)), [f64::NEG_INFINITY, f64::INFINITY]);
        assert_eq!(Piece::below(2.0, [0.5, 0.0, 0.0, 0.0]).height(f64::NEG_INFINITY), 0.5);
        assert_eq!(Piece::above(2.0, [0.5, 3.0, 0.0, 0.0]).slope(f64::INFINITY), 3.0);
    }
}
