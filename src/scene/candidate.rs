//! The tiers that a scene tries, and which one it takes.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;

use super::filtered::Filtered;
use super::Scene;
use crate::accuracy::Ranges;
use crate::cost::{self, Cost};
use crate::driver::Called;
use crate::filter::combine;
use crate::filter::height::HeightTier;
use crate::filter::irradiance::IrradianceTier;
use crate::filter::slope::SlopeTier;
use crate::filter::slope_map::SlopeTaps;
use crate::filter::texture::{color_type, Filter};
use crate::filter::{steepness::Lengths, Kernel, Tier};
use crate::module::Export;
use crate::shader::Shader;
use crate::table::{Sampling, Table};
use crate::transfer::color_map::{ColorMap, Colors};
use crate::Error;

/// Tiers from which an accuracy chooses; a tie in weight goes to the fewer bytes of tables, then to the earlier.
const LADDER: [Tier; 4] = [Tier::Naive, Tier::ClosedForm(Kernel::Fast), Tier::ClosedForm(Kernel::Exact), Tier::Table];

/// The shelf's loops over the knots of a map.
const LOOPS: [&str; 3] = ["texture_knots", "height_knots", "percentile_knots"];

/// Exports with a loop over the nodes of the visible slopes.
const NODES: [&str; 2] = ["lit", "radiance"];

/// The shelf's loop over the two sides of a mean slope.
const SIDES: [&str; 1] = ["rice_five"];

/// The shelf's loops over the waves and the corners of patterns, footprints narrower than 0.03 periods take more waves,
/// and over the edges of a cell in space.
const FIXED: [(&str, usize); 5] = [
    ("crossing_waves", 16),
    ("crossing_corners", 4),
    ("pulse_waves", 4),
    ("perlin_solid_noise", 4),
    ("value_solid_noise", 4),
];

/// Where a scene of heights or of one table asks for no accuracy and no tier keeps the default, how many times the
/// closest one's bound is near enough.
const NEAR: f32 = 1.1;

/// What a color is averaged over, and how that is represented.
#[derive(Clone, Copy)]
pub(super) enum Over {
    /// Values of a normal distribution, C0's own.
    Values,
    /// Heights that are seen and lit.
    Heights(HeightTier),
    /// Slopes that are seen.
    Slopes(SlopeTier),
    /// Slopes that are seen, from a table.
    SlopeMap(SlopeTier, SlopeTaps),
    /// Lengths of slopes that are seen.
    Steepness(Lengths),
    /// Normals that are seen.
    Normals(IrradianceTier),
}

/// A tier tried for a scene.
pub(super) struct Candidate {
    /// The tier in words.
    pub label: String,
    /// What is averaged over.
    pub over: Over,
    /// The export's body, tables and bound.
    pub filter: Filter,
    /// The part of the bound that the choice is free to lower.
    pub judged: f32,
    /// The exports, before the shelf is linked.
    pub text: Text,
    /// The whole text, validated.
    pub linked: Shader,
    /// Turns of the loops in the text, by the names of their functions.
    pub turns: Turns,
    /// That of the most expensive export.
    pub cost: Cost,
}

impl Candidate {
    /// Whether all of its tables have their texels.
    pub(super) fn is_baked(&self) -> bool {
        self.filter.tables.iter().all(Table::is_baked)
    }
}

/// How often a loop turns, by the name of the function that it is in.
pub(crate) type Turns = BTreeMap<String, usize>;

/// The functions of a tier.
#[derive(Default)]
pub(super) struct Text {
    /// The exports and what they call that is not of the shelf.
    pub glue: String,
    /// Of these what the filter's body calls, C0 where it stands on that; of a scene of values C0 itself.
    pub beneath: String,
    /// The body of the mean color over a normal distribution of slopes of `mean_slope` and `slope_covariance`, all of
    /// them seen alike, where the scene colors by slopes.
    pub alike: String,
}

