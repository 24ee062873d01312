//! What a report consists of, before it is written as a page, as Markdown or as comma-separated values.

use crate::gap::figure::Figure;
use crate::imaging::canvas::Canvas;

/// A report.
#[derive(Clone, Debug)]
pub struct Document {
    /// What it is about.
    pub title: String,
    /// On what, when and how far it was measured: written on the page and at the top of every table; the first two,
    /// device and date, below every plot and picture.
    pub facts: Vec<(&'static str, String)>,
    /// Its parts.
    pub sections: Vec<Section>,
}

/// A part of a report.
#[derive(Clone, Debug)]
pub struct Section {
    /// Its name in addresses: an identifier.
    pub stem: String,
    /// Its title.
    pub title: String,
    /// What it has, in order.
    pub items: Vec<Item>,
}

/// A piece of a section.
#[derive(Clone, Debug)]
pub enum Item {
    /// A paragraph.
    Text(String),
    /// A text that keeps its lines: code, or what a module says of itself.
    Lines(String),
    /// Figures in rows; written to `STEM.csv`, too.
    Table(Table),
    /// Curves; written to `STEM.svg`, and their points to `STEM.csv`.
    Plot(Plot),
    /// Pictures; written to `STEM.png`.
    Sheet(Sheet),
}

/// Figures in rows.
#[derive(Clone, Debug)]
pub struct Table {
    /// Its name in files: an identifier that no other piece of the report has.
    pub stem: String,
    /// What it shows, in a sentence or two.
    pub caption: String,
    /// Headings.
    pub columns: Vec<String>,
    /// Cells, as many in a row as there are columns.
    pub rows: Vec<Vec<Cell>>,
}

/// What a table has at a place.
#[derive(Clone, Debug, PartialEq)]
pub enum Cell {
    /// Words.
    Text(String),
    /// A whole number.
    Count(u64),
    /// A number, shown with three significant digits.
    Number(f64),
    /// A number with its standard error.
    Figure(Figure),
    /// Samples a pixel that brute force needs, or the most measured where that is too few.
    Samples(Result<f64, usize>),
    /// Nothing: what has no meaning there.
    Nothing,
}

/// Curves over two axes.
#[derive(Clone, Debug)]
pub struct Plot {
    /// Its name in files, as that of a table.
    pub stem: String,
    /// What it shows, in a sentence or two.
    pub caption: String,
    /// The axis to the right.
    pub x: Axis,
    /// The axis upwards.
    pub y: Axis,
    /// What is drawn, each in a color of its own.
    pub series: Vec<Series>,
}

/// An axis of a plot.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Axis {
    /// What it measures, with its unit.
    pub label: String,
    /// Whether equal factors are equally far apart; values up to 0 are then left out.
    pub logarithmic: bool,
}

/// Points of a plot.
#[derive(Clone, Debug)]
pub struct Series {
    /// Its name in the legend.
    pub label: String,
    /// Its points.
    pub points: Vec<[f64; 2]>,
    /// Whether a line joins them.
    pub joined: bool,
}

/// Pictures on one canvas.
#[derive(Clone, Debug)]
pub struct Sheet {
    /// Its name in files, as that of a table.
    pub stem: String,
    /// What it shows, in a sentence or two.
    pub caption: String,
    /// The pictures, with their lettering.
    pub canvas: Canvas,
}

impl From<&str> for Cell {
    fn from(text: &str) -> Self {
        Self::Text(text.to_owned())
    }
}

impl From<String> for Cell {
    fn from(text: String) -> Self {
        Self::Text(text)
    }
}

impl From<usize> for Cell {
    fn from(count: usize) -> Self {
        Self::Count(count as u64)
    }
}

impl From<f64> for Cell {
    fn from(number: f64) -> Self {
        Self::Number(number)
    }
}

impl From<Figure> for Cell {
    fn from(figure: Figure) -> Self {
        Self::Figure(figure)
    }
}
