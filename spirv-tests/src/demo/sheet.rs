//! The contact sheet: every column's picture and error map side by side, with labels.

use super::judge::Judged;
use super::method::Method;
use crate::imaging::canvas::{Canvas, Letters};
use crate::imaging::measure::errors;
use crate::imaging::picture::Picture;

/// The error that error maps show brightest.
pub const BRIGHTEST: f32 = 0.25;

const PAPER: [u8; 3] = [255; 3];
const INK: [u8; 3] = [30, 34, 40];
const SKY: [[u8; 3]; 2] = [[126, 160, 204], [226, 232, 236]];

/// Rows of sky above the ground: the ground begins below the horizon, and the sky is of no interest.
const SKY_ROWS: usize = 12;
const MARGIN: usize = 10;
const GAP: usize = 6;
/// Height of a line of text.
const LINE: usize = 18;

/// The sheet of several inputs whose pictures have one size.
pub fn sheet(all: &[Judged]) -> Canvas {
    let (width, height) = all.first().map_or((0, 0), |judged| (judged.truth.width, judged.truth.height));
    let columns = Method::SHOWN.len() + 1;
    let block = 2 * LINE + SKY_ROWS + 2 * height + GAP + LINE;
    let size = [2 * MARGIN + columns * (width + GAP) - GAP, 2 * MARGIN + all.len() * (block + GAP) - GAP];
    let mut canvas = Canvas::new(size[0], size[1], PAPER);
    for (number, judged) in all.iter().enumerate() {
        let top = MARGIN + number * (block + GAP);
        canvas.text(judged.title, [MARGIN, top], Letters::Bold, INK);
        for column in 0..columns {
            let left = MARGIN + column * (width + GAP);
            match Method::SHOWN.get(column).and_then(|&method| judged.row(method)) {
                Some(row) => {
                    draw(&mut canvas, &row.picture, &row.method.label(), [left, top + LINE]);
                    let below = top + 2 * LINE + SKY_ROWS + height + GAP;
                    canvas.errors(&errors(&row.picture, &judged.truth), width, BRIGHTEST, [left, below]);
                    let label = format!("RMS error {:.3}", row.deviation.rms);
                    canvas.text(&label, [left, below + height + 2], Letters::Small, INK);
                }
                None => {
                    draw(&mut canvas, &judged.truth, "truth, 2 x 32 x 32", [left, top + LINE]);
                    let below = top + 2 * LINE + SKY_ROWS + height + GAP;
                    legend(&mut canvas, [left, below], width);
                }
            }
        }
    }
    canvas
}

/// A picture below its label and a strip of sky.
fn draw(canvas: &mut Canvas, picture: &Picture, label: &str, [left, top]: [usize; 2]) {
    canvas.text(label, [left, top + 2], Letters::Small, INK);
    canvas.shade([left, top + LINE], [picture.width, SKY_ROWS], SKY[0], SKY[1]);
    canvas.picture(picture, [left, top + LINE + SKY_ROWS]);
}

/// What the colors of the error maps mean.
fn legend(canvas: &mut Canvas, [left, top]: [usize; 2], width: usize) {
    canvas.text("error of a pixel,", [left, top], Letters::Small, INK);
    canvas.text("worst channel, linear", [left, top + 13], Letters::Small, INK);
    canvas.error_scale([left, top + 32], [width, 10]);
    canvas.text("0", [left, top + 45], Letters::Small, INK);
    let most = format!("{BRIGHTEST} and more");
    canvas.text(&most, [left + width - Letters::Small.width(&most), top + 45], Letters::Small, INK);
}

/// A picture or an error map alone, for a file of its own.
pub fn still(picture: &Picture, truth: Option<&Picture>) -> Canvas {
    let mut canvas = Canvas::new(picture.width, picture.height, PAPER);
    match truth {
        None => canvas.picture(picture, [0, 0]),
        Some(truth) => canvas.errors(&errors(picture, truth), picture.width, BRIGHTEST, [0, 0]),
    }
    canvas
}

/// The frames of a moving picture, one below the other.
pub fn strip(frames: &[Picture]) -> Canvas {
    let (width, height) = frames.first().map_or((0, 0), |frame| (frame.width, frame.height));
    let mut canvas = Canvas::new(width, frames.len() * height, PAPER);
    for (number, frame) in frames.iter().enumerate() {
        canvas.picture(frame, [0, number * height]);
    }
    canvas
}
