//! Pictures of a scene side by side, with their errors below.

use crate::imaging::canvas::{Canvas, Letters};
use crate::imaging::picture::{enlarged, Picture};
use crate::imaging::sheet::{GAP, INK, LINE, MARGIN};
use crate::report::document;

/// The error that error maps show brightest.
const BRIGHTEST: f32 = 0.25;

/// What a sheet is at most as wide as.
const WIDTH: usize = 1340;

const PAPER: [u8; 3] = [255; 3];

/// A view by several methods, with the truth at the end.
#[derive(Clone, Debug)]
pub struct View {
    /// What is seen.
    pub title: String,
    /// How many times pictures are enlarged.
    pub enlarged: usize,
    /// The pictures.
    pub panels: Vec<Panel>,
}

/// A picture.
#[derive(Clone, Debug)]
pub struct Panel {
    /// What it is.
    pub caption: String,
    /// The picture.
    pub picture: Picture,
    /// The errors of its pixels; none of the truth.
    pub errors: Vec<f32>,
}

impl Panel {
    /// What a method shows, with its root mean square error.
    pub fn new(method: &str, rms: f64, picture: Picture, errors: Vec<f32>) -> Self {
        Self { caption: format!("{method}: {rms:.3}"), picture, errors }
    }

    /// The truth.
    pub fn truth(picture: Picture) -> Self {
        Self { caption: "truth".into(), picture, errors: Vec::new() }
    }
}

/// The sheet of several views. No caption reaches into the next: columns are as wide as the widest of captions and
/// pictures.
pub fn sheet(stem: &str, caption: &str, views: &[View]) -> document::Sheet {
    let width = views.iter().flat_map(View::widths).max().unwrap_or(0);
    let most = views.iter().map(|view| view.panels.len()).max().unwrap_or(0);
    // As many rows as it takes, and all as long.
    let rows = most.div_ceil(((WIDTH - 2 * MARGIN + GAP) / (width + GAP)).max(1));
    let columns = most.div_ceil(rows.max(1)).max(1);
    let across = (columns * (width + GAP) - GAP).max(titles(views)).max(Letters::Small.width(SCALE) + 330);
    let down: usize = views.iter().map(|view| view.height(columns)).sum();
    let mut canvas = Canvas::new(2 * MARGIN + across, 2 * MARGIN + down + LINE, PAPER);
    let mut top = MARGIN;
    for view in views {
        canvas.text(&view.title, [MARGIN, top], Letters::Bold, INK);
        for (number, panel) in view.panels.iter().enumerate() {
            let left = MARGIN + number % columns * (width + GAP);
            panel.draw(&mut canvas, view.enlarged, [left, top + LINE + number / columns * view.row()]);
        }
        top += view.height(columns);
    }
    scale(&mut canvas, top);
    document::Sheet { stem: stem.into(), caption: caption.into(), canvas }
}

/// What the scale of error maps is of.
const SCALE: &str = "numbers: RMS error. maps: error of a pixel, worst channel, linear:";

/// Says what the colors of error maps mean.
fn scale(canvas: &mut Canvas, top: usize) {
    let text = format!("{SCALE}  0");
    let after = MARGIN + Letters::Small.width(&text) + GAP;
    canvas.text(&text, [MARGIN, top], Letters::Small, INK);
    canvas.error_scale([after, top + 1], [200, 10]);
    canvas.text(&format!("{BRIGHTEST} and more"), [after + 200 + GAP, top], Letters::Small, INK);
}

/// The width of the widest title.
fn titles(views: &[View]) -> usize {
    views.iter().map(|view| Letters::Bold.width(&view.title)).max().unwrap_or(0)
}

impl View {
    fn widths(&self) -> impl Iterator<Item = usize> + '_ {
        let width =
            |panel: &Panel| (panel.picture.width * self.enlarged).max(Letters::Small.width(&panel.caption) + GAP);
        self.panels.iter().map(width)
    }

    /// Height of a row: a caption, a picture and its errors.
    fn row(&self) -> usize {
        let height = self.panels.iter().map(|panel| panel.picture.height).max().unwrap_or(0);
        LINE + 2 * (height * self.enlarged + GAP)
    }

    fn height(&self, columns: usize) -> usize {
        LINE + self.panels.len().div_ceil(columns) * self.row() + GAP
    }
}

impl Panel {
    fn draw(&self, canvas: &mut Canvas, times: usize, [left, top]: [usize; 2]) {
        let Picture { width, height, .. } = self.picture;
        canvas.text(&self.caption, [left, top + 3], Letters::Small, INK);
        canvas.picture(&self.picture.enlarged(times), [left, top + LINE]);
        if !self.errors.is_empty() {
            let below = top + LINE + height * times + GAP / 2;
            canvas.errors(&enlarged(&self.errors, width, times), width * times, BRIGHTEST, [left, below]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use embedded_graphics::prelude::OriginDimensions;

    /// Small pictures under long captions: columns have room for the captions.
    #[test]
    fn captions_have_room() {
        let picture = Picture { width: 4, height: 2, pixels: vec![[0.5; 3]; 8] };
        let panel = Panel::new("a method with a long name", 0.125, picture.clone(), vec![0.1; 8]);
        let panels = vec![panel.clone(), panel.clone(), panel, Panel::truth(picture)];
        let width = Letters::Small.width("a method with a long name: 0.125") + GAP;
        let view = View { title: "a view".into(), enlarged: 1, panels };
        let made = sheet("made", "Made up.", &[view]);
        assert_eq!(made.canvas.size().width as usize, 2 * MARGIN + 4 * (width + GAP) - GAP);
    }
}
