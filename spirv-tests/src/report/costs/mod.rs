//! What things cost: closed forms against tables, mixtures against tables, and the weights by which tiers are chosen.

mod fit;
mod kernels;
mod mixtures;
mod model;
mod stops;
mod weights;

use super::document::{Item, Section};
use super::{Bench, Error, Extent};

/// What the figures are of.
const ABOUT: &str = "\
    Times are those of kernels that read a pixel's statistics and write its color, all of a table or a plot by turns \
    in one run, the fastest of 31 turns each, of 7 in a quick report; on a processor by one thread. A weight is the \
    number by which the lightest tier within an accuracy is chosen: operations, and for each fetch as many as the \
    table of functions says.";

/// Steps of the progress bar.
pub fn steps(_: Extent) -> u64 {
    stops::STEPS + mixtures::STEPS + weights::STEPS + model::STEPS
}

/// Measures all of it.
///
/// # Errors
/// Those of scenes and of the device.
pub fn section(bench: &Bench<'_>) -> Result<Section, Error> {
    let mut items = vec![Item::Text(ABOUT.to_owned())];
    items.extend(stops::items(bench)?);
    items.extend(mixtures::items(bench)?);
    items.extend(weights::items(bench)?);
    items.extend(model::items(bench)?);
    Ok(Section { stem: "costs".to_owned(), title: "What closed forms, tables and mixtures cost".to_owned(), items })
}
