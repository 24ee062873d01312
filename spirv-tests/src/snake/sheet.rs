//! The contact sheet: every view by every method, with labels and errors.

use super::camera::View;
use super::judge::{Judged, Quantity, Row};
use super::method::Method;
use super::stage;
use super::truth::Look;
use crate::imaging::canvas::{Canvas, Letters};
use crate::imaging::picture::enlarged;

/// The error that error maps show brightest.
const BRIGHTEST: f32 = 0.25;

const PAPER: [u8; 3] = [255; 3];
const INK: [u8; 3] = [30, 34, 40];
const MARGIN: usize = 10;
const GAP: usize = 6;
/// Height of a line of text.
const LINE: usize = 18;

/// The sheet.
pub fn sheet(judged: &Judged) -> Canvas {
    let size = |view: &View| [view.width, view.height].map(|side| side * view.enlarged);
    let [width, height] = judged.rows.first().map_or([0, 0], |row| size(&row.view));
    let columns = Method::SHOWN.len() + 1;
    let block = 2 * (height + GAP) + LINE;
    let area = [2 * MARGIN + columns * (width + GAP) - GAP, 2 * MARGIN + LINE + judged.rows.len() * block - GAP];
    let mut canvas = Canvas::new(area[0], area[1], PAPER);
    let left = |column: usize| MARGIN + column * (width + GAP);
    for (column, method) in Method::SHOWN.into_iter().enumerate() {
        canvas.text(method.label(), [left(column), MARGIN], Letters::Bold, INK);
    }
    canvas.text("truth", [left(columns - 1), MARGIN], Letters::Bold, INK);
    for (number, row) in judged.rows.iter().enumerate() {
        let top = MARGIN + LINE + number * block;
        for (column, method) in Method::SHOWN.into_iter().enumerate() {
            let shown = &row.shown[method as usize];
            draw(&mut canvas, row, shown, [left(column), top]);
            errors(&mut canvas, row, shown, [left(column), top + height]);
            let label = format!(
                "RMS of color {:.3}, lit {:.3}",
                row.rms(method, Quantity::Color).value,
                row.rms(method, Quantity::Lit).value
            );
            canvas.text(&label, [left(column), top + 2 * height + 2], Letters::Small, INK);
        }
        let last = left(columns - 1);
        draw(&mut canvas, row, &row.truth, [last, top]);
        canvas.text(row.view.title, [last, top + height + 4], Letters::Bold, INK);
        let strata = row.view.strata;
        let rays = format!("truth: 2 x {strata} x {strata} rays a pixel");
        canvas.text(&rays, [last, top + height + 22], Letters::Small, INK);
        legend(&mut canvas, [last, top + height + 48], width);
    }
    canvas
}

fn draw(canvas: &mut Canvas, row: &Row, shown: &[Look], at: [usize; 2]) {
    let picture = stage::picture(shown, &row.truth, &row.stage, row.view.width);
    canvas.picture(&picture.enlarged(row.view.enlarged), at);
}

fn errors(canvas: &mut Canvas, row: &Row, shown: &[Look], at: [usize; 2]) {
    let pixels = shown.iter().zip(&row.truth);
    let errors: Vec<f32> = pixels.map(|(shown, truth)| Quantity::Color.error(shown, truth).unwrap_or(0.0)).collect();
    let View { width, enlarged: times, .. } = row.view;
    canvas.errors(&enlarged(&errors, width, times), width * times, BRIGHTEST, at);
}

/// What the colors of the error maps mean.
fn legend(canvas: &mut Canvas, [left, top]: [usize; 2], width: usize) {
    canvas.text("error of a pixel's color, worst channel", [left, top], Letters::Small, INK);
    canvas.error_scale([left, top + 16], [width, 10]);
    canvas.text("0", [left, top + 28], Letters::Small, INK);
    let most = format!("{BRIGHTEST} and more");
    canvas.text(&most, [left + width - Letters::Small.width(&most), top + 28], Letters::Small, INK);
}