impl Scene {
    /// The lightest candidate within the accuracy, or the named tier; and the others that were tried.
    pub(super) fn choose(&self) -> Result<(Candidate, Vec<Candidate>), Error> {
        let mut candidates = match self.filtered()? {
            Filtered::Texture(map) => self.textures(map)?,
            Filtered::Height(map) => self.heights(map)?,
            Filtered::HeightPercentile(map) => vec![self.percentiles(map)?],
            Filtered::Slope(map) => self.slopes(map)?,
            Filtered::SlopeMap(map) => self.slope_maps(map)?,
            Filtered::Steepness(map) => self.steepnesses(map)?,
            Filtered::Irradiance(light) => self.irradiances(light)?,
        };
        if candidates.len() == 1 && self.names_the_only_one() {
            return Ok((candidates.remove(0), candidates));
        }
        let asked = self.accuracy.unwrap_or_default().max_filter_error;
        if let Some(lightest) = self.lightest(&candidates) {
            let chosen = candidates.remove(lightest);
            return Ok((chosen, candidates));
        }
        let baked = candidates.iter().filter(|candidate| candidate.is_baked());
        let closest = baked.min_by(|a, b| a.judged.total_cmp(&b.judged));
        Err(Error::Accuracy {
            scene: self.name.clone(),
            asked,
            closest: closest.map_or(String::new(), |candidate| candidate.label.clone()),
            bound: closest.map_or(f32::INFINITY, |candidate| candidate.judged),
        })
    }

    /// The place of the lightest one whose bound is small enough: not of a table that was not baked, of which less is
    /// known than its bound.
    pub(super) fn lightest(&self, candidates: &[Candidate]) -> Option<usize> {
        let budget = self.budget(candidates);
        let keeps = |candidate: &Candidate| candidate.judged <= budget && candidate.is_baked();
        let kept = candidates.iter().enumerate().filter(|(_, candidate)| keeps(candidate));
        kept.min_by_key(|(_, candidate)| candidate.cost.order()).map(|(place, _)| place)
    }

    /// The largest bound that a candidate beside some others may have to be chosen.
    pub(super) fn budget(&self, others: &[Candidate]) -> f32 {
        let asked = self.accuracy.unwrap_or_default().max_filter_error;
        let choosy = self.accuracy.is_some() || (self.texture.is_some() && !self.distribution.tabulated());
        let near = others.iter().map(|candidate| NEAR * candidate.judged).reduce(f32::min);
        near.filter(|_| !choosy).map_or(asked, |near| asked.max(near))
    }

    /// Whether a scene with a single candidate names it, so that no accuracy has a say.
    fn names_the_only_one(&self) -> bool {
        let height = self.height_tier.is_some_and(HeightTier::stands_alone);
        let naive = self.slope_tier == Some(SlopeTier::Naive);
        let slope_map = self.slope_tier.is_some() && self.slope_taps.is_some();
        self.tier.is_some() || height || naive || slope_map || self.irradiance_tier.is_some()
    }

    /// The tiers of C0 that the scene names or allows.
    pub(super) fn tiers(&self) -> Vec<Tier> {
        let tables = self.accuracy.unwrap_or_default().tables;
        let fits = |tier: &Tier| match tier {
            // Whoever asks for no accuracy asks for filtering.
            Tier::Naive => self.colors == Colors::Constant && self.accuracy.is_some(),
            Tier::ClosedForm(Kernel::Fast) => self.colors == Colors::Constant,
            Tier::Table => tables,
            _ => true,
        };
        if self.distribution.tabulated() {
            return vec![Tier::Table];
        }
        self.tier.map_or_else(|| LADDER.into_iter().filter(fits).collect(), |tier| vec![tier])
    }

    pub(super) fn candidate(
        &self,
        label: String,
        over: Over,
        judged: f32,
        filter: Filter,
        text: Text,
    ) -> Result<Candidate, Error> {
        let linked = self.linked(&format!("{}{}", text.glue, self.foreign()))?;
        let mut turns = self.turns(filter.trips);
        if let Some(driver) = &self.driver {
            turns.extend(
                driver.trips().into_iter().map(|(function, turns)| (format!("{}_{function}", self.name), turns)),
            );
            turns.extend(driver.shelf_trips().into_iter().map(|(function, turns)| (function.to_owned(), turns)));
        }
        let cost = cost(&linked, &self.exports(&text.glue), &filter.tables, &turns);
        Ok(Candidate { label, over, filter, judged, text, linked, turns, cost })
    }

