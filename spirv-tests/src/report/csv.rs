//! Tables and plots as comma-separated values.

use super::document::{Cell, Plot, Table};
use crate::imaging::measure;

/// A table under `#` lines with the report's facts. A figure has a column behind it for its standard error.
pub fn table(facts: &[(&str, String)], table: &Table) -> String {
    let figures: Vec<bool> =
        (0..table.columns.len()).map(|column| table.rows.iter().any(|row| is_figure(&row[column]))).collect();
    let heading = table.columns.iter().zip(&figures).flat_map(|(name, &figure)| {
        let name = quoted(name);
        let error = figure.then(|| format!("{name} standard error"));
        std::iter::once(name).chain(error)
    });
    let mut lines = vec![heading.collect::<Vec<_>>().join(",")];
    for row in &table.rows {
        let cells = row.iter().zip(&figures).flat_map(|(cell, &figure)| {
            let error =
                figure.then(|| if let Cell::Figure(figure) = cell { exact(figure.error) } else { String::new() });
            std::iter::once(value(cell)).chain(error)
        });
        lines.push(cells.collect::<Vec<_>>().join(","));
    }
    head(facts, &table.caption) + &lines.join("\n") + "\n"
}

/// A plot's points under `#` lines with the report's facts.
pub fn plot(facts: &[(&str, String)], plot: &Plot) -> String {
    let heading = format!("series,{},{}", quoted(&plot.x.label), quoted(&plot.y.label));
    let points = plot.series.iter().flat_map(|series| {
        series.points.iter().map(|[x, y]| format!("{},{},{}", quoted(&series.label), exact(*x), exact(*y)))
    });
    let lines: Vec<String> = std::iter::once(heading).chain(points).collect();
    head(facts, &plot.caption) + &lines.join("\n") + "\n"
}

fn head(facts: &[(&str, String)], caption: &str) -> String {
    let facts = facts.iter().map(|(what, value)| format!("# {what}: {value}\n"));
    facts.chain([format!("# {}\n", caption.replace('\n', " "))]).collect()
}

fn is_figure(cell: &Cell) -> bool {
    matches!(cell, Cell::Figure(_))
}

fn value(cell: &Cell) -> String {
    match cell {
        Cell::Text(text) => quoted(text),
        Cell::Count(count) => count.to_string(),
        Cell::Number(number) => exact(*number),
        Cell::Figure(figure) => exact(figure.value),
        Cell::Samples(samples) => measure::samples(*samples),
        Cell::Nothing => String::new(),
    }
}

/// Six significant digits.
fn exact(number: f64) -> String {
    format!("{number:.5e}")
}

fn quoted(text: &str) -> String {
    if text.contains([',', '"', '\n']) {
        format!("\"{}\"", text.replace('"', "\"\""))
    } else {
        text.to_owned()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gap::figure::Figure;

    #[test]
    fn figures_have_a_column_for_their_error() {
        let rows = vec![
            vec!["one, two".into(), Figure { value: 0.5, error: 0.25 }.into()],
            vec!["three".into(), Cell::Nothing],
        ];
        let made =
            Table { stem: "made".into(), caption: "Made up.".into(), columns: vec!["what".into(), "how".into()], rows };
        let text = table(&[("device", "none".into())], &made);
        let expected =
            "# device: none\n# Made up.\nwhat,how,how standard error\n\"one, two\",5.00000e-1,2.50000e-1\nthree,,\n";
        assert_eq!(text, expected);
    }
}
