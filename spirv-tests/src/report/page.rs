//! The report as files: a page, a Markdown text, a list of values for every table and plot, and pictures.

use super::document::{Cell, Document, Item, Section, Table};
use super::{csv, markdown, plot, Error};
use crate::imaging::sheet::INK;
use std::fmt::Write;
use std::path::{Path, PathBuf};

const HEAD: &str = include_str!("page.html");

/// Writes the whole report into a folder, which is made if need be, and returns the page's path.
///
/// # Errors
/// Those of the file system, of plots and of the PNG encoder.
pub fn write(folder: &Path, document: &Document) -> Result<PathBuf, Error> {
    let failed = |path: &Path| {
        let path = path.to_path_buf();
        move |error| Error::File { path, error }
    };
    let written = |name: String, text: String| {
        let path = folder.join(name);
        std::fs::write(&path, text).map_err(failed(&path))
    };
    std::fs::create_dir_all(folder).map_err(failed(folder))?;
    // Plots and pictures go their own ways: each says where and when it was made.
    let measured = document.facts.iter().take(2).map(|(_, value)| value.as_str()).collect::<Vec<_>>().join(", ");
    for item in document.sections.iter().flat_map(|section| &section.items) {
        match item {
            Item::Text(_) | Item::Lines(_) => {}
            Item::Table(table) => written(format!("{}.csv", table.stem), csv::table(&document.facts, table))?,
            Item::Plot(plot) => {
                written(format!("{}.csv", plot.stem), csv::plot(&document.facts, plot))?;
                written(format!("{}.svg", plot.stem), plot::svg(plot, &measured)?)?;
            }
            Item::Sheet(sheet) => {
                let canvas = sheet.canvas.with_line(&measured, INK);
                canvas.save(&folder.join(format!("{}.png", sheet.stem)))?;
            }
        }
    }
    written("report.md".into(), markdown::text(document))?;
    written("index.html".into(), html(document))?;
    Ok(folder.join("index.html"))
}

fn html(document: &Document) -> String {
    let mut page = HEAD.replace("<style>", &format!("<title>{}</title>\n<style>", escaped(&document.title)));
    let _ = writeln!(page, "<h1>{}</h1>\n<table>", escaped(&document.title));
    for (what, value) in &document.facts {
        let _ = writeln!(page, "<tr><td class=\"word\">{what}</td><td class=\"word\">{}</td></tr>", escaped(value));
    }
    page += "</table>\n<nav>";
    for section in &document.sections {
        let _ = write!(page, "<a href=\"#{}\">{}</a>", section.stem, escaped(&section.title));
    }
    page += "</nav>\n";
    page + &document.sections.iter().map(section).collect::<String>() + "</main>\n</html>\n"
}

fn section(section: &Section) -> String {
    let mut text = format!("<h2 id=\"{}\">{}</h2>\n", section.stem, escaped(&section.title));
    for item in &section.items {
        text += &match item {
            Item::Text(paragraph) => format!("<p>{}</p>\n", escaped(paragraph)),
            Item::Lines(lines) => format!("<pre>{}</pre>\n", escaped(lines.trim_end())),
            Item::Table(table) => self::table(table),
            Item::Plot(plot) => figure(&plot.stem, "svg", &plot.caption),
            Item::Sheet(sheet) => figure(&sheet.stem, "png", &sheet.caption),
        };
    }
    text
}

fn figure(stem: &str, kind: &str, caption: &str) -> String {
    let caption = escaped(caption);
    let values = if kind == "svg" { format!(" <a href=\"{stem}.csv\">{stem}.csv</a>") } else { String::new() };
    format!(
        "<figure><figcaption>{caption}{values}</figcaption><img src=\"{stem}.{kind}\" alt=\"{caption}\"></figure>\n"
    )
}

fn table(table: &Table) -> String {
    let Table { stem, caption, .. } = table;
    let caption = format!("{} <a href=\"{stem}.csv\">{stem}.csv</a>", escaped(caption));
    let mut text = format!("<table>\n<caption>{caption}</caption>\n<tr>");
    let words: Vec<bool> = (0..table.columns.len()).map(|column| words(table, column)).collect();
    let class = |word: bool| if word { " class=\"word\"" } else { "" };
    for (name, &word) in table.columns.iter().zip(&words) {
        let _ = write!(text, "<th{}>{}</th>", class(word), escaped(name));
    }
    text += "</tr>\n";
    for row in &table.rows {
        text += "<tr>";
        for (cell, &word) in row.iter().zip(&words) {
            let _ = write!(text, "<td{}>{}</td>", class(word), escaped(&markdown::shown(cell)));
        }
        text += "</tr>\n";
    }
    text + "</table>\n"
}

/// Whether a column has words.
fn words(table: &Table, column: usize) -> bool {
    table.rows.iter().any(|row| matches!(row[column], Cell::Text(_)))
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::super::document::{Axis, Plot, Series, Sheet};
    use super::*;
    use crate::imaging::canvas::Canvas;

    #[test]
    fn every_piece_has_its_files() {
        let axis = |label: &str| Axis { label: label.into(), logarithmic: true };
        let points = vec![[1.0, 1e-3], [10.0, 0.0], [100.0, 1e-5], [f64::NAN, 1.0]];
        let series = vec![Series { label: "a <b>".into(), points, joined: true }];
        let plot = Plot { stem: "curve".into(), caption: "A curve.".into(), x: axis("ms"), y: axis("error"), series };
        let rows = vec![vec!["one & two".into(), 0.25.into()], vec![Cell::Nothing, 3usize.into()]];
        let columns = vec!["what".into(), "how".into()];
        let table = Table { stem: "rows".into(), caption: "Rows.".into(), columns, rows };
        let sheet = Sheet { stem: "look".into(), caption: "A look.".into(), canvas: Canvas::new(8, 8, [9; 3]) };
        let items = vec![
            Item::Text("Said.".into()),
            Item::Lines("fn main() -> vec3<f32>".into()),
            Item::Plot(plot),
            Item::Table(table),
            Item::Sheet(sheet),
        ];
        let sections = vec![Section { stem: "part".into(), title: "A part".into(), items }];
        let facts = vec![("device", "none".into()), ("date", "today".into())];
        let document = Document { title: "made".into(), facts, sections };
        let folder = std::env::temp_dir().join(format!("prefilter-page-{}", std::process::id()));
        let page = write(&folder, &document).map(|path| std::fs::read_to_string(path).unwrap_or_default());
        let page = page.unwrap_or_else(|error| error.to_string());
        for expected in ["<title>made</title>", "one &amp; two", "vec3&lt;f32&gt;", "src=\"curve.svg\"", "look.png"] {
            assert!(page.contains(expected), "{expected}: {page}");
        }
        let read = |name: &str| std::fs::read_to_string(folder.join(name)).unwrap_or_default();
        assert!(
            read("curve.svg").contains("a &lt;b&gt;")
                && read("curve.svg").contains("none, today")
                && read("curve.csv").contains("# device: none")
        );
        assert!(read("report.md").contains("| one & two | 0.250 |") && read("rows.csv").contains("what,how"));
        assert!(folder.join("look.png").exists() && std::fs::remove_dir_all(&folder).is_ok());
    }
}
