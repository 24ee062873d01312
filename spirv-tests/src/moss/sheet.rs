//! The contact sheet: both surfaces in every view by every method, with labels and errors.

use super::judge::{Judged, Part, Row};
use super::method::Method;
use crate::imaging::canvas::Canvas;
use crate::imaging::look::{Look, Quantity};
use crate::imaging::picture::{enlarged, Picture};
use crate::imaging::sheet::{Sheet, GAP, LINE};

/// The error that error maps show brightest.
const BRIGHTEST: f32 = 0.25;

/// The light of the sky, which is everywhere, and of the sun; what is behind the log.
const SKY: [f64; 3] = [0.14, 0.18, 0.24];
const SUN: [f64; 3] = [1.30, 1.20, 1.02];
const BEHIND: [f64; 3] = [0.42, 0.56, 0.74];

/// What the eye is shown: all that is seen under the sky, and what is lit besides.
fn picture(looks: &[Look], truth: &[Look], width: usize) -> Picture {
    let shade = |(look, truth): (&Look, &Look)| {
        // Silhouettes are the same for all methods; where none of a pixel is seen there is no color.
        let share = if look.share == 0.0 { 0.0 } else { truth.share };
        std::array::from_fn(|channel| {
            let light = SKY[channel] * look.color[channel] + SUN[channel] * look.lit[channel];
            (share * light + (1.0 - share) * BEHIND[channel]) as f32
        })
    };
    Picture { width, height: looks.len() / width.max(1), pixels: looks.iter().zip(truth).map(shade).collect() }
}

/// The sheet.
pub fn sheet(judged: &Judged) -> Canvas {
    let size = judged
        .rows
        .first()
        .map_or([0, 0], |row| [row.view.width, row.view.height].map(|side| side * row.view.enlarged));
    let [width, height] = size;
    let block = 2 * (height + GAP) + 2 * LINE;
    let headings = Method::ALL.map(Method::label).into_iter().chain(["truth"]).map(str::to_owned);
    let mut sheet = Sheet::new(&headings.collect::<Vec<_>>(), width, LINE + judged.rows.len() * block);
    for (number, row) in judged.rows.iter().enumerate() {
        let top = Sheet::TOP + number * block;
        let strata = row.view.strata;
        let title = format!("{}, {}; truth by 2 x {strata} x {strata} rays a pixel", row.material, row.view.title);
        sheet.line(&title, 0, top);
        draw(&mut sheet, row, height, top + LINE);
    }
    let below = Sheet::TOP + judged.rows.len() * block;
    sheet.error_line("error of a pixel's light, worst channel, linear", BRIGHTEST, below);
    sheet.canvas
}

/// A view by every method above its errors, and the truth.
fn draw(sheet: &mut Sheet, row: &Row, height: usize, top: usize) {
    let (width, times) = (row.view.width, row.view.enlarged);
    for (column, looks) in row.shown.iter().chain([&row.truth]).enumerate() {
        let left = sheet.left(column);
        sheet.canvas.picture(&picture(looks, &row.truth, width).enlarged(times), [left, top]);
        if let Some(&method) = Method::ALL.get(column) {
            let errors = looks.iter().zip(&row.truth);
            let errors: Vec<f32> =
                errors.map(|(look, truth)| Quantity::Lit.error(look, truth).unwrap_or(0.0)).collect();
            sheet.canvas.errors(&enlarged(&errors, width, times), width * times, BRIGHTEST, [left, top + height + GAP]);
            let [color, lit] = Quantity::ALL.map(|quantity| row.rms(method, quantity, Part::All));
            sheet.line(&format!("RMS: color {color:.3}, lit {lit:.3}"), column, top + 2 * height + GAP);
        }
    }
}
