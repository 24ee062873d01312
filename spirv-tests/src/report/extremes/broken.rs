//! The table of formulas that break.

use super::formulas::Formula;
use super::pairs::{Pair, WORSE};
use crate::report::document::{Cell, Item, Table};
use crate::report::{Bench, Error};
use crate::rows;

/// Steps of this table.
pub const STEPS: u64 = 1 + Formula::ALL.len() as u64;

/// The table, and what it says.
///
/// # Errors
/// A message where a formula cannot be judged.
pub fn items(bench: &Bench<'_>) -> Result<Vec<Item>, Error> {
    let rows = rows::all();
    (bench.done)(1);
    let mut lines = Vec::new();
    for formula in Formula::ALL {
        lines.push(row(&Pair::measure(bench.device, formula, &rows).map_err(Error::Measured)?));
        (bench.done)(1);
    }
    let text = format!(
        "Each formula as textbooks have it, beside the function of the shelf for the same quantity: where the \
         textbook's errs most, what both return on the device, and the largest error of both over a few points, in the \
         measure in which the shelf promises its own. A test asks of every row that the shelf keeps its promise and \
         that the textbook's form is off by more than {WORSE} times that much; the sine of a large phase is not on \
         every device."
    );
    let columns =
        ["formula", "instead", "at", "truth", "textbook", "shelf", "textbook error", "shelf error", "promise"];
    let table = Table {
        stem: "extremes_formulas".into(),
        caption: "Formulas that break, and those that stand in their place.".into(),
        columns: columns.map(Into::into).to_vec(),
        rows: lines,
    };
    Ok(vec![Item::Text(text), Item::Table(table)])
}

fn row(pair: &Pair) -> Vec<Cell> {
    vec![
        pair.formula.why().into(),
        pair.formula.shelf().into(),
        held(&pair.point).into(),
        rounded(&pair.truth).into(),
        held(&pair.textbook).into(),
        held(&pair.shelf).into(),
        pair.textbook_error.into(),
        pair.shelf_error.into(),
        pair.promise.into(),
    ]
}

/// Numbers of the device, with all the digits that tell them from others.
fn held(numbers: &[f64]) -> String {
    numbers.iter().map(|number| format!("{:?}", *number as f32)).collect::<Vec<_>>().join(" ")
}

/// Numbers with five significant digits.
fn rounded(numbers: &[f64]) -> String {
    let shown = |number: &f64| match number.abs() {
        0.0 => "0".to_owned(),
        size if !(1e-3..1e6).contains(&size) => format!("{number:.4e}"),
        size => format!("{number:.*}", (4 - size.log10().floor() as i32).max(0) as usize),
    };
    numbers.iter().map(shown).collect::<Vec<_>>().join(" ")
}
