//! The figures as text: a table for the terminal and one for other programs.

use super::judge::Judged;
use super::method::Method;
use crate::imaging::look::Quantity;
use crate::imaging::measure::samples;
use std::fmt::Write;

/// The table for the terminal.
pub fn text(judged: &Judged) -> String {
    let mut table = format!("{:20}", "");
    for quantity in Quantity::ALL {
        let _ = write!(table, "{:>10}{:>8}{:>8}{:>9}", quantity.name(), "99 %", "max", "samples");
    }
    table.push('\n');
    for row in &judged.rows {
        let _ = writeln!(table, "{}", row.view.title);
        for method in Method::ALL {
            let _ = write!(table, "  {:18}", method.label());
            for quantity in Quantity::ALL {
                let (rms, sizes) = (row.rms(method, quantity).value, row.sizes(method, quantity));
                let _ = write!(table, "{rms:10.4}{:8.4}{:8.4}", sizes.percentile, sizes.maximum);
                let _ = write!(table, "{:>9}", samples(row.samples(method, quantity)));
            }
            table.push('\n');
        }
        let _ = write!(table, "  {:18}", "error of the truth");
        for quantity in Quantity::ALL {
            let _ = write!(table, "{:10.4}{:25}", row.truth_error(quantity), "");
        }
        let brute = row.brute(Quantity::Color);
        let brute: Vec<String> = brute.iter().map(|(count, rms)| format!("{count}: {rms:.4}")).collect();
        let _ = writeln!(table, "\n  color of brute force by samples: {}", brute.join(", "));
    }
    table
}

/// What the columns mean, for the terminal.
pub fn legend(device: &str, [width, height]: [usize; 2], seeds: usize) -> String {
    format!(
        "Root mean square errors of {width}x{height} pixels on {device}, over {seeds} skins; of a pixel's worst\n\
         channel, in linear color, times the share of the pixel that the snake covers, the variance of the truth\n\
         taken off. color: of what is seen. lit: times irradiance over pi. 99 %, max: with the error of the truth.\n\
         samples: stratified samples a pixel at which brute force has the same RMS.\n"
    )
}

/// All figures as comma-separated values: root mean square errors, their standard error over skins, and the standard
/// error of the truth, whose variance they do not hold.
pub fn csv(judged: &Judged) -> String {
    let mut table = String::from("view,method,quantity,rms,rms_se,truth_se,percentile_99,maximum,samples\n");
    for row in &judged.rows {
        for (method, quantity) in Method::ALL.into_iter().flat_map(|method| Quantity::ALL.map(|of| (method, of))) {
            let (figure, sizes) = (row.rms(method, quantity), row.sizes(method, quantity));
            let numbers = [figure.value, figure.error, row.truth_error(quantity), sizes.percentile, sizes.maximum];
            let numbers = numbers.map(|number| format!("{number:.5}")).join(",");
            let samples = samples(row.samples(method, quantity));
            let _ = writeln!(table, "{},{},{},{numbers},{samples}", row.view.name, method.label(), quantity.name());
        }
    }
    table
}
