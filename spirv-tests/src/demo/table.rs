//! The figures as text: a table for the terminal and one for other programs.

use super::judge::Judged;
use super::method::TIMED;
use super::motion::Motion;
use crate::imaging::measure::samples;
use std::fmt::Write;

/// The table of one input for the terminal.
pub fn text(judged: &Judged) -> String {
    let mut table = format!("{}: {}\n", judged.name, judged.title);
    let _ = write!(table, "{:22}{:>8}{:>8}{:>8}{:>9}{:>9}", "method", "RMS", "99 %", "max", "ms", "samples");
    for motion in &judged.motions {
        let _ = write!(table, "{:>8}", motion.motion.label());
    }
    table.push('\n');
    for row in &judged.rows {
        let errors = row.deviation;
        let _ =
            write!(table, "{:22}{:8.4}{:8.4}{:8.4}", row.method.label(), errors.rms, errors.percentile, errors.maximum);
        let _ = write!(table, "{:9.2}{:>9}", row.milliseconds, samples(row.samples));
        for shimmer in &row.shimmer {
            let _ = write!(table, "{shimmer:8.4}");
        }
        table.push('\n');
    }
    let brute: Vec<String> = judged.brute.iter().map(|(count, rms)| format!("{count}: {rms:.4}")).collect();
    let _ = writeln!(table, "brute force, RMS by stratified samples a pixel: {}", brute.join(", "));
    let _ = write!(table, "standard error of the truth: {:.4}", judged.truth_error);
    for motion in &judged.motions {
        let _ = write!(table, ", {:.4} in a frame of the {}", motion.truth_error, motion.motion.label());
    }
    table + "\n"
}

/// What the columns mean, in a few lines for the terminal.
pub fn legend(device: &str, [width, height]: [usize; 2]) -> String {
    format!(
        "Errors are those of a pixel's worst channel, in linear color.\n\
         ms: a frame of {width}x{height} on {device}, the fastest of {TIMED} after 2.\n\
         samples: stratified samples a pixel at which brute force has the same RMS.\n\
         pan, zoom: shimmer, the deviation of the error over the frames, RMS over the pixels.\n"
    )
}

/// All figures as comma-separated values.
pub fn csv(all: &[Judged]) -> String {
    let motions: String = Motion::ALL.iter().map(|motion| format!(",shimmer_{}", motion.label())).collect();
    let mut table = format!("input,method,rms,percentile_99,maximum,milliseconds,samples{motions}\n");
    for judged in all {
        for row in &judged.rows {
            let errors = row.deviation;
            let numbers =
                [errors.rms, errors.percentile, errors.maximum].map(|number| format!("{number:.5}")).join(",");
            let _ = write!(table, "{},\"{}\",{numbers},{:.3},", judged.name, row.method.label(), row.milliseconds);
            let _ = write!(table, "{}", samples(row.samples));
            for shimmer in &row.shimmer {
                let _ = write!(table, ",{shimmer:.5}");
            }
            table.push('\n');
        }
    }
    table
}
