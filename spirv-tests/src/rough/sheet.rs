//! The contact sheet: every view under every light by every method, with labels and errors.

use super::judge::{Judged, Look, Row};
use super::method::Method;
use super::scene::{self, LIGHTS};
use super::tally::Quantity;
use crate::imaging::canvas::{Canvas, Letters};
use crate::imaging::picture::Picture;
use crate::imaging::region::Region;

const PAPER: [u8; 3] = [255; 3];
const INK: [u8; 3] = [30, 34, 40];
const MARGIN: usize = 10;
const GAP: usize = 6;
/// Height of a line of text.
const LINE: usize = 18;

/// The light of the sky, which is everywhere, and of the sun.
const SKY: [f64; 3] = [0.14, 0.18, 0.24];
const SUN: [f64; 3] = [0.88, 0.81, 0.69];

/// What the eye is shown: all that is seen under the sky, and what is lit besides.
pub fn picture(looks: &[Look], width: usize) -> Picture {
    let shade = |look: &Look| {
        let light = look.lighted();
        std::array::from_fn(|channel| (SKY[channel] * look.color[channel] + SUN[channel] * light[channel]) as f32)
    };
    Picture { width, height: looks.len() / width.max(1), pixels: looks.iter().map(shade).collect() }
}

/// The sheet.
pub fn sheet(judged: &Judged) -> Canvas {
    let (width, height) = judged.panels.first().map_or((0, 0), |panel| (panel.view.width, panel.view.height));
    let columns = Method::ALL.len() + 1;
    let block = height + LINE + GAP;
    let views = judged.panels.len() / LIGHTS.len();
    let size =
        [2 * MARGIN + columns * (width + GAP) - GAP, 2 * MARGIN + LINE + views * LINE + judged.panels.len() * block];
    let mut canvas = Canvas::new(size[0], size[1], PAPER);
    let truth = format!("truth, 2 x {strata} x {strata} rays", strata = judged.strata);
    let labels = Method::ALL.map(|method| method.label().to_owned()).into_iter().chain([truth]);
    for (column, label) in labels.enumerate() {
        canvas.text(&label, [MARGIN + column * (width + GAP), MARGIN], Letters::Bold, INK);
    }
    let mut top = MARGIN + LINE;
    for (panel, row) in judged.panels.iter().zip(&judged.rows) {
        if panel.light == 0 {
            canvas.text(panel.view.title, [MARGIN, top + 2], Letters::Small, INK);
            top += LINE;
        }
        for (column, looks) in panel.shown.iter().chain([&panel.truth]).enumerate() {
            let left = MARGIN + column * (width + GAP);
            canvas.picture(&picture(looks, width), [left, top]);
            let label = match Method::ALL.get(column) {
                Some(&method) => error(row, method),
                None => scene::suns(&panel.view)[panel.light].into(),
            };
            canvas.text(&label, [left, top + height + 2], Letters::Small, INK);
        }
        top += block;
    }
    canvas
}

/// The errors that fit below a picture.
fn error(row: &Row, method: Method) -> String {
    let color = row.rms(method, Quantity::Lit, None);
    let far = row.rms(method, Quantity::Lit, Some(Region::Far));
    let far = if far.is_nan() { String::new() } else { format!(" (far {far:.3})") };
    format!("RMS: color {color:.3}{far}, light {:.3}", row.rms(method, Quantity::Light, None))
}
