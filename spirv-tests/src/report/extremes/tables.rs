//! The tables of hard cases.

use super::cases::Case;
use super::drivers::{self, Source};
use super::filters::Filter;
use super::judge;
use super::outcome::Outcome;
use crate::report::document::{Cell, Item, Table};
use crate::report::{Bench, Error};

/// Steps of these tables.
pub const STEPS: u64 = (Filter::ALL.len() + Source::ALL.len()) as u64;

/// The tables, and what they say; each filter and driver at so many points a case.
///
/// # Errors
/// A message where a filter or a driver cannot be judged.
pub fn items(bench: &Bench<'_>, count: usize) -> Result<Vec<Item>, Error> {
    let (mut filters, mut drivers) = (Vec::new(), Vec::new());
    for filter in Filter::ALL {
        filters.extend(judge::outcomes(bench.device, bench.cache, filter, count).map_err(Error::Measured)?);
        (bench.done)(1);
    }
    for source in Source::ALL {
        drivers.extend(drivers::outcomes(bench.device, source, count).map_err(Error::Measured)?);
        (bench.done)(1);
    }
    let broken = filters.iter().chain(&drivers).filter(|outcome| !outcome.holds());
    let broken: Vec<String> = broken.map(|outcome| format!("{}, {}", outcome.subject, outcome.case.name())).collect();
    let held = if broken.is_empty() { "All hold.".to_owned() } else { format!("Broken: {}.", broken.join("; ")) };
    let text = format!(
        "Every filter and driver where it is hard, at {count} points a case. An error is the largest of a channel \
         against f64, wherever there is a truth: what is not seen has no color. Truths of filters are quadratures of \
         their integrals, where deviations of values and heights beyond the ranges count as the largest, as `Ranges` \
         says; those of Gabor noise, stripes and waves are exact means, of Perlin's noise its own model's mean, of \
         pyramids what the model of a read makes of the image. Most cases go beyond what scenes declare: bounds are \
         asked for where modules explain that they hold, and beyond that against what inputs count as there; numbers \
         in the hull of the colors, of values and of shares everywhere; a test asks for that, too. {held}"
    );
    Ok(vec![
        Item::Text(text),
        Item::Table(what()),
        Item::Table(errors(
            "extremes_filters",
            "Largest errors of filters, in color units.",
            &Filter::ALL.map(Filter::name),
            &filters,
        )),
        Item::Table(errors(
            "extremes_drivers",
            "Largest errors of what drivers find: means, in values or deviations, and covariances of slopes.",
            &Source::ALL.map(Source::name),
            &drivers,
        )),
        Item::Table(bounds(&filters)),
    ])
}

fn what() -> Table {
    Table {
        stem: "extremes_cases".into(),
        caption: "The cases.".into(),
        columns: ["case", "what is hard, and the inputs"].map(Into::into).to_vec(),
        rows: Case::ALL.map(|case| vec![case.name().into(), case.hard().into()]).to_vec(),
    }
}

/// Errors by case and subject, with the number of invariants that are violated.
fn errors(stem: &str, caption: &str, subjects: &[&'static str], outcomes: &[Outcome]) -> Table {
    let row = |case: Case| {
        let of = |subject: &str| outcomes.iter().find(|outcome| outcome.case == case && outcome.subject == subject);
        let cell = |subject: &&str| {
            of(subject).filter(|found| found.judged > 0).map_or(Cell::Nothing, |found| found.error.into())
        };
        let met: Vec<&Outcome> = subjects.iter().filter_map(|subject| of(subject)).collect();
        let violations = met.iter().map(|outcome| outcome.violations).sum::<usize>();
        let first = std::iter::once(case.name().into());
        (!met.is_empty()).then(|| first.chain(subjects.iter().map(cell)).chain([violations.into()]).collect())
    };
    let columns = std::iter::once("case").chain(subjects.iter().copied()).chain(["violations"]);
    Table {
        stem: stem.into(),
        caption: caption.into(),
        columns: columns.map(Into::into).collect(),
        rows: Case::ALL.into_iter().filter_map(row).collect(),
    }
}

/// What is promised of each filter in each case, and what was measured there and everywhere.
fn bounds(outcomes: &[Outcome]) -> Table {
    let row = |outcome: &Outcome| {
        let of_any = |count: usize, error: f64| if count > 0 { error.into() } else { Cell::Nothing };
        vec![
            outcome.subject.into(),
            outcome.case.name().into(),
            outcome.points.into(),
            of_any(outcome.judged, outcome.error),
            outcome.promised.into(),
            of_any(outcome.promised, outcome.promised_error),
            outcome.bound.map_or(Cell::Nothing, Into::into),
            outcome.violations.into(),
        ]
    };
    let columns = ["filter", "case", "points", "error", "covered", "error there", "bound", "violations"];
    Table {
        stem: "extremes_bounds".into(),
        caption: "Errors of filters at all points, at those that a bound covers, and the largest bound.".into(),
        columns: columns.map(Into::into).to_vec(),
        rows: outcomes.iter().map(row).collect(),
    }
}