    /// The whole text, validated.
    pub(super) fn linked(&self, glue: &str) -> Result<Shader, Error> {
        let path = format!("{}.wgsl", self.name);
        prefilter_wgsl::link(glue)
            .map_err(|collision| Error::Collision { path: path.clone(), collision })
            .and_then(|text| Shader::new(&path, text))
    }

    /// What stands behind the glue that is not of the shelf: the text of a driver.
    pub(super) fn foreign(&self) -> String {
        once_each(self.driver.iter().map(|driver| driver.foreign()))
    }

    /// Turns of the loops in a filter of this scene; `trips` are those over the knots of its maps.
    pub(super) fn turns(&self, trips: usize) -> Turns {
        let knots = LOOPS.map(|name| (name.to_owned(), trips));
        let fixed = SIDES.map(|name| (name, 2)).into_iter().chain(FIXED);
        let fixed = fixed.map(|(name, turns)| (name.to_owned(), turns));
        let nodes = NODES.map(|export| (format!("{}_{export}", self.name), combine::NODES));
        knots.into_iter().chain(fixed).chain(nodes).collect()
    }

    /// The export of the driver, where there is one, which calls `NAME_FUNCTION`; `given` are the parameters of that
    /// between the driver's statistics and the tables, each with a comma in front.
    pub(super) fn driven(&self, function: &str, color_type: &str, given: &str, tables: &[Table]) -> String {
        let Some(driver) = &self.driver else { return String::new() };
        let called = Called {
            name: &self.name,
            function,
            color_type,
            given,
            parameters: &parameters(tables),
            arguments: &arguments(tables),
            edges: &self.map().and_then(ColorMap::edges).unwrap_or_default(),
        };
        format!("\n{}", driver.glue(&called))
    }

    pub(super) fn texture_glue(&self, map: &ColorMap, tier: Tier, ranges: Ranges, filter: &Filter) -> String {
        let (name, covered) = (&self.name, self.distribution.single());
        let by = if self.distribution.tabulated() { "its table".to_owned() } else { tier.to_string() };
        let mut glue = format!("/// Mean color of `{name}` over a pixel that covers {covered}, by {by}.\n///\n");
        let (low, high) = ranges.mean;
        let _ = writeln!(glue, "/// For means from {low} to {high} and deviations up to {}.", ranges.deviation);
        let color = color_type(map.channels());
        let _ =
            writeln!(glue, "fn {name}_texture(mean: f32, deviation: f32{}) -> {color} {{", parameters(&filter.tables));
        glue + &filter.body + "}\n"
    }

    /// Every function of the glue but the C0 that heights stand on, and what returns a structure.
    pub(super) fn exports(&self, glue: &str) -> Vec<Export> {
        let export = |declaration: prefilter_wgsl::Declaration<'_>| Export {
            name: declaration.name.to_owned(),
            documentation: declaration.documentation(),
            signature: declaration.signature,
        };
        let inner = self.texture.is_none().then(|| format!("{}_texture", self.name));
        let all = prefilter_wgsl::declarations(glue).into_iter().map(export);
        all.filter(|export| Some(&export.name) != inner.as_ref() && export.result() != "statistics_surface").collect()
    }
}

/// The cost of the most expensive export.
pub(super) fn cost(linked: &Shader, exports: &[Export], tables: &[Table], turns: &Turns) -> Cost {
    let (module, info) = linked.parsed();
    let table_bytes = tables.iter().map(Table::bytes).sum();
    let calls = exports.iter().filter_map(|export| cost::call(module, info, &export.name, turns));
    Cost { table_bytes, ..calls.max_by_key(|cost| cost.weight()).unwrap_or_default() }
}

/// Texts behind a glue, equal ones once.
pub(super) fn once_each<'a>(texts: impl Iterator<Item = &'a str>) -> String {
    let all: BTreeSet<&str> = texts.map(str::trim).filter(|text| !text.is_empty()).collect();
    all.into_iter().map(|text| format!("\n{text}\n")).collect()
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
pub(super) fn arguments(tables: &[Table]) -> String {
    let argument = |table: &Table| match table.sampling {
        Sampling::Loaded => format!(", {}", table.name),
        Sampling::Filtered => format!(", {0}, {0}_sampler", table.name),
    };
    tables.iter().map(argument).collect()
}
