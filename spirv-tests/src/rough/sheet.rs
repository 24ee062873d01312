//! The contact sheet: every view under every light by every method, with labels and errors.

use super::judge::{Judged, Look, Row};
use super::method::Method;
use super::scene::{self, LIGHTS};
use super::tally::Quantity;
use crate::imaging::canvas::Canvas;
use crate::imaging::picture::Picture;
use crate::imaging::region::Region;
use crate::imaging::sheet::{Sheet, GAP, LINE};

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
    let block = height + LINE + GAP;
    let views = judged.panels.len() / LIGHTS.len();
    let truth = format!("truth, 2 x {strata} x {strata} rays", strata = judged.strata);
    let headings = Method::ALL.map(|method| method.label().to_owned()).into_iter().chain([truth]);
    let mut sheet = Sheet::new(&headings.collect::<Vec<_>>(), width, views * LINE + judged.panels.len() * block);
    let mut top = Sheet::TOP;
    for (panel, row) in judged.panels.iter().zip(&judged.rows) {
        if panel.light == 0 {
            sheet.line(panel.view.title, 0, top);
            top += LINE;
        }
        for (column, looks) in panel.shown.iter().chain([&panel.truth]).enumerate() {
            let left = sheet.left(column);
            sheet.canvas.picture(&picture(looks, width), [left, top]);
            let label = match Method::ALL.get(column) {
                Some(&method) => error(row, method),
                None => scene::suns(&panel.view)[panel.light].into(),
            };
            sheet.line(&label, column, top + height);
        }
        top += block;
    }
    sheet.canvas
}

/// The errors that fit below a picture.
fn error(row: &Row, method: Method) -> String {
    let color = row.rms(method, Quantity::Lit, None);
    let far = row.rms(method, Quantity::Lit, Some(Region::Far));
    let far = if far.is_nan() { String::new() } else { format!(" (far {far:.3})") };
    format!("RMS: color {color:.3}{far}, light {:.3}", row.rms(method, Quantity::Light, None))
}
