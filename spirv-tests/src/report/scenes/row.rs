//! A method on a scene: how far it is from the truth, how unsteady, how fast and how large. Every scene's table has
//! these columns.

use crate::gap::figure::Figure;
use crate::report::document::{Cell, Table};
use crate::report::markdown;

/// A row of a scene's table.
#[derive(Clone, Debug)]
pub struct Row {
    /// The method's name.
    pub method: String,
    /// Root mean square error over the pixels, without the truth's variance.
    pub rms: Figure,
    /// The error that 99 pixels in 100 stay below.
    pub percentile: Figure,
    /// The largest error.
    pub maximum: Figure,
    /// Deviation of the error over the frames of a zoom.
    pub zoom: Option<Figure>,
    /// And of a pan.
    pub pan: Option<Figure>,
    /// Milliseconds a million pixels of the method's kernel.
    pub milliseconds: f64,
    /// That over the naive kernel's, which reads the same statistics of the same driver.
    pub over_naive: Option<f64>,
    /// Bytes of all textures that the method reads.
    pub bytes: Option<usize>,
    /// Operations of a call, if there is a generated module.
    pub operations: Option<usize>,
    /// Stratified samples a pixel at which brute force has the same root mean square error.
    pub samples: Result<f64, usize>,
    /// Milliseconds a million pixels of one more stratified sample.
    pub sample: f64,
}

/// The columns of every scene's table.
pub const COLUMNS: [&str; 13] = [
    "method",
    "RMS",
    "99 %",
    "max",
    "shimmer, zoom",
    "shimmer, pan",
    "ms/Mpixel",
    "over naive, same driver",
    "table bytes",
    "operations",
    "samples for its RMS",
    "ms/Mpixel of those",
    "times faster",
];

impl Row {
    /// Milliseconds a million pixels of brute force with the same root mean square error, or of the most samples that
    /// it was measured with.
    pub fn brute(&self) -> f64 {
        self.sample * self.samples.unwrap_or_else(|most| most as f64)
    }

    /// How many times faster it is than brute force, and whether that is a bound only.
    pub fn speedup(&self) -> (f64, bool) {
        (self.brute() / self.milliseconds, self.samples.is_err())
    }

    fn cells(&self) -> Vec<Cell> {
        let figure = |figure: Option<Figure>| figure.map_or(Cell::Nothing, Cell::from);
        let count = |count: Option<usize>| count.map_or(Cell::Nothing, Cell::from);
        let (speedup, is_bound) = self.speedup();
        let at_least = |number: f64| match is_bound {
            true => format!("> {}", markdown::shown(&number.into())).into(),
            false => Cell::from(number),
        };
        vec![
            self.method.as_str().into(),
            self.rms.into(),
            self.percentile.into(),
            self.maximum.into(),
            figure(self.zoom),
            figure(self.pan),
            self.milliseconds.into(),
            self.over_naive.map_or(Cell::Nothing, Cell::from),
            count(self.bytes),
            count(self.operations),
            Cell::Samples(self.samples),
            at_least(self.brute()),
            at_least(speedup),
        ]
    }
}

/// The table of a scene.
pub fn table(stem: &str, caption: &str, rows: &[Row]) -> Table {
    Table {
        stem: stem.into(),
        caption: caption.into(),
        columns: COLUMNS.map(Into::into).to_vec(),
        rows: rows.iter().map(Row::cells).collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(samples: Result<f64, usize>) -> Row {
        let figure = |value: f64| Figure { value, error: 0.2 * value };
        Row {
            method: "made up".into(),
            rms: figure(0.02),
            percentile: figure(0.05),
            maximum: figure(0.3),
            zoom: Some(figure(0.01)),
            pan: None,
            milliseconds: 25.0,
            over_naive: Some(1.25),
            bytes: Some(512),
            operations: None,
            samples,
            sample: 50.0,
        }
    }

    #[test]
    fn tables_have_all_that_is_known() {
        let made = table("made", "Made up.", &[row(Ok(40.0)), row(Err(1024))]);
        assert!(made.rows.iter().all(|row| row.len() == COLUMNS.len()), "{made:?}");
        let shown: Vec<String> = made.rows[0].iter().map(markdown::shown).collect();
        let figures = ["0.0200 ± 0.004", "0.0500 ± 0.01", "0.300 ± 0.06", "0.0100 ± 0.002", "–"];
        let others = ["25.0", "1.25", "512", "–", "40", "2000", "80.0"];
        assert_eq!(shown, [&["made up"], &figures[..], &others[..]].concat());
        // More samples than were measured: at least 1024 times 50 ms, 2048 times 25 ms.
        let shown: Vec<String> = made.rows[1][10..].iter().map(markdown::shown).collect();
        assert_eq!(shown, ["> 1024", "> 51200", "> 2048"]);
    }
}
