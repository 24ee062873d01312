//! The figures as text: a table for the terminal and one for other programs.

use super::judge::{Judged, Row};
use super::method::Method;
use super::scene::LIGHTS;
use super::tally::{Quantity, Region, Tally};
use std::fmt::Write;

/// Root mean square errors of a row for the terminal.
fn text_row(table: &mut String, label: &str, tallies: &[Tally]) {
    let _ = write!(table, "  {label:18}");
    for quantity in Quantity::ALL {
        for region in [None, Some(Region::Near), Some(Region::Far)] {
            let rms = Tally::rms(tallies, quantity, region);
            let _ = if rms.is_nan() { write!(table, "{:>7}", "-") } else { write!(table, "{rms:7.4}") };
        }
        table.push_str("  ");
    }
    table.push('\n');
}

/// The table for the terminal.
pub fn text(judged: &Judged) -> String {
    let mut table = format!("{:20}", "");
    for quantity in Quantity::ALL {
        let _ = write!(table, "{:>7}{:>7}{:>7}  ", quantity.name(), "near", "far");
    }
    table.push('\n');
    for row in &judged.rows {
        let _ = writeln!(table, "{}, {}", row.view.name, row.view.suns[row.light]);
        for (method, tallies) in Method::ALL.into_iter().zip(&row.methods) {
            text_row(&mut table, method.label(), tallies);
        }
        text_row(&mut table, "error of the truth", &row.truth);
    }
    table
}

/// What the columns mean, for the terminal.
pub fn legend(device: &str, [width, height]: [usize; 2], seeds: usize) -> String {
    format!(
        "Root mean square errors of {width}x{height} pixels on {device}, over {seeds} surfaces; of a pixel's worst\n\
         channel, in linear color.\n\
         seen: color of what is seen. lit: color of what of it is lit, weighted by how much that is.\n\
         light: that times the share that is lit. share: the share itself.\n\
         near: pixels that lose less than half of the variance of heights. far: the others.\n"
    )
}

/// All figures as comma-separated values: root mean square errors, their standard error over surfaces, and the standard
/// error of the truth that they hold.
pub fn csv(judged: &Judged) -> String {
    let mut table = String::from("view,sun,method,quantity,rms,rms_se,truth_se,near,near_truth_se,far,far_truth_se\n");
    for row in &judged.rows {
        for (method, tallies) in Method::ALL.into_iter().zip(&row.methods) {
            for quantity in Quantity::ALL {
                csv_row(&mut table, row, method, tallies, quantity);
            }
        }
    }
    table
}

fn csv_row(table: &mut String, row: &Row, method: Method, tallies: &[Tally], quantity: Quantity) {
    let figure = Tally::figure(tallies, quantity, None);
    let number = |number: f64| if number.is_nan() { String::new() } else { format!("{number:.5}") };
    let both = |region| [tallies, &row.truth].map(|tallies| Tally::rms(tallies, quantity, region));
    let ([rms, truth], [near, far]) = (both(None), Region::ALL.map(|region| both(Some(region))));
    let cells = [rms, figure.error, truth, near[0], near[1], far[0], far[1]];
    let names = [row.view.name, LIGHTS[row.light], method.label(), quantity.name()].join(",");
    let _ = writeln!(table, "{names},{}", cells.map(number).join(","));
}
