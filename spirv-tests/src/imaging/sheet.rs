//! Contact sheets: pictures in columns of one width under their headings, with lettering.

use super::canvas::{Canvas, Letters};

/// What is not drawn on.
const PAPER: [u8; 3] = [255; 3];
/// The color of lettering.
pub const INK: [u8; 3] = [30, 34, 40];
/// Around everything.
pub const MARGIN: usize = 10;
/// Between pictures.
pub const GAP: usize = 6;
/// Height of a line of text.
pub const LINE: usize = 18;

/// A sheet.
#[derive(Clone, Debug)]
pub struct Sheet {
    /// What it is drawn on.
    pub canvas: Canvas,
    width: usize,
}

impl Sheet {
    /// Where columns begin below their headings.
    pub const TOP: usize = MARGIN + LINE;

    /// A sheet of columns under these headings, as wide as pictures, with so much room below.
    pub fn new(headings: &[String], width: usize, height: usize) -> Self {
        let size = [2 * MARGIN + headings.len() * (width + GAP) - GAP, Self::TOP + height + MARGIN];
        let mut sheet = Self { canvas: Canvas::new(size[0], size[1], PAPER), width };
        for (column, heading) in headings.iter().enumerate() {
            sheet.canvas.text(heading, [sheet.left(column), MARGIN], Letters::Bold, INK);
        }
        sheet
    }

    /// Where a column begins.
    pub fn left(&self, column: usize) -> usize {
        MARGIN + column * (self.width + GAP)
    }

    /// Writes a line in a column, below something that ends there.
    pub fn line(&mut self, text: &str, column: usize, top: usize) {
        self.canvas.text(text, [self.left(column), top + 2], Letters::Small, INK);
    }

    /// Says in a line what the colors of error maps mean, of which `largest` is the brightest.
    pub fn error_line(&mut self, what: &str, largest: f32, top: usize) {
        let text = format!("{what}:  0");
        let after = MARGIN + Letters::Small.width(&text) + GAP;
        self.canvas.text(&text, [MARGIN, top], Letters::Small, INK);
        self.canvas.error_scale([after, top + 1], [200, 10]);
        self.canvas.text(&format!("{largest} and more"), [after + 200 + GAP, top], Letters::Small, INK);
    }
}
