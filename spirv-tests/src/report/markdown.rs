//! The report as Markdown: all of it but pictures, which it links to.

use super::document::{Cell, Document, Item, Section, Table};
use crate::imaging::measure;
use std::fmt::Write;

/// The whole report; pictures and plots lie beside it.
pub fn text(document: &Document) -> String {
    let mut text = format!("# {}\n\n", document.title);
    for (what, value) in &document.facts {
        let _ = writeln!(text, "- {what}: {value}");
    }
    text + &document.sections.iter().map(section).collect::<String>()
}

fn section(section: &Section) -> String {
    let mut text = format!("\n## {}\n", section.title);
    for item in &section.items {
        let _ = match item {
            Item::Text(paragraph) => writeln!(text, "\n{paragraph}"),
            Item::Lines(lines) => writeln!(text, "\n```text\n{}\n```", lines.trim_end()),
            Item::Table(table) => writeln!(text, "\n{}{}", mark(&table.stem), self::table(table)),
            Item::Plot(plot) => writeln!(text, "\n![{}]({}.svg)", plot.caption, plot.stem),
            Item::Sheet(sheet) => writeln!(text, "\n![{}]({}.png)", sheet.caption, sheet.stem),
        };
    }
    text
}

/// What stands in front of a table, so that it is found.
pub fn mark(stem: &str) -> String {
    format!("<!-- {stem} -->\n")
}

/// A table under its caption.
pub fn table(table: &Table) -> String {
    let line = |cells: Vec<String>| format!("| {} |\n", cells.join(" | "));
    let columns = table.columns.iter().map(|name| name.replace('|', "\\|"));
    let mut text = format!("*{}*\n\n{}", table.caption, line(columns.collect()));
    text += &line(vec!["---".into(); table.columns.len()]).replace(' ', "");
    for row in &table.rows {
        text += &line(row.iter().map(|cell| shown(cell).replace('|', "\\|")).collect());
    }
    text
}

/// A cell for people.
pub fn shown(cell: &Cell) -> String {
    match cell {
        Cell::Text(text) => text.clone(),
        Cell::Count(count) => count.to_string(),
        Cell::Number(number) => digits(*number),
        Cell::Figure(figure) if figure.value.is_nan() => "–".into(),
        Cell::Figure(figure) => format!("{} ± {}", digits(figure.value), rounded(figure.error, 1)),
        Cell::Samples(samples) => measure::samples(*samples),
        Cell::Nothing => "–".into(),
    }
}

/// Three significant digits.
fn digits(number: f64) -> String {
    rounded(number, 3)
}

/// A number with so many digits.
pub(crate) fn rounded(number: f64, digits: i32) -> String {
    let size = number.abs();
    if number == 0.0 || !number.is_finite() {
        return format!("{number}");
    }
    if !(1e-4..1e6).contains(&size) {
        return format!("{number:.*e}", (digits - 1) as usize);
    }
    let places = (digits - 1 - size.log10().floor() as i32).max(0);
    format!("{number:.*}", places as usize)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gap::figure::Figure;

    #[test]
    fn numbers_have_three_digits_and_errors_one() {
        for (number, expected) in [(0.0, "0"), (123.4, "123"), (0.012345, "0.0123"), (1.5e-7, "1.50e-7"), (2.0, "2.00")]
        {
            assert_eq!(shown(&number.into()), expected);
        }
        assert_eq!(shown(&Figure { value: 0.0523, error: 0.0004 }.into()), "0.0523 ± 0.0004");
        assert_eq!(shown(&Cell::Samples(Err(1024))), "> 1024");
        assert_eq!(shown(&f64::NAN.into()), "NaN");
    }
}
