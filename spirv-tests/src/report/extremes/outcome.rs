//! What is measured of a filter or a driver in a hard case.

use super::cases::Case;

/// What was measured of a filter or a driver in a case.
#[derive(Clone, Debug, PartialEq)]
pub struct Outcome {
    /// The name of the filter or the driver.
    pub subject: &'static str,
    /// The case.
    pub case: Case,
    /// Points at which it ran.
    pub points: usize,
    /// Those that have a truth.
    pub judged: usize,
    /// The largest error at those; infinite where a result is no number.
    pub error: f64,
    /// Those of them that a bound covers.
    pub promised: usize,
    /// The largest error at those.
    pub promised_error: f64,
    /// The module's bound, of a driver the promise of the shelf, where there is one.
    pub bound: Option<f64>,
    /// Results that are no number, that leave the hull of colors or values, or shares beyond 0 to 1.
    pub violations: usize,
    /// The point with the largest error, and the one with the first violation.
    pub worst: [Option<String>; 2],
}

impl Outcome {
    /// Of nothing so far.
    pub fn new(subject: &'static str, case: Case, bound: Option<f64>) -> Self {
        let (points, judged, promised, violations) = (0, 0, 0, 0);
        let (error, promised_error, worst) = (0.0, 0.0, [None, None]);
        Self { subject, case, points, judged, error, promised, promised_error, bound, violations, worst }
    }

    /// Whether no invariant is violated and the bound holds wherever it is promised.
    pub fn holds(&self) -> bool {
        let kept = self.bound.is_none_or(|bound| self.promised_error <= bound);
        self.points > 0 && self.violations == 0 && (self.promised == 0 || kept)
    }

    /// Counts a result that has its invariants or not.
    pub fn count(&mut self, point: &dyn std::fmt::Debug, sound: bool) {
        self.points += 1;
        if !sound {
            self.violations += 1;
            self.worst[1] = self.worst[1].take().or_else(|| Some(format!("{point:?}")));
        }
    }

    /// Compares a result with the truth.
    pub fn judge(&mut self, point: &dyn std::fmt::Debug, got: &[f64], truth: &[f64], promised: bool) {
        let errors = got.iter().zip(truth).map(|(got, truth)| (got - truth).abs());
        let error = errors.fold(0.0, |most: f64, error| if error.is_nan() { f64::INFINITY } else { most.max(error) });
        self.judged += 1;
        if self.worst[0].is_none() || error > self.error {
            self.error = error;
            self.worst[0] = Some(format!("{point:?}: {got:?}, not {truth:?}"));
        }
        if promised {
            self.promised += 1;
            self.promised_error = self.promised_error.max(error);
        }
    }
}
