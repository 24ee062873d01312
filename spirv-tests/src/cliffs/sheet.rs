//! The contact sheet: views by every method with its errors, and the truth with what pixels resolve.

use super::judge::{Judged, Panel, Row};
use super::method::Method;
use super::scene;
use crate::imaging::canvas::Canvas;
use crate::imaging::measure::errors;
use crate::imaging::picture::Picture;
use crate::imaging::region::Region;
use crate::imaging::sheet::{Sheet, GAP, LINE};
use crate::imaging::view::{Lens, View};

/// The error that error maps show brightest.
const BRIGHTEST: f32 = 0.25;

const SKY: [[u8; 3]; 2] = [[118, 156, 204], [222, 228, 232]];
/// What pixels resolve, from all to nothing, in linear light.
const RESOLVED: [f32; 3] = [0.02, 0.2, 0.7];

/// Rows of sky above the ground of lenses that look at the horizon: the ground begins below it.
const SKY_ROWS: usize = 10;

/// The sheet.
pub fn sheet(judged: &Judged) -> Canvas {
    let (width, height) = judged.panels.first().map_or((0, 0), |panel| (panel.view.width, panel.view.height));
    let block = 2 * (height + GAP) + SKY_ROWS + 2 * LINE;
    let shown: Vec<(&Panel, &Row)> =
        judged.panels.iter().zip(&judged.rows).filter(|(panel, _)| is_shown(panel)).collect();
    let truth = format!("truth, 2 x {strata} x {strata} rays", strata = judged.strata);
    let headings = Method::ALL.map(|method| method.label().to_owned()).into_iter().chain([truth]);
    let mut sheet = Sheet::new(&headings.collect::<Vec<_>>(), width, LINE + shown.len() * block);
    for (number, (panel, row)) in shown.iter().enumerate() {
        draw(&mut sheet, panel, row, Sheet::TOP + number * block);
    }
    let below = Sheet::TOP + shown.len() * block;
    sheet.error_line("error of a pixel, worst channel, linear", BRIGHTEST, below);
    sheet.canvas
}

/// Both suns where they differ most, elsewhere the one ahead.
fn is_shown(panel: &Panel) -> bool {
    panel.view.name == "grazing" || panel.light == 1
}

/// A view under a sky: what each method shows above its errors.
fn draw(sheet: &mut Sheet, panel: &Panel, row: &Row, top: usize) {
    let View { width, height, title, lens, .. } = panel.view;
    let title = format!("{title}, {}", scene::suns(&panel.view)[panel.light]);
    sheet.line(&title, 0, top);
    let top = top + LINE;
    let sky = if matches!(lens, Lens::Pinhole { .. }) { SKY_ROWS } else { 0 };
    for (column, picture) in panel.shown.iter().chain([&panel.truth]).enumerate() {
        let left = sheet.left(column);
        sheet.canvas.shade([left, top], [width, sky], SKY[0], SKY[1]);
        sheet.canvas.picture(picture, [left, top + sky]);
        let below = top + sky + height + GAP;
        let label = match Method::ALL.get(column) {
            Some(&method) => {
                sheet.canvas.errors(&errors(picture, &panel.truth), width, BRIGHTEST, [left, below]);
                label(row, method)
            }
            None => {
                sheet.canvas.picture(&resolved(panel), [left, below]);
                "slopes lost: < 50 %, < 90 %, more".into()
            }
        };
        sheet.line(&label, column, below + height);
    }
}

/// What pixels resolve: the less the brighter.
fn resolved(panel: &Panel) -> Picture {
    let pixels = panel.regions.iter().map(|&region| [RESOLVED[region as usize]; 3]).collect();
    Picture { width: panel.view.width, height: panel.view.height, pixels }
}

/// The errors that fit below a picture.
fn label(row: &Row, method: Method) -> String {
    let far = row.rms(method, Some(Region::Far));
    let far = if far.is_nan() { String::new() } else { format!(" (far {far:.3})") };
    format!("RMS error {:.3}{far}", row.rms(method, None))
}
