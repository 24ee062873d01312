//! The figures as text: a table for the terminal and one for other programs.

use super::judge::{Judged, Row, BRUTE};
use super::method::Method;
use super::model::gaps;
use super::scene::{self, LIGHTS};
use crate::gap::figure::Figure;
use crate::imaging::measure::{samples, samples_for};
use crate::imaging::region::Region;
use crate::imaging::tally::{sizes, Of};
use std::fmt::Write;

/// All pixels, and those of each region.
const REGIONS: [Option<Region>; 4] = [None, Some(Region::Near), Some(Region::Between), Some(Region::Far)];

impl Row {
    /// Root mean square error of a method in a region, or of all pixels; NaN where there is none.
    pub fn rms(&self, method: Method, region: Option<Region>) -> f64 {
        sizes(&self.places, Of::Method(method as usize), region).rms.value
    }

    /// Stratified samples a pixel for the same root mean square error, or a bound.
    pub fn samples(&self, method: Method, region: Option<Region>) -> Result<f64, usize> {
        let brute = |(number, strata): (usize, usize)| {
            (strata * strata, sizes(&self.places, Of::Brute(number), region).rms.value)
        };
        let measured: Vec<(usize, f64)> = BRUTE.into_iter().enumerate().map(brute).collect();
        samples_for(self.rms(method, region), &measured)
    }
}

/// The table for the terminal.
pub fn text(judged: &Judged) -> String {
    let mut table = format!("{:20}", "");
    for name in ["all", "near", "mid", "far"] {
        let _ = write!(table, "{:>9}{:>7}{:>7}{:>8}", name, "99 %", "max", "samples");
    }
    table.push('\n');
    for row in &judged.rows {
        let _ = writeln!(table, "{}, {}", row.view.name, scene::suns(&row.view)[row.light]);
        let others = BRUTE
            .iter()
            .enumerate()
            .map(|(number, strata)| (format!("{} samples", strata * strata), Of::Brute(number)));
        let methods = Method::ALL.into_iter().map(|method| (method.label().to_owned(), Of::Method(method as usize)));
        for (label, of) in methods.chain(others).chain([("error of the truth".to_owned(), Of::Truth)]) {
            let _ = write!(table, "  {label:18}");
            for region in REGIONS {
                let found = sizes(&row.places, of, region);
                let count = match of {
                    Of::Method(number) if !found.rms.value.is_nan() => {
                        samples(row.samples(Method::ALL[number], region))
                    }
                    _ => String::new(),
                };
                for number in [found.rms.value, found.percentile.value, found.maximum.value] {
                    let _ = if number.is_nan() { write!(table, "{:>7}", "-") } else { write!(table, "{number:7.4}") };
                }
                let _ = write!(table, "{count:>8}  ");
            }
            table.push('\n');
        }
    }
    table
}

/// What the columns mean, for the terminal.
pub fn legend(device: &str, [width, height]: [usize; 2], places: usize) -> String {
    format!(
        "Errors of {width}x{height} pixels on {device}, from over {places} places:\n\
         root mean square, what 99 of 100 stay below, and the largest; of a pixel's worst channel, in linear color,\n\
         the variance of the truth taken off the first. samples: stratified samples a pixel at which brute force has\n\
         the same root mean square.\n\
         near: pixels that lose less than half of the variance of slopes. far: 90 % of it. mid: the others.\n"
    )
}

/// How far the methods are from the model, tap by tap, for the terminal.
pub fn model_text(judged: &Judged) -> String {
    let mut table = format!("{:46}{:>7}{:>9}{:>9}", "", "taps", "light", "product");
    for method in Method::FILTERED {
        let _ = write!(table, "{:>18}", method.label());
    }
    table.push('\n');
    for row in &judged.rows {
        for (correlated, which) in [(false, "all taps"), (true, "correlated")] {
            let gaps = gaps(&row.taps, correlated);
            let label = format!("{}, {}, {which}", row.view.name, scene::suns(&row.view)[row.light]);
            let _ = write!(table, "{label:46}{:7}{:9.4}{:9.4}", gaps.count, gaps.light, gaps.apart);
            for method in Method::FILTERED {
                let _ = write!(table, "{:18.4}", gaps.methods[method as usize]);
            }
            table.push('\n');
        }
    }
    table
}

/// What that table holds.
pub const MODEL_LEGEND: &str = "\
Against the model, in f64: the mean of color times irradiance over the heights and slopes that some of the taps see.
Root mean squares of the light, of how far the product of both means is from it, and of how far methods are.
correlated: taps where that product is off by more than 5 % of the light.
";

/// The same as comma-separated values, with standard errors over places.
pub fn model_csv(judged: &Judged) -> String {
    let mut table = String::from("view,sun,taps,count,light,product");
    for method in Method::FILTERED {
        let _ = write!(table, ",{name},{name}_se", name = method.stem());
    }
    table.push('\n');
    for row in &judged.rows {
        for (correlated, which) in [(false, "all"), (true, "correlated")] {
            let whole = gaps(&row.taps, correlated);
            let _ = write!(table, "{},{},{which},{}", row.view.name, LIGHTS[row.light], whole.count);
            let _ = write!(table, ",{:.5},{:.5}", whole.light, whole.apart);
            for method in Method::FILTERED {
                let [figure] = Figure::jackknife(&row.taps, |some| {
                    let methods = gaps(some.iter().copied(), correlated).methods;
                    [methods.get(method as usize).copied().unwrap_or(f64::NAN)]
                });
                let _ = write!(table, ",{:.5},{:.5}", figure.value, figure.error);
            }
            table.push('\n');
        }
    }
    table
}

/// All figures as comma-separated values, with standard errors over places and of the truth.
pub fn csv(judged: &Judged) -> String {
    let mut table = String::from(
        "view,sun,method,region,pixels,rms,rms_se,truth_se,percentile_99,percentile_99_se,maximum,samples\n",
    );
    for row in &judged.rows {
        for method in Method::ALL {
            REGIONS.into_iter().for_each(|region| csv_row(&mut table, row, method, region));
        }
    }
    table
}

fn csv_row(table: &mut String, row: &Row, method: Method, region: Option<Region>) {
    let found = sizes(&row.places, Of::Method(method as usize), region);
    if found.rms.value.is_nan() {
        return;
    }
    let truth = sizes(&row.places, Of::Truth, region).rms.value;
    let names = [row.view.name, LIGHTS[row.light], method.stem(), region.map_or("all", Region::name)];
    let regions = row.places.iter().flat_map(|place| &place.regions);
    let count = regions.filter(|of| region.is_none_or(|region| region == **of)).count();
    let numbers =
        [found.rms.value, found.rms.error, truth, found.percentile.value, found.percentile.error, found.maximum.value];
    let numbers = numbers.map(|number| format!("{number:.5}")).join(",");
    let _ = writeln!(table, "{},{count},{numbers},{}", names.join(","), samples(row.samples(method, region)));
}
