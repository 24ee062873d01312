//! A filter's figures as a table and as plots.

use super::case::{Case, Role, Row};
use super::measure::{Measured, Sizes};
use super::Filter;
use crate::imaging::measure::samples_for;
use crate::report::document::{Axis, Cell, Plot, Series, Table};
use crate::report::Error;

/// Headings.
const COLUMNS: [&str; 14] = [
    "map",
    "method",
    "RMS error",
    "99th percentile",
    "largest error",
    "bound",
    "ms a megapixel",
    "over naive",
    "over naive with a driver",
    "operations",
    "fetches",
    "table bytes",
    "samples of equal RMS",
    "times faster than those",
];

/// The table of a filter's cases.
///
/// # Errors
/// What naga refuses.
pub fn table(filter: &Filter, cases: &[(Case, Measured)]) -> Result<Table, Error> {
    let mut rows = Vec::new();
    for (case, measured) in cases {
        let naive = measured.rows.first().map_or(f64::NAN, |sizes| sizes.time);
        for (row, sizes) in case.rows.iter().zip(&measured.rows) {
            rows.push(line(case, row, sizes, measured, naive)?);
        }
        for (count, sizes) in &measured.brute {
            let mut cells = vec![case.map.as_str().into(), plural(*count).into()];
            cells.extend(figures(sizes));
            cells.extend([Cell::Nothing, sizes.time.into(), (sizes.time / naive).into()]);
            cells.resize(COLUMNS.len(), Cell::Nothing);
            rows.push(cells);
        }
    }
    let columns = COLUMNS.map(str::to_owned).to_vec();
    let (stem, name) = (filter.stem, filter.name);
    Ok(Table { stem: format!("filters_{stem}"), caption: format!("Every tier: {name}."), columns, rows })
}

fn plural(count: usize) -> String {
    if count == 1 {
        "1 sample".to_owned()
    } else {
        format!("{count} stratified samples")
    }
}

fn figures(sizes: &Sizes) -> [Cell; 3] {
    [sizes.rms, sizes.percentile, sizes.maximum].map(Cell::Figure)
}

fn line(case: &Case, row: &Row, sizes: &Sizes, measured: &Measured, naive: f64) -> Result<Vec<Cell>, Error> {
    let mut cells = vec![case.map.as_str().into(), label(row).into()];
    cells.extend(figures(sizes));
    cells.push(row.bound().map_or(Cell::Nothing, Cell::Number));
    cells.extend([sizes.time.into(), (sizes.time / naive).into()]);
    cells.push(match (row.role, row.default) {
        (Role::Naive, _) => 1.0.into(),
        (_, true) => measured.driven_ratio().into(),
        _ => Cell::Nothing,
    });
    cells.extend(row.cost()?.map(Cell::from));
    let samples = samples_for(sizes.rms.value, &measured.samples());
    cells.push(Cell::Samples(samples));
    cells.push(match faster(sizes, measured) {
        Ok(times) => times.into(),
        Err(times) => format!("> {times:.0}").into(),
    });
    Ok(cells)
}

/// What a row is called, and whether it is what a scene without settings chooses.
fn label(row: &Row) -> String {
    let default = if row.default { " (default)" } else { "" };
    format!("{}{default}", row.label)
}

/// How many times faster than as many samples as have its error; `Err` where even the most samples have more.
pub fn faster(sizes: &Sizes, measured: &Measured) -> Result<f64, f64> {
    match samples_for(sizes.rms.value, &measured.samples()) {
        Ok(count) => Ok(measured.time_of(count) / sizes.time),
        Err(most) => Err(measured.time_of(most as f64) / sizes.time),
    }
}

/// Time against error of one case.
pub fn plot(filter: &str, case: &Case, measured: &Measured) -> Plot {
    let rows = case.rows.iter().zip(&measured.rows).map(|(row, sizes)| Series {
        label: label(row),
        points: vec![point(sizes)],
        joined: false,
    });
    let samples = Series {
        label: "1 to 4096 stratified samples".to_owned(),
        points: measured.brute.iter().map(|(_, sizes)| point(sizes)).collect(),
        joined: true,
    };
    Plot {
        stem: format!("filters_{}", case.stem),
        caption: format!("{filter}, {}: time against error; to the lower left is better.", case.map),
        x: Axis { label: "milliseconds a megapixel".to_owned(), logarithmic: true },
        y: Axis { label: "RMS error of the worst channel".to_owned(), logarithmic: true },
        series: rows.chain([samples]).collect(),
    }
}

fn point(sizes: &Sizes) -> [f64; 2] {
    [sizes.time, sizes.rms.value]
}
