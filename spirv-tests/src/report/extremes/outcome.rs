//! What is measured of a filter or a driver in a hard case.

use std::fmt::Debug;

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
    /// The largest error at those, against what the points count as.
    pub promised_error: f64,
    /// The largest of those bounds, the module's or what is promised of a driver.
    pub bound: Option<f64>,
    /// Results that are farther from the truth than the bound at their point.
    pub broken: usize,
    /// Results that are no number, that leave the hull of colors or values, or shares beyond 0 to 1.
    pub violations: usize,
    /// The point with the largest error, and the first with a violation or a broken bound.
    pub worst: [Option<String>; 2],
}

impl Outcome {
    /// Of nothing so far.
    pub fn new(subject: &'static str, case: Case) -> Self {
        let (points, judged, promised, broken, violations) = (0, 0, 0, 0, 0);
        let (error, promised_error, bound, worst) = (0.0, 0.0, None, [None, None]);
        Self { subject, case, points, judged, error, promised, promised_error, bound, broken, violations, worst }
    }

    /// Whether no invariant is violated and bounds hold wherever they are promised.
    pub fn holds(&self) -> bool {
        self.points > 0 && self.violations == 0 && self.broken == 0
    }

    /// Counts a result that has its invariants or not.
    pub fn count(&mut self, point: &dyn Debug, sound: bool) {
        self.points += 1;
        if !sound {
            self.violations += 1;
            self.worst[1] = self.worst[1].take().or_else(|| Some(format!("{point:?}")));
        }
    }

    /// Compares a result with the truth, and with what it is promised to be no farther from than a bound.
    pub fn judge(&mut self, point: &dyn Debug, got: &[f64], truth: &[f64], promised: Option<(&[f64], f64)>) {
        let error = distance(got, truth);
        self.judged += 1;
        if self.worst[0].is_none() || error > self.error {
            self.error = error;
            self.worst[0] = Some(format!("{point:?}: {got:?}, not {truth:?}"));
        }
        let Some((counted, bound)) = promised else { return };
        let error = distance(got, counted);
        self.promised += 1;
        self.promised_error = self.promised_error.max(error);
        self.bound = Some(self.bound.unwrap_or(0.0).max(bound));
        if error > bound {
            self.broken += 1;
            let first = || format!("{point:?}: {got:?}, {error:e} from {counted:?}, beyond {bound:e}");
            self.worst[1] = self.worst[1].take().or_else(|| Some(first()));
        }
    }
}

/// The largest error of a number; infinite where one is none.
fn distance(got: &[f64], truth: &[f64]) -> f64 {
    let errors = got.iter().zip(truth).map(|(got, truth)| (got - truth).abs());
    errors.fold(0.0, |most: f64, error| if error.is_nan() { f64::INFINITY } else { most.max(error) })
}
