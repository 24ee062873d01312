//! Every filter by itself: its tiers against the map at the mean, the paper's recipe and stratified samples.

pub mod brute;
pub mod case;
pub mod measure;
pub mod pixel;
pub mod table;
pub mod texture;

use super::document::{Item, Section};
use super::{Bench, Error, Extent};
use case::Case;

/// What the figures are of.
const ABOUT: &str = "Each filter alone, over random statistics of pixels: means evenly over the scene's ranges, \
    deviations evenly in their logarithm, slopes of two deviations with a correlation, views and lights from which \
    the mean surface is seen. A pixel's error is that of its worst channel against the integral, by quadrature in \
    f64; standard errors are from four seeds. Times are those of kernels that read a pixel's statistics and write its \
    color, all of a case by turns in one run, the fastest of 31 turns each; on a processor by one thread.";

/// What brute force is.
const BRUTE: &str = "Brute force is what a renderer does without a filter: k × k jittered strata of the pixel, in \
    each of which the map is evaluated at a sample. Values and heights turn across the pixel in one direction, slopes \
    in both: the best case, as those of a noise turn many times within a pixel and are stratified less. Heights are \
    drawn from those that the view sees, as rays find them, and count by the chance that light reaches them; slopes \
    are drawn from all and count by the area that the view sees of them. The errors are against the same integral, so \
    that they are those of sampling alone.";

/// A filter of the report.
struct Filter {
    stem: &'static str,
    caption: &'static str,
    cases: fn(usize) -> Result<Vec<Case>, Error>,
}

const FILTERS: [Filter; 1] =
    [Filter { stem: "texture", caption: "C0: a color map over a value.", cases: texture::cases }];

/// Every case, of so many maps of each filter.
///
/// # Errors
/// Damaged data.
pub fn cases(maps: usize) -> Result<Vec<Case>, Error> {
    let of = |filter: &Filter| (filter.cases)(maps);
    Ok(FILTERS.iter().map(of).collect::<Result<Vec<_>, _>>()?.into_iter().flatten().collect())
}

/// Maps of each filter.
fn maps(extent: Extent) -> usize {
    extent.pick(1, 2)
}

/// Steps of the progress bar: three for every case.
pub fn steps(extent: Extent) -> u64 {
    3 * (FILTERS.len() * maps(extent)) as u64
}

/// Measures every filter.
///
/// # Errors
/// Those of scenes and of the device.
pub fn section(bench: &Bench<'_>) -> Result<Section, Error> {
    let mut items = vec![Item::Text(ABOUT.to_owned()), Item::Text(BRUTE.to_owned())];
    for filter in FILTERS {
        let mut cases = Vec::new();
        for case in (filter.cases)(maps(bench.extent))? {
            let measured = measure::measure(bench, &case)?;
            cases.push((case, measured));
        }
        items.push(Item::Table(table::table(filter.stem, filter.caption, &cases)?));
        items.extend(cases.iter().map(|(case, measured)| Item::Plot(table::plot(filter.caption, case, measured))));
    }
    Ok(Section { stem: "filters".to_owned(), title: "Every filter by itself".to_owned(), items })
}
