//! Both forms of a quantity on the device, against the reference.

use prefilter::gpu::Device;

use super::formulas::Formula;
use crate::contract::{Contract, Promise};
use crate::harness;
use crate::kernel::Function;
use crate::rows::Row;

/// The textbook's form must be this many times farther off than what the shelf promises.
pub const WORSE: f64 = 10.0;

/// What was measured of two forms of a quantity.
#[derive(Clone, Debug, PartialEq)]
pub struct Pair {
    /// Which.
    pub formula: Formula,
    /// Where the textbook's form errs most.
    pub point: Vec<f64>,
    /// What the reference returns there.
    pub truth: Vec<f64>,
    /// What the textbook's form returns there.
    pub textbook: Vec<f64>,
    /// What the shelf returns there.
    pub shelf: Vec<f64>,
    /// The largest error of the textbook's form, in the measure of the promise; infinite for NaN.
    pub textbook_error: f64,
    /// The largest error of the shelf's over all points.
    pub shelf_error: f64,
    /// What the shelf promises.
    pub promise: f64,
}

impl Pair {
    /// Measures a formula beside the function of the shelf.
    ///
    /// # Errors
    /// A message where the function, its row or its promise is missing, or the device refuses one.
    pub fn measure(device: &Device, formula: Formula, rows: &[Row]) -> Result<Self, String> {
        let name = formula.shelf();
        let function = Function::of_shelf(name)?;
        let row = rows.iter().find(|row| row.name == name).ok_or_else(|| format!("`{name}` has no row"))?;
        let promise = Contract::of(&function)?.promise;
        let (Promise::Absolute(bound) | Promise::Relative(bound) | Promise::Mixed(bound)) = promise else {
            return Err(format!("`{name}` promises no error"));
        };
        let points = formula.points();
        let textbook = formula.function()?.results(device, &[], &points)?;
        let shelf = function.results(device, &[], &points)?;
        let mut pair: Option<Self> = None;
        let mut shelf_error = 0.0f64;
        for (point, (textbook, shelf)) in points.into_iter().zip(textbook.into_iter().zip(shelf)) {
            let error = |got: &[f64]| harness::error(promise, got, &row.expected(&point, got));
            let (textbook_error, truth) = (error(&textbook), row.expected(&point, &shelf));
            shelf_error = shelf_error.max(error(&shelf));
            if pair.as_ref().is_none_or(|pair| textbook_error > pair.textbook_error) {
                let promise = bound;
                pair = Some(Self { formula, point, truth, textbook, shelf, textbook_error, shelf_error, promise });
            }
        }
        pair.map(|pair| Self { shelf_error, ..pair }).ok_or_else(|| format!("`{name}` has no points"))
    }

    /// Whether the shelf keeps its promise where the textbook's form fails.
    pub fn holds(&self) -> bool {
        self.shelf_error <= self.promise && self.textbook_error > WORSE * self.promise
    }
}
