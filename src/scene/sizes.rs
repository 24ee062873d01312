//! Sizes of tables that a scene tries.

use super::candidate::Candidate;
use super::Scene;
use crate::filter::height::HeightTier;
use crate::filter::texture::{NODES, SIZES};
use crate::filter::Tier;
use crate::table::Table;
use crate::Error;

/// How many times as close a table of twice the nodes along each axis may be: a bend between two nodes is read half as
/// wrong, what is smooth a fourth.
const CLOSER: f32 = 4.0;

/// ` of 64 × 8 texels`, or nothing where a table is of its tier's own size.
pub(super) fn of_texels<const N: usize>(nodes: [usize; N], own: [usize; N]) -> String {
    if nodes == own {
        return String::new();
    }
    format!(" of {} {}", nodes.map(|count| count.to_string()).join(" × "), if N == 1 { "columns" } else { "texels" })
}

impl Scene {
    /// The sizes from which the accuracy chooses; where there is none or the scene names the table, its own.
    pub(super) fn sizes<T: Copy>(&self, sizes: &[T], own: T) -> Vec<T> {
        if self.accuracy.is_some() && self.tier.is_none() {
            sizes.to_vec()
        } else {
            vec![own]
        }
    }

    /// The candidates of some tiers of C0, each with the sizes of its table, beside others: `attempt` is given the
    /// bound above which a table is not worth its baking.
    pub(super) fn by_tiers(
        &self,
        candidates: &mut Vec<Candidate>,
        tiers: Vec<Tier>,
        attempt: impl Fn(Tier, [usize; 2], f32) -> Result<Vec<Candidate>, Error>,
    ) -> Result<(), Error> {
        for tier in tiers {
            let sizes = if tier == Tier::Table { self.sizes(&SIZES, NODES) } else { vec![NODES] };
            self.beside(candidates, &sizes, |nodes, worth| attempt(tier, nodes, worth))?;
        }
        Ok(())
    }

    /// The candidates of tables of rising sizes, up to that from which on none would be chosen: a larger table weighs
    /// no less, and is tried where it may keep an accuracy that the smaller one does not.
    pub(super) fn by_sizes<T: Copy>(
        &self,
        sizes: &[T],
        attempt: impl Fn(T) -> Result<Vec<Candidate>, Error>,
    ) -> Result<Vec<Candidate>, Error> {
        let mut candidates = Vec::new();
        self.beside(&mut candidates, sizes, |size, _| attempt(size))?;
        Ok(candidates)
    }

    /// The largest bound with which a table beside some others, of which more may follow, is worth its baking.
    fn worth(&self, others: &[Candidate]) -> f32 {
        let named = self.tier.is_some() || self.height_tier.is_some_and(HeightTier::stands_alone);
        let alone = others.is_empty() && self.accuracy.is_none();
        if named || alone {
            f32::INFINITY
        } else {
            self.budget(others)
        }
    }

    /// Whether candidates whose tables are not baked would change nothing beside others, were they as close as may be:
    /// none of them is both close enough and lighter than what is chosen of the others, or so close that it is not.
    fn outweighed(&self, unbaked: &[Candidate], others: &[Candidate]) -> bool {
        let Some(chosen) = self.lightest(others).map(|place| &others[place]) else { return false };
        let budget = self.budget(others);
        let wins = |one: &Candidate| one.judged <= budget && one.cost.order() < chosen.cost.order();
        !unbaked.iter().any(wins) && self.budget(unbaked) >= budget
    }

    /// The candidates of an attempt, whose tables are not baked where that changes nothing beside others.
    fn worthwhile(
        &self,
        candidates: &[Candidate],
        attempt: impl Fn(f32) -> Result<Vec<Candidate>, Error>,
    ) -> Result<Vec<Candidate>, Error> {
        if self.lightest(candidates).is_some() {
            let unbaked = attempt(f32::NEG_INFINITY)?;
            if unbaked.iter().all(Candidate::is_baked) || self.outweighed(&unbaked, candidates) {
                return Ok(unbaked);
            }
        }
        attempt(self.worth(candidates))
    }

    /// The same beside others, in the order in which they are tried.
    pub(super) fn beside<T: Copy>(
        &self,
        candidates: &mut Vec<Candidate>,
        sizes: &[T],
        attempt: impl Fn(T, f32) -> Result<Vec<Candidate>, Error>,
    ) -> Result<(), Error> {
        let asked = self.accuracy.unwrap_or_default().max_filter_error;
        for (larger, &size) in (0..sizes.len()).rev().zip(sizes) {
            let tried = self.worthwhile(candidates, |worth| attempt(size, worth))?;
            let may_gain = |candidate: &Candidate| {
                let tables = candidate.filter.tables.iter().map(Table::part).sum::<f32>();
                let rest = candidate.judged - tables;
                candidate.judged > asked && tables <= (asked - rest) * CLOSER.powi(larger as i32)
            };
            let go_on = tried.iter().any(may_gain);
            candidates.extend(tried);
            if !go_on {
                break;
            }
        }
        Ok(())
    }
}
