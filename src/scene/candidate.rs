//! The tiers that a scene tries, and which one it takes.

use std::collections::BTreeMap;
use std::fmt::Write;

use super::Scene;
use crate::accuracy::Ranges;
use crate::cost::{self, Cost};
use crate::filter::height::glue::Glue;
use crate::filter::height::skewed::skewed;
use crate::filter::height::tails::tails;
use crate::filter::height::tier::texture_ranges;
use crate::filter::height::{self, HeightTier};
use crate::filter::texture::{color_type, filter, Filter};
use crate::filter::{Kernel, Tier};
use crate::module::Export;
use crate::shader::Shader;
use crate::table::{Sampling, Table};
use crate::transfer::color_map::{ColorMap, Colors};
use crate::Error;

/// Tiers from which an accuracy chooses; a tie in weight goes to the earlier.
const LADDER: [Tier; 3] = [Tier::ClosedForm(Kernel::Fast), Tier::ClosedForm(Kernel::Exact), Tier::Table];

/// Tiers of heights over C0 from which an accuracy chooses.
const HEIGHTS: [HeightTier; 1] = [HeightTier::Gaussian];

/// The shelf's loops over the knots of a map.
const LOOPS: [&str; 3] = ["texture_knots", "height_knots", "percentile_knots"];

/// Where a scene of heights asks for no accuracy and no tier keeps the default, how many times the closest one's bound
/// is near enough.
const NEAR: f32 = 1.1;

/// A tier tried for a scene.
pub(super) struct Candidate {
    /// The tier in words.
    pub label: String,
    /// The tier of heights, in a scene of heights.
    pub height: Option<HeightTier>,
    /// The export's body, tables and bound.
    pub filter: Filter,
    /// The part of the bound that the choice is free to lower.
    pub judged: f32,
    /// The exports, before the shelf is linked.
    pub glue: String,
    /// The whole text, validated.
    pub linked: Shader,
    /// That of the most expensive export.
    pub cost: Cost,
}

impl Scene {
    /// The lightest candidate within the accuracy, or the named tier; and the others that were tried.
    pub(super) fn choose(&self) -> Result<(Candidate, Vec<Candidate>), Error> {
        let mut candidates = match (&self.texture, &self.height, &self.percentile) {
            (Some(map), None, None) => self.textures(map)?,
            (None, Some(map), None) => self.heights(map)?,
            (None, None, Some(map)) => vec![self.percentiles(map)?],
            (None, None, None) => {
                let what = format!("the scene `{}` filters nothing; give it a `texture` or a `height`", self.name);
                return Err(Error::Conflict(what));
            }
            (Some(_), _, _) | (_, Some(_), Some(_)) => {
                let what = format!(
                    "the scene `{}` has a `texture` and a `height`, or two heights; make a scene of each",
                    self.name
                );
                return Err(Error::Conflict(what));
            }
        };
        if candidates.len() == 1 && (self.tier.is_some() || self.height_tier.is_some_and(HeightTier::stands_alone)) {
            return Ok((candidates.remove(0), candidates));
        }
        let asked = self.accuracy.unwrap_or_default().max_filter_error;
        let closest = candidates.iter().min_by(|a, b| a.judged.total_cmp(&b.judged));
        let near = closest.map_or(0.0, |closest| NEAR * closest.judged);
        let budget = if self.texture.is_none() && self.accuracy.is_none() { asked.max(near) } else { asked };
        let kept = candidates.iter().enumerate().filter(|(_, candidate)| candidate.judged <= budget);
        if let Some((lightest, _)) = kept.min_by_key(|(_, candidate)| candidate.cost.weight()) {
            let chosen = candidates.remove(lightest);
            return Ok((chosen, candidates));
        }
        Err(Error::Accuracy {
            scene: self.name.clone(),
            asked,
            closest: closest.map_or(String::new(), |candidate| candidate.label.clone()),
            bound: closest.map_or(f32::INFINITY, |candidate| candidate.judged),
        })
    }

    /// The tiers of C0 that the scene names or allows.
    fn tiers(&self) -> Vec<Tier> {
        let tables = self.accuracy.unwrap_or_default().tables;
        let fits = |tier: &Tier| match tier {
            Tier::ClosedForm(Kernel::Fast) => self.colors == Colors::Constant,
            Tier::Table => tables,
            _ => true,
        };
        self.tier.map_or_else(|| LADDER.into_iter().filter(fits).collect(), |tier| vec![tier])
    }

    fn textures(&self, map: &ColorMap) -> Result<Vec<Candidate>, Error> {
        let candidate = |tier: Tier| {
            let filter = filter(map, self.colors, tier, self.chosen_ranges())?;
            let mut glue = self.texture_glue(map, tier, self.chosen_ranges(), &filter);
            if let Some(driver) = self.driver {
                glue.push('\n');
                let tables = &filter.tables;
                glue += &driver.glue(&self.name, color_type(map), &parameters(tables), &arguments(tables));
            }
            self.candidate(tier.to_string(), None, filter.bound.value(), filter, glue)
        };
        self.tiers().into_iter().map(candidate).collect()
    }

