//! Figures of many trials.

use std::collections::BTreeMap;

use super::{Filter, Table, Trial};
use crate::report::document::Cell;

/// Figures of some trials.
#[derive(Clone, Debug, PartialEq)]
pub struct Tally {
    /// How many.
    pub count: usize,
    /// How many of the budgets that were drawn first no tier keeps.
    pub refused: usize,
    /// How many took what is cheaper than the finest tier, of those for which there is such a tier.
    pub cheaper: Option<(usize, usize)>,
    /// How many errors exceed their bounds.
    pub exceeded: usize,
    /// The largest error over its bound.
    pub worst: f64,
    /// The median of bounds over errors.
    pub median: f64,
}

impl Tally {
    /// Of these; of none all figures are 0.
    pub fn new(trials: &[&Trial]) -> Self {
        let all = trials.iter();
        let counted = all.clone().filter(|trial| trial.cheaper.is_some()).count();
        let cheaper = all.clone().filter(|trial| trial.cheaper == Some(true)).count();
        let mut ratios: Vec<f64> = all.clone().map(|trial| trial.bound / trial.measured.max(1e-30)).collect();
        ratios.sort_by(f64::total_cmp);
        Self {
            count: trials.len(),
            refused: all.clone().filter(|trial| trial.refused).count(),
            cheaper: (counted > 0).then_some((cheaper, counted)),
            // Written so that NaN counts.
            exceeded: all.clone().filter(|trial| !(trial.measured <= trial.bound)).count(),
            worst: all.map(|trial| trial.measured / trial.bound).fold(0.0, f64::max),
            median: ratios.get(ratios.len() / 2).copied().unwrap_or(0.0),
        }
    }

    fn cells(&self) -> Vec<Cell> {
        let (cheaper, counted) = self.cheaper.unwrap_or((0, 0));
        let share = if counted == 0 { Cell::Nothing } else { Cell::Number(cheaper as f64 / counted as f64) };
        vec![
            self.count.into(),
            self.refused.into(),
            counted.into(),
            share,
            self.exceeded.into(),
            self.worst.into(),
            self.median.into(),
        ]
    }
}

/// Figures filter by filter, and of all.
pub fn by_filter(trials: &[Trial]) -> Table {
    let row = |name: &str, some: &[&Trial]| [vec![Cell::from(name)], Tally::new(some).cells()].concat();
    let of = |filter: &Filter| {
        let own: Vec<&Trial> = trials.iter().filter(|trial| trial.filter == *filter).collect();
        row(filter.name(), &own)
    };
    let whole = row("all", &trials.iter().collect::<Vec<_>>());
    Table {
        stem: "accuracy_filters".to_owned(),
        caption:
            "Random scenes with random budgets. Refused: no tier keeps the budget that was drawn first. Choosable: \
                  something cheaper than the finest tier keeps an error of 0.3; cheaper: the share of these that take \
                  such."
                .to_owned(),
        columns: [
            "filter",
            "scenes",
            "refused",
            "choosable",
            "cheaper",
            "exceeded",
            "worst error/bound",
            "median bound/error",
        ]
        .map(str::to_owned)
        .to_vec(),
        rows: Filter::ALL.iter().map(of).chain([whole]).collect(),
    }
}

/// How often each tier is chosen.
pub fn choices(trials: &[Trial]) -> Table {
    let mut counts: BTreeMap<(usize, &str), usize> = BTreeMap::new();
    for trial in trials {
        let place = Filter::ALL.iter().position(|filter| *filter == trial.filter).unwrap_or(0);
        *counts.entry((place, &trial.label)).or_default() += 1;
    }
    let row = |((place, label), count): ((usize, &str), usize)| {
        vec![Filter::ALL[place].name().into(), label.into(), count.into()]
    };
    Table {
        stem: "accuracy_choices".to_owned(),
        caption: "What the budgets choose.".to_owned(),
        columns: ["filter", "tier", "scenes"].map(str::to_owned).to_vec(),
        rows: counts.into_iter().map(row).collect(),
    }
}
