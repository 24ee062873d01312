//! Every filter by itself: its tiers against the map at the mean, the paper's recipe and stratified samples.

pub mod brute;
pub mod case;
pub mod combine;
pub mod driver;
pub mod height;
pub mod height_transfer;
pub mod irradiance;
pub mod maps;
pub mod measure;
pub mod percentile;
pub mod pixel;
pub mod slope;
pub mod slope_map;
pub mod steepness;
pub mod summary;
pub mod table;
pub mod texture;

use super::document::{Item, Section};
use super::{Bench, Error, Extent};
use case::Case;
use summary::Done;

/// What the figures are of.
const ABOUT: &str = "\
    Each filter alone, over random statistics of pixels: means evenly over the scene's ranges, deviations evenly in \
    their logarithm, slopes of two deviations with a correlation, views and lights from which the mean surface is \
    seen. A pixel's error is that of its worst channel against the integral, by quadrature in f64. What stands \
    behind ± is the spread over four seeds by the jackknife: a standard error of root mean squares, and of \
    percentiles and largest errors only how much they differ between seeds. Times are those of kernels that read a \
    pixel's statistics and write its color, all of a case by turns in one run, the fastest of 31 turns each, of 7 in \
    a quick report; on a processor by one thread. Every kernel is timed over four times as many pixels for as long \
    as it takes less than a millisecond or that makes each a tenth cheaper, up to two million.";

/// What brute force is.
const BRUTE: &str = "Brute force is what a renderer does without a filter: k × k jittered strata of the pixel, in \
    each of which the map is evaluated at a sample. Values, heights and percentiles turn across the pixel in one \
    direction, so that k strata tell them apart, with k samples each; slopes turn in both. In the combination heights \
    and values have k × k strata of their own, and of a curve's heights the samples hide each other from the highest \
    of k × k strata down. Heights are drawn from those that the view sees, as rays find them, and count by the chance \
    that light reaches them; slopes are drawn from all and count by the area that the view sees of them. A noise that \
    turns many times within a pixel is stratified less, and needs more. The errors are against the same integral, so \
    that they are those of sampling alone.";

/// What times behind a driver are.
const DRIVEN: &str = "A naive map alone costs little more than to read its arguments; no pixel has its statistics for \
    nothing. Ratios with a driver are those of kernels that find the statistics of six octaves of noise over the \
    pixel's footprint, slopes included where the filter takes them, and then filter: the naive one finds the same.";

/// A filter of the report.
#[derive(Clone, Copy)]
pub struct Filter {
    /// Its name in files.
    stem: &'static str,
    /// What it is, in a few words.
    name: &'static str,
    /// The time over that of naive that was asked on a GPU.
    asked: Option<f64>,
    cases: fn(usize) -> Result<Vec<Case>, Error>,
}

const fn filter(
    stem: &'static str,
    name: &'static str,
    asked: Option<f64>,
    cases: fn(usize) -> Result<Vec<Case>, Error>,
) -> Filter {
    Filter { stem, name, asked, cases }
}

const FILTERS: [Filter; 9] = [
    filter("texture", "color by value (C0)", Some(1.1), texture::cases),
    filter("height", "color by visible height (Ch)", Some(1.5), height::cases),
    filter("percentile", "color by percentile (Ch)", None, percentile::cases),
    filter("slope", "color by visible slope along a direction (Cs)", Some(2.5), slope::cases),
    filter("slope_map", "color by the whole visible slope", Some(2.5), slope_map::cases),
    filter("steepness", "color by visible steepness", Some(2.5), steepness::cases),
    filter("irradiance", "irradiance over visible normals", None, irradiance::cases),
    filter("combination", "values, heights and slopes together", None, combine::cases),
    filter("transfer", "color by height of a curve", None, height_transfer::cases),
];

/// Every case, of so many maps of each filter.
///
/// # Errors
/// Damaged data.
pub fn cases(maps: usize) -> Result<Vec<Case>, Error> {
    let of = |filter: &Filter| (filter.cases)(maps);
    Ok(FILTERS.iter().map(of).collect::<Result<Vec<_>, _>>()?.into_iter().flatten().collect())
}

/// Maps of a filter, at most.
fn maps(extent: Extent) -> usize {
    extent.pick(1, 2)
}

/// Steps of the progress bar: three for every case, of which light and the combination have one.
pub fn steps(extent: Extent) -> u64 {
    3 * extent.pick(FILTERS.len(), 2 * FILTERS.len() - 2) as u64
}

/// Measures every filter.
///
/// # Errors
/// Those of scenes and of the device.
pub fn section(bench: &Bench<'_>) -> Result<Section, Error> {
    let mut done: Vec<Done> = Vec::new();
    for filter in FILTERS {
        let mut cases = Vec::new();
        for case in (filter.cases)(maps(bench.extent))? {
            let measured = measure::measure(bench, &case)?;
            cases.push((case, measured));
        }
        done.push((filter, cases));
    }
    let mut items = vec![Item::Text(ABOUT.to_owned()), Item::Text(BRUTE.to_owned()), Item::Text(DRIVEN.to_owned())];
    items.push(Item::Table(summary::summary(&done)?));
    for (filter, cases) in &done {
        items.push(Item::Table(table::table(filter, cases)?));
        items.extend(cases.iter().map(|(case, measured)| Item::Plot(table::plot(filter.name, case, measured))));
    }
    items.push(Item::Table(summary::asked(&done)));
    Ok(Section { stem: "filters".to_owned(), title: "Every filter by itself".to_owned(), items })
}