    fn heights(&self, map: &ColorMap) -> Result<Vec<Candidate>, Error> {
        if self.driver.is_some() {
            return Err(Error::Conflict(
                "a driver goes with a `texture`; a `height` takes mean and deviation".to_owned(),
            ));
        }
        let alone = self.standing_alone(map).into_iter().map(|tier| self.alone(map, tier));
        let mut candidates = alone.collect::<Result<Vec<_>, _>>()?;
        if self.height_tier.is_some_and(HeightTier::stands_alone) {
            return Ok(candidates);
        }
        let named = self.height_tier.map_or(HEIGHTS.to_vec(), |tier| vec![tier]);
        let (name, surface, ranges) = (&self.name, self.microsurface, self.chosen_ranges());
        let below = texture_ranges(ranges);
        for texture_tier in self.tiers() {
            let texture = filter(map, self.colors, texture_tier, below)?;
            let own = self.texture_glue(map, texture_tier, below, &texture);
            for &tier in &named {
                let filter = height::over(&texture, map, tier, surface, ranges, name, &arguments(&texture.tables));
                let label = format!("{tier} over {texture_tier}");
                let extra = parameters(&filter.tables);
                let glue = Glue { name, map, tier, label: &label, surface, percentile: false, parameters: &extra }
                    .text(&filter);
                let glue = glue + "\n" + &own;
                let judged = if self.height_tier.is_some() { texture.bound } else { filter.bound };
                candidates.push(self.candidate(label, Some(tier), judged.value(), filter, glue)?);
            }
        }
        Ok(candidates)
    }

    /// The tiers of heights that need no C0 and that the scene names or allows.
    fn standing_alone(&self, map: &ColorMap) -> Vec<HeightTier> {
        match (self.height_tier, self.tier) {
            (Some(tier), _) if tier.stands_alone() => vec![tier],
            (Some(_), _) | (None, Some(_)) => Vec::new(),
            (None, None) => {
                let constant = self.colors == Colors::Constant && !self.microsurface.perturbed;
                let bands = (constant && height::banded(map)).then_some(HeightTier::Exact);
                let table = self.accuracy.unwrap_or_default().tables.then_some(HeightTier::Skewed);
                bands.into_iter().chain(table).chain([HeightTier::ClosedForm]).collect()
            }
        }
    }

    /// The candidate of a tier of heights that needs no C0.
    fn alone(&self, map: &ColorMap, tier: HeightTier) -> Result<Candidate, Error> {
        if let Some(named) = self.tier {
            return Err(Error::Conflict(format!("{named} does not go with {tier}: leave out the tier of values")));
        }
        let (name, surface, label) = (&self.name, self.microsurface, tier.to_string());
        let filter = match tier {
            HeightTier::Skewed => skewed(map, self.colors, surface, self.chosen_ranges()),
            HeightTier::ClosedForm => tails(map, self.colors, surface, self.chosen_ranges())?,
            _ => height::bands(map, self.colors, surface, self.chosen_ranges())?,
        };
        let parameters = parameters(&filter.tables);
        let glue =
            Glue { name, map, tier, label: &label, surface, percentile: false, parameters: &parameters }.text(&filter);
        self.candidate(label, Some(tier), filter.bound.value(), filter, glue)
    }

    pub(super) fn candidate(
        &self,
        label: String,
        height: Option<HeightTier>,
        judged: f32,
        filter: Filter,
        glue: String,
    ) -> Result<Candidate, Error> {
        let path = format!("{}.wgsl", self.name);
        let linked = prefilter_wgsl::link(&glue)
            .map_err(|collision| Error::Collision { path: path.clone(), collision })
            .and_then(|text| Shader::new(&path, text))?;
        let mut trips = BTreeMap::from(LOOPS.map(|name| (name.to_owned(), filter.trips)));
        trips.extend(self.driver.map(|driver| (format!("{}_color", self.name), driver.trips())));
        let (module, info) = linked.parsed();
        let table_bytes = filter.tables.iter().map(Table::bytes).sum();
        let calls = self.exports(&glue).into_iter().filter_map(|export| cost::call(module, info, &export.name, &trips));
        let cost = Cost { table_bytes, ..calls.max_by_key(|cost| cost.weight()).unwrap_or_default() };
        Ok(Candidate { label, height, filter, judged, glue, linked, cost })
    }

    fn texture_glue(&self, map: &ColorMap, tier: Tier, ranges: Ranges, filter: &Filter) -> String {
        let name = &self.name;
        let mut glue =
            format!("/// Mean color of `{name}` over a pixel that covers a normal distribution, by {tier}.\n///\n");
        let (low, high) = ranges.mean;
        let _ = writeln!(glue, "/// For means from {low} to {high} and deviations up to {}.", ranges.deviation);
        let color = color_type(map);
        let _ =
            writeln!(glue, "fn {name}_texture(mean: f32, deviation: f32{}) -> {color} {{", parameters(&filter.tables));
        glue + &filter.body + "}\n"
    }

    /// Every function of the glue but the C0 that heights stand on.
    pub(super) fn exports(&self, glue: &str) -> Vec<Export> {
        let export = |declaration: prefilter_wgsl::Declaration<'_>| Export {
            name: declaration.name.to_owned(),
            documentation: declaration.documentation(),
            signature: declaration.signature,
        };
        let inner = self.texture.is_none().then(|| format!("{}_texture", self.name));
        let all = prefilter_wgsl::declarations(glue).into_iter().map(export);
        all.filter(|export| Some(&export.name) != inner.as_ref()).collect()
    }
}

/// `, table: texture_2d<f32>, table_sampler: sampler` for each table, a volume with its own type.
pub(super) fn parameters(tables: &[Table]) -> String {
    let parameter = |table: &Table| match table.sampling {
        Sampling::Loaded => format!(", {}: {}", table.name, table.wgsl_type()),
        Sampling::Filtered => format!(", {0}: {1}, {0}_sampler: sampler", table.name, table.wgsl_type()),
    };
    tables.iter().map(parameter).collect()
}

/// `, table, table_sampler` for each table.
fn arguments(tables: &[Table]) -> String {
    let argument = |table: &Table| match table.sampling {
        Sampling::Loaded => format!(", {}", table.name),
        Sampling::Filtered => format!(", {0}, {0}_sampler", table.name),
    };
    tables.iter().map(argument).collect()
}
