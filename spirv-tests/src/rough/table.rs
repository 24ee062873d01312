//! The figures as text: a table for the terminal and one for other programs.

use super::judge::{Judged, Row};
use super::method::Method;
use super::scene::{self, LIGHTS};
use super::tally::Quantity;
use crate::imaging::region::Region;
use std::fmt::Write;

/// Root mean square errors of a row for the terminal.
fn text_row(table: &mut String, label: &str, figure: impl Fn(Quantity, Option<Region>) -> f64) {
    let _ = write!(table, "  {label:18}");
    for quantity in Quantity::ALL {
        for region in [None, Some(Region::Near), Some(Region::Between), Some(Region::Far)] {
            let rms = figure(quantity, region);
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
        let _ = write!(table, "{:>7}{:>7}{:>7}{:>7}  ", quantity.name(), "near", "mid", "far");
    }
    table.push('\n');
    for row in &judged.rows {
        let _ = writeln!(table, "{}, {}", row.view.name, scene::suns(&row.view)[row.light]);
        for method in Method::ALL {
            text_row(&mut table, method.label(), |quantity, region| row.rms(method, quantity, region));
        }
        text_row(&mut table, "error of the truth", |quantity, region| row.truth_error(quantity, region));
    }
    table
}

/// What the columns mean, for the terminal.
pub fn legend(device: &str, [width, height]: [usize; 2], seeds: usize) -> String {
    format!(
        "Root mean square errors of {width}x{height} pixels on {device}, over {seeds} surfaces; of a pixel's worst\n\
         channel, in linear color, the variance of the truth taken off.\n\
         seen: color of what is seen. lit: color of what of it is lit, weighted by how much that is.\n\
         light: that times the share that is lit. share: the share itself.\n\
         near: pixels that lose less than half of the variance of heights. far: 99 % of it. mid: the others.\n"
    )
}

/// All figures as comma-separated values: root mean square errors, their standard error over surfaces, and the standard
/// error of the truth, whose variance they do not hold.
pub fn csv(judged: &Judged) -> String {
    let mut table = String::from("view,sun,method,quantity,rms,rms_se,truth_se");
    for region in Region::ALL {
        let _ = write!(table, ",{name},{name}_truth_se", name = region.name());
    }
    table.push('\n');
    for row in &judged.rows {
        for method in Method::ALL {
            Quantity::ALL.into_iter().for_each(|quantity| csv_row(&mut table, row, method, quantity));
        }
    }
    table
}

fn csv_row(table: &mut String, row: &Row, method: Method, quantity: Quantity) {
    let number = |number: f64| if number.is_nan() { String::new() } else { format!("{number:.5}") };
    let figure = row.figure(method, quantity, None);
    let regions = Region::ALL
        .into_iter()
        .map(Some)
        .flat_map(|region| [row.rms(method, quantity, region), row.truth_error(quantity, region)]);
    let cells = [figure.value, figure.error, row.truth_error(quantity, None)].into_iter().chain(regions);
    let names = [row.view.name, LIGHTS[row.light], method.label(), quantity.name()].join(",");
    let _ = writeln!(table, "{names},{}", cells.map(number).collect::<Vec<_>>().join(","));
}
