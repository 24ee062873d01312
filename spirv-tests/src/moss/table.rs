//! The figures as text: a table for the terminal and two for other programs.

use super::judge::{Judged, Part};
use super::method::Method;
use super::zoom::{Unsteady, Zoomed};
use crate::imaging::look::Quantity;
use crate::imaging::tally::Of;
use std::fmt::Write;

/// The table of still pictures for the terminal.
pub fn text(judged: &Judged) -> String {
    let mut table = format!("{:22}", "");
    for quantity in Quantity::ALL {
        let _ = write!(table, "{:>9}{:>8}{:>8}{:>8}{:>8}  ", quantity.name(), "near", "mid", "far", "rim");
    }
    table.push('\n');
    for row in &judged.rows {
        let _ = writeln!(table, "{}, {}", row.material, row.view.title);
        let methods = Method::ALL.map(|method| (method.label(), Of::Method(method as usize)));
        for (label, of) in methods.into_iter().chain([("error of the truth", Of::Truth)]) {
            let _ = write!(table, "  {label:20}");
            for quantity in Quantity::ALL {
                table.push(' ');
                for part in Part::ALL {
                    let rms = row.sizes(of, quantity, part).rms.value;
                    let _ = if rms.is_nan() { write!(table, "{:>8}", "-") } else { write!(table, "{rms:8.4}") };
                }
                table.push_str("  ");
            }
            table.push('\n');
        }
    }
    table
}

/// The table of the zoom for the terminal.
pub fn zoom_text(judged: &Judged) -> String {
    let mut table = format!("{:22}", "zoom");
    for quantity in Quantity::ALL {
        let _ = write!(table, "{:>9}{:>9}{:>8}{:>6}", quantity.name(), "shimmer", "jump", "at");
    }
    table.push('\n');
    for zoomed in &judged.zooms {
        let _ = writeln!(table, "{}", zoomed.material);
        for (label, unsteady) in labeled(zoomed) {
            let _ = write!(table, "  {label:20}");
            for Unsteady { shimmer, jump, at } in unsteady {
                let _ = write!(table, "{:9}{shimmer:9.4}{jump:8.4}{at:6.2}", "");
            }
            table.push('\n');
        }
    }
    table
}

fn labeled(zoomed: &Zoomed) -> impl Iterator<Item = (&'static str, [Unsteady; 2])> + '_ {
    let methods = Method::ALL.into_iter().map(Method::label).zip(zoomed.methods.iter().copied());
    methods.chain([("error of the truth", zoomed.truth)])
}

/// What the columns mean, for the terminal.
pub fn legend(device: &str, [width, height]: [usize; 2], seeds: usize) -> String {
    format!(
        "Root mean square errors of {width}x{height} pixels on {device}, over {seeds} fields of noise; of a pixel's\n\
         worst channel, in linear color, times the share of the pixel that the log covers, the variance of the truth\n\
         taken off. color: of what is seen. lit: times Lambert's cosine, 0 in shadow.\n\
         near: pixels that lose less than half of the variance of f. far: 99 % of it. mid: the others.\n\
         rim: pixels that see some of the log at less than 15 degrees.\n\
         zoom, over pixels from 0.15 to 2 wavelengths. shimmer: the deviation of the error over the frames. jump: the\n\
         largest change of the error from a frame to the next, and wavelengths a pixel there.\n"
    )
}

/// Errors of still pictures as comma-separated values, with standard errors over noise and of the truth.
pub fn csv(judged: &Judged) -> String {
    let mut table = String::from(
        "surface,view,method,quantity,part,pixels,rms,rms_se,truth_se,percentile_99,percentile_99_se,maximum\n",
    );
    for row in &judged.rows {
        for (method, quantity) in Method::ALL.into_iter().flat_map(|method| Quantity::ALL.map(|of| (method, of))) {
            for part in Part::ALL {
                let found = row.sizes(Of::Method(method as usize), quantity, part);
                if found.rms.value.is_nan() {
                    continue;
                }
                let truth = row.sizes(Of::Truth, quantity, part).rms.value;
                let names = [row.material, row.view.name, method.label(), quantity.name(), part.name()].join(",");
                let numbers = [
                    found.rms.value,
                    found.rms.error,
                    truth,
                    found.percentile.value,
                    found.percentile.error,
                    found.maximum.value,
                ];
                let numbers = numbers.map(|number| format!("{number:.5}")).join(",");
                let _ = writeln!(table, "{names},{},{numbers}", row.pixels(part));
            }
        }
    }
    table
}

/// The zoom as comma-separated values.
pub fn zoom_csv(judged: &Judged) -> String {
    let mut table = String::from("surface,method,quantity,shimmer,jump,wavelengths_a_pixel\n");
    for zoomed in &judged.zooms {
        for (label, unsteady) in labeled(zoomed) {
            for (quantity, Unsteady { shimmer, jump, at }) in Quantity::ALL.into_iter().zip(unsteady) {
                let names = [zoomed.material, label, quantity.name()].join(",");
                let _ = writeln!(table, "{names},{shimmer:.5},{jump:.5},{at:.3}");
            }
        }
    }
    table
}
