//! What a scene without settings costs and reaches, filter by filter, and what was asked of it.

use super::case::{Case, Row};
use super::measure::{Measured, Sizes};
use super::table::faster;
use super::Filter;
use crate::imaging::measure::samples_for;
use crate::report::document::{Cell, Table};
use crate::report::Error;

/// Samples of which the asked speed counts from.
const FROM: f64 = 100.0;

/// How many times faster than as many samples a filter ought to be.
const FASTER: f64 = 100.0;

/// A filter with what was measured of its maps.
pub type Done = (Filter, Vec<(Case, Measured)>);

/// The row of a case that a scene without settings has, and its figures.
fn default<'a>(case: &'a Case, measured: &'a Measured) -> Option<(&'a Row, &'a Sizes)> {
    case.rows.iter().zip(&measured.rows).find(|(row, _)| row.default)
}

/// A default's time over that of naive.
fn ratio(measured: &Measured, sizes: &Sizes) -> f64 {
    sizes.time / measured.rows.first().map_or(f64::NAN, |naive| naive.time)
}

/// Times faster, or a bound.
fn speed(sizes: &Sizes, measured: &Measured) -> Cell {
    match faster(sizes, measured) {
        Ok(times) => times.into(),
        Err(times) => format!("> {times:.0}").into(),
    }
}

/// The default tier of every filter.
///
/// # Errors
/// What naga refuses.
pub fn summary(done: &[Done]) -> Result<Table, Error> {
    let columns = [
        "filter",
        "default tier",
        "RMS error",
        "largest error",
        "bound",
        "operations",
        "fetches",
        "table bytes",
        "time over naive",
        "with a driver",
        "samples of equal RMS",
        "times faster than those",
    ];
    let mut rows = Vec::new();
    for (filter, cases) in done {
        for (case, measured) in cases {
            let Some((row, sizes)) = default(case, measured) else { continue };
            let mut cells: Vec<Cell> = vec![format!("{}, {}", filter.name, case.map).into(), row.label.as_str().into()];
            cells.extend([sizes.rms, sizes.maximum].map(Cell::Figure));
            cells.push(row.bound().map_or(Cell::Nothing, Cell::Number));
            cells.extend(row.cost()?.map(Cell::from));
            cells.extend([ratio(measured, sizes).into(), measured.driven_ratio().into()]);
            cells.extend([Cell::Samples(samples_for(sizes.rms.value, &measured.samples())), speed(sizes, measured)]);
            rows.push(cells);
        }
    }
    let caption = "What a scene without settings chooses: its error, its cost, its time over that of the naive map \
        with the statistics given and behind six octaves of noise, and how many stratified samples have its error.";
    let columns = columns.map(str::to_owned).to_vec();
    Ok(Table { stem: "filters_summary".to_owned(), caption: caption.to_owned(), columns, rows })
}

/// What was asked of the default tiers.
pub fn asked(done: &[Done]) -> Table {
    let mut rows = Vec::new();
    for (filter, cases) in done {
        for (case, measured) in cases {
            let Some((_, sizes)) = default(case, measured) else { continue };
            let what = format!("{}, {}", filter.name, case.map);
            if let Some(most) = filter.asked {
                let driven = measured.driven_ratio();
                rows.push(vec![
                    what.clone().into(),
                    format!("time over naive with the same driver at most {most}").into(),
                    driven.into(),
                    verdict(driven <= most).into(),
                ]);
            }
            let needed = samples_for(sizes.rms.value, &measured.samples()).unwrap_or(f64::INFINITY);
            if needed > FROM {
                let met = match faster(sizes, measured) {
                    // More samples than were measured, and as much more time.
                    Err(times) if times < FASTER => "not shown",
                    Ok(times) | Err(times) => verdict(times >= FASTER),
                };
                let asked = format!("at least {FASTER} times faster than samples of equal error");
                rows.push(vec![what.into(), asked.into(), speed(sizes, measured), met.into()]);
            }
        }
    }
    let caption = "What was asked of what a scene without settings chooses: of GPUs the time over that of the naive \
        map behind the same driver, of every device the speed over stratified samples wherever more than 100 are \
        needed. Maps of the whole slope read a table 26 times, and those of a curve's heights find what hides them.";
    let columns = ["filter", "asked, ratios of a GPU", "on this device", "within"].map(str::to_owned).to_vec();
    Table { stem: "filters_asked".to_owned(), caption: caption.to_owned(), columns, rows }
}

fn verdict(met: bool) -> &'static str {
    if met {
        "yes"
    } else {
        "no"
    }
}
