//! The contact sheet: every view by every method, with labels and errors.

use super::judge::{Judged, Row};
use super::method::Method;
use super::stage;
use crate::imaging::camera::View;
use crate::imaging::canvas::{Canvas, Letters};
use crate::imaging::look::{Look, Quantity};
use crate::imaging::picture::enlarged;
use crate::imaging::sheet::{Sheet, GAP, INK, LINE};

/// The error that error maps show brightest.
const BRIGHTEST: f32 = 0.25;

/// The sheet.
pub fn sheet(judged: &Judged) -> Canvas {
    let size = |view: &View| [view.width, view.height].map(|side| side * view.enlarged);
    let [width, height] = judged.rows.first().map_or([0, 0], |row| size(&row.view));
    let block = 2 * (height + GAP) + LINE;
    let headings = Method::SHOWN.map(Method::label).into_iter().chain(["truth"]).map(str::to_owned);
    let mut sheet = Sheet::new(&headings.collect::<Vec<_>>(), width, judged.rows.len() * block - GAP);
    let last = sheet.left(Method::SHOWN.len());
    for (number, row) in judged.rows.iter().enumerate() {
        let top = Sheet::TOP + number * block;
        for (column, method) in Method::SHOWN.into_iter().enumerate() {
            let shown = &row.shown[method as usize];
            let left = sheet.left(column);
            draw(&mut sheet.canvas, row, shown, [left, top]);
            errors(&mut sheet.canvas, row, shown, [left, top + height]);
            let label = format!(
                "RMS of color {:.3}, lit {:.3}",
                row.rms(method, Quantity::Color).value,
                row.rms(method, Quantity::Lit).value
            );
            sheet.line(&label, column, top + 2 * height);
        }
        draw(&mut sheet.canvas, row, &row.truth, [last, top]);
        sheet.canvas.text(row.view.title, [last, top + height + 4], Letters::Bold, INK);
        let strata = row.view.strata;
        let rays = format!("truth: 2 x {strata} x {strata} rays a pixel");
        sheet.canvas.text(&rays, [last, top + height + 22], Letters::Small, INK);
        legend(&mut sheet.canvas, [last, top + height + 48], width);
    }
    sheet.canvas
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
