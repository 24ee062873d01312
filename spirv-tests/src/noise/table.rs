//! The figures as text: a table for the terminal and one for other programs.

use super::judge::Judged;
use super::method::{Method, TIMED};
use crate::demo::motion::Motion;
use crate::imaging::measure::samples;
use crate::imaging::region::Region;
use crate::imaging::tally::{sizes, Of};
use std::fmt::Write;

/// All pixels, and those of each region.
const REGIONS: [Option<Region>; 4] = [None, Some(Region::Near), Some(Region::Between), Some(Region::Far)];

/// The table of one input for the terminal.
pub fn text(judged: &Judged) -> String {
    let mut table = format!("{}: {}\n{:23}", judged.input.name, judged.input.title, "method");
    for name in ["all", "+-", "near", "mid", "far", "99 %", "max", "samples", "pan", "+-", "zoom", "+-", "ms"] {
        let _ = write!(table, "{name:>8}");
    }
    table.push('\n');
    for method in judged.input.methods() {
        let of = |region| sizes(&judged.stills, Of::Method(method.number()), region);
        let (all, regions) = (of(None), [Region::Near, Region::Between, Region::Far].map(|region| of(Some(region))));
        let _ = write!(table, "{:23}{:8.4}{:8.4}", method.label(), all.rms.value, all.rms.error);
        for number in
            regions.map(|region| region.rms.value).into_iter().chain([all.percentile.value, all.maximum.value])
        {
            let _ = write!(table, "{number:8.4}");
        }
        let _ = write!(table, "{:>8}", samples(judged.samples(method, None)));
        for motion in Motion::ALL {
            let shimmer = judged.shimmer(method, motion);
            let _ = write!(table, "{:8.4}{:8.4}", shimmer.value, shimmer.error);
        }
        let _ = writeln!(table, "{:8.2}", judged.milliseconds[method.number()]);
    }
    let truth = REGIONS.map(|region| format!("{:.4}", sizes(&judged.stills, Of::Truth, region).rms.value));
    let _ = writeln!(table, "standard error of the truth, all, near, mid and far: {}", truth.join(", "));
    table
}

/// What the columns mean, in a few lines for the terminal.
pub fn legend(device: &str, seeds: u32) -> String {
    format!(
        "Errors are those of a pixel's worst channel, in linear color, over {seeds} parts of the noise, +- their\n\
         standard errors.\n\
         near: pixels that lose less than half of the variance of the noise. far: 90 % of it. mid: the others.\n\
         samples: stratified samples a pixel at which brute force has the same root mean square.\n\
         pan, zoom: shimmer, the deviation of the error over the frames, root mean square over the pixels.\n\
         ms: a still on {device}, the fastest of {TIMED} after 2.\n"
    )
}

/// All figures as comma-separated values, with standard errors over parts of the noise and of the truth.
pub fn csv(all: &[Judged]) -> String {
    let mut table = String::from(
        "input,method,region,pixels,rms,rms_se,truth_se,percentile_99,percentile_99_se,maximum,samples,shimmer_pan,\
         shimmer_pan_se,shimmer_zoom,shimmer_zoom_se\n",
    );
    for judged in all {
        for method in judged.input.methods() {
            REGIONS.into_iter().for_each(|region| csv_row(&mut table, judged, method, region));
        }
    }
    table
}

fn csv_row(table: &mut String, judged: &Judged, method: Method, region: Option<Region>) {
    let found = sizes(&judged.stills, Of::Method(method.number()), region);
    let regions = judged.stills.iter().flat_map(|still| &still.regions);
    let count = regions.filter(|of| region.is_none_or(|region| region == **of)).count();
    if count == 0 {
        return;
    }
    let truth = sizes(&judged.stills, Of::Truth, region).rms.value;
    let numbers =
        [found.rms.value, found.rms.error, truth, found.percentile.value, found.percentile.error, found.maximum.value];
    let numbers = numbers.map(|number| format!("{number:.5}")).join(",");
    let (name, method_name, region_name) = (judged.input.name, method.label(), region.map_or("all", Region::name));
    let samples = samples(judged.samples(method, region));
    let _ = write!(table, "{name},{method_name},{region_name},{count},{numbers},{samples}");
    if region.is_none() {
        for motion in Motion::ALL {
            let shimmer = judged.shimmer(method, motion);
            let _ = write!(table, ",{:.5},{:.5}", shimmer.value, shimmer.error);
        }
    } else {
        table.push_str(",,,,");
    }
    table.push('\n');
}
