//! Accuracies: whether what a budget chooses keeps it, how much cheaper it is than the finest tier, and how wide its
//! bound is.

pub mod case;
mod curves;
pub mod filter;
pub mod pixel;
mod slopes;
pub mod tally;
pub mod trial;
pub mod truth;
mod values;

use prefilter::gpu::Device;

use super::cache::Cache;
use super::document::{Axis, Item, Plot, Section, Series, Table};
use super::{Bench, Error, Extent};
use crate::gap::figure::over_seeds;
use filter::Filter;
use tally::Tally;
use trial::{trial, Trial};

/// Scenes between two steps of the progress bar.
const CHUNK: u64 = 20;

/// Scenes in all, and the share of the usual pixels of each.
fn plan(extent: Extent) -> (usize, f64) {
    extent.pick((100, 0.25), (10_000, 0.5))
}

/// Steps of the progress bar.
pub fn steps(extent: Extent) -> u64 {
    (plan(extent).0 as u64).div_ceil(CHUNK)
}

/// Judges scenes of numbers from `first` on, whose truths are kept; `done` is called after one in twenty.
///
/// # Errors
/// Those of the scenes and of the device.
pub fn trials(
    (device, cache): (&Device, &Cache),
    first: u32,
    (count, density): (usize, f64),
    done: &(dyn Fn(u64) + Sync),
) -> Result<Vec<Trial>, prefilter::Error> {
    let all = over_seeds(count, |number| {
        let judged = trial(device, cache, first + number as u32, density);
        if number % CHUNK == 0 {
            done(1);
        }
        judged
    });
    all.into_iter().collect()
}

/// What came of random scenes with random budgets.
///
/// # Errors
/// Those of the scenes and of the device.
pub fn section(bench: &Bench<'_>) -> Result<Section, Error> {
    let (count, density) = plan(bench.extent);
    let trials = trials((bench.device, bench.cache), 0, (count, density), bench.done)?;
    let whole = Tally::new(&trials.iter().collect::<Vec<_>>());
    let share = match whole.cheaper {
        Some((cheaper, counted)) => format!("{:.1} % of {counted}", 100.0 * cheaper as f64 / counted as f64),
        None => "none".to_owned(),
    };
    let text = format!(
        "{count} random scenes ask for random accuracies: those of values for 1e-4 to 0.3, others from half a step of \
         eight bits on, or, where no tier keeps that, from the bound of the closest on. What is chosen is compared on \
         the device with the integral in f64 where filters go wrong: about the edges of the map, at the corners of the \
         ranges, for footprints of all sizes, seen from overhead to the horizon. {} of the largest errors exceed the \
         bound, which in the median is {:.1} times as large. Of scenes for which something that filters, keeps 0.3 \
         and is cheaper than the finest tier exists, {share} take such. Not drawn are drivers, light on \
         combinations, two or learned distributions, noise on heights, and Λ beyond 1e4.",
        whole.exceeded, whole.median
    );
    Ok(Section {
        stem: "accuracy".to_owned(),
        title: "Accuracy: the budget that chooses".to_owned(),
        items: vec![
            Item::Text(text),
            Item::Table(tally::by_filter(&trials)),
            Item::Table(tally::choices(&trials)),
            Item::Plot(scatter(&trials)),
        ],
    })
}

/// Bounds over measured errors.
fn scatter(trials: &[Trial]) -> Plot {
    let axis = |label: &str| Axis { label: label.to_owned(), logarithmic: true };
    let shown = |error: f64| if error.is_finite() { error } else { 1.0 };
    let of = |filter: &Filter| {
        let own = trials.iter().filter(|trial| trial.filter == *filter);
        Series {
            label: filter.name().to_owned(),
            points: own.map(|trial| [shown(trial.measured), trial.bound]).collect(),
            joined: false,
        }
    };
    let line = Series { label: "as large".to_owned(), points: vec![[1e-8, 1e-8], [1.0, 1.0]], joined: true };
    Plot {
        stem: "accuracy_bounds".to_owned(),
        caption: "The bound of what was chosen over the largest error that was measured, both in color units: a point \
                  below the line would be a bound that does not hold; a color that is no number counts as off by 1."
            .to_owned(),
        x: axis("largest error measured"),
        y: axis("bound"),
        series: Filter::ALL.iter().map(of).chain([line]).collect(),
    }
}
