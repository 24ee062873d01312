//! From a description to a module: the only file that knows drivers, transfer functions and filters together.

use std::collections::BTreeMap;
use std::fmt::Write;

use crate::accuracy::{Accuracy, Bound, Ranges};
use crate::cost::{self, Cost};
use crate::driver::Driver;
use crate::filter::texture::{color_type, filter, Filter};
use crate::filter::{Kernel, Tier};
use crate::module::{Export, Module};
use crate::shader::Shader;
use crate::table::{Sampling, Table};
use crate::transfer::color_map::{ColorMap, Colors};
use crate::{name, Error};

/// What a material needs: what is filtered, over which values, and how closely.
///
/// ```
/// use prefilter::{Accuracy, ColorMap, Scene};
/// let map = ColorMap::gradient([(0.0, [0.0, 0.1, 0.2]), (1.0, [1.0, 0.9, 0.8])])?;
/// let module = Scene::new("fog").texture(map).accuracy(Accuracy::max_filter_error(1e-4)).module()?;
/// assert_eq!(module.exports()[0].signature, "fn fog_texture(mean: f32, deviation: f32) -> vec3f");
/// # Ok::<(), prefilter::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Scene {
    name: String,
    texture: Option<ColorMap>,
    colors: Colors,
    tier: Option<Tier>,
    accuracy: Accuracy,
    ranges: Option<Ranges>,
    driver: Option<Driver>,
}

/// Tiers from which an accuracy chooses; a tie in weight goes to the earlier.
const LADDER: [Tier; 3] = [Tier::ClosedForm(Kernel::Fast), Tier::ClosedForm(Kernel::Exact), Tier::Table];

/// A tier tried for a scene.
struct Candidate {
    tier: Tier,
    filter: Filter,
    glue: String,
    linked: Shader,
    cost: Cost,
}

impl Scene {
    /// A scene whose exports' names begin with `name`: an identifier that no shading language reserves.
    pub fn new(name: &str) -> Self {
        Self {
            name: name.to_owned(),
            texture: None,
            colors: Colors::default(),
            tier: None,
            accuracy: Accuracy::default(),
            ranges: None,
            driver: None,
        }
    }

    /// C0: color by a value of which a pixel covers a normal distribution. Exports `NAME_texture(mean, deviation)`.
    #[must_use]
    pub fn texture(self, map: ColorMap) -> Self {
        Self { texture: Some(map), ..self }
    }

    /// Where the module finds the colors. Default: in the text.
    #[must_use]
    pub fn colors(self, colors: Colors) -> Self {
        Self { colors, ..self }
    }

    /// This tier instead of the cheapest that keeps the accuracy.
    #[must_use]
    pub fn tier(self, tier: Tier) -> Self {
        Self { tier: Some(tier), ..self }
    }

    /// The largest filter error; the cheapest tier whose bound keeps it is chosen. Default: 1/255.
    #[must_use]
    pub fn accuracy(self, accuracy: Accuracy) -> Self {
        Self { accuracy, ..self }
    }

    /// The values over which bounds hold and tables reach; larger deviations count as the largest. Default:
    /// [`Ranges::of`] the map, which for a map over [0, 1] is [`Ranges::default`].
    #[must_use]
    pub fn ranges(self, ranges: Ranges) -> Self {
        Self { ranges: Some(ranges), ..self }
    }

    /// Where mean and deviation come from. Exports `NAME_color(position, dpdx, dpdy, …)` besides `NAME_texture`.
    ///
    /// ```
    /// use prefilter::{ColorMap, Driver, Moments, Scene, Taps};
    /// let map = ColorMap::gradient([(0.0, [0.0, 0.1, 0.2]), (1.0, [1.0, 0.9, 0.8])])?;
    /// let taps = Moments { taps: Taps::Eight, ..Moments::default() };
    /// let module = Scene::new("rock").texture(map).driver(Driver::Moments(taps)).module()?;
    /// assert_eq!(module.exports()[1].name, "rock_color");
    /// # Ok::<(), prefilter::Error>(())
    /// ```
    #[must_use]
    pub fn driver(self, driver: Driver) -> Self {
        Self { driver: Some(driver), ..self }
    }

    /// The color map, where the scene has one.
    pub fn map(&self) -> Option<&ColorMap> {
        self.texture.as_ref()
    }

    /// The ranges that bounds hold over: those given, or else those of the map.
    pub fn chosen_ranges(&self) -> Ranges {
        self.ranges.unwrap_or_else(|| self.texture.as_ref().map_or(Ranges::default(), Ranges::of))
    }

    /// Generates, links and validates the module.
    ///
    /// In a release build closed forms of some dozen knots take well below 5 ms; beyond some hundred constant knots
    /// naga's time grows with their square. Tables, which are tried unless the scene names a tier or the accuracy
    /// forbids them, take a fraction of a second to bake, seconds with a thousand knots.
    ///
    /// # Errors
    /// A name that cannot be used, a scene without a map, ranges or an accuracy outside their limits, a tier that does
    /// not go with the colors, or no tier that keeps the accuracy.
    pub fn module(&self) -> Result<Module, Error> {
        name::check(&self.name)?;
        self.chosen_ranges().check()?;
        self.accuracy.check()?;
        self.driver.map_or(Ok(()), |driver| driver.check())?;
        let Some(map) = &self.texture else {
            return Err(Error::Conflict(format!("the scene `{}` filters nothing; give it a `texture`", self.name)));
        };
        let (chosen, passed) = self.choose(map)?;
        let explanation = self.explain(&chosen, &passed);
        Ok(Module {
            name: self.name.clone(),
            exports: exports(&chosen.glue),
            glue: chosen.glue,
            linked: chosen.linked,
            tables: chosen.filter.tables,
            explanation,
            bound: chosen.filter.bound,
            cost: chosen.cost,
        })
    }

    /// The lightest candidate within the accuracy, or the named tier; and the others that were tried.
    fn choose(&self, map: &ColorMap) -> Result<(Candidate, Vec<Candidate>), Error> {
        if let Some(tier) = self.tier {
            return Ok((self.candidate(map, tier)?, Vec::new()));
        }
        let fits = |tier: &Tier| match tier {
            Tier::ClosedForm(Kernel::Fast) => self.colors == Colors::Constant,
            Tier::Table => self.accuracy.tables,
            _ => true,
        };
        let mut candidates =
            LADDER.into_iter().filter(fits).map(|tier| self.candidate(map, tier)).collect::<Result<Vec<_>, _>>()?;
        let budget = self.accuracy.max_filter_error;
        let kept = candidates.iter().enumerate().filter(|(_, candidate)| candidate.filter.bound.value() <= budget);
        if let Some((lightest, _)) = kept.min_by_key(|(_, candidate)| candidate.cost.weight()) {
            let chosen = candidates.remove(lightest);
            return Ok((chosen, candidates));
        }
        let closest = candidates.iter().min_by(|a, b| a.filter.bound.value().total_cmp(&b.filter.bound.value()));
        Err(Error::Accuracy {
            scene: self.name.clone(),
            asked: budget,
            closest: closest.map_or(String::new(), |candidate| candidate.tier.to_string()),
            bound: closest.map_or(f32::INFINITY, |candidate| candidate.filter.bound.value()),
        })
    }

    fn candidate(&self, map: &ColorMap, tier: Tier) -> Result<Candidate, Error> {
        let filter = filter(map, self.colors, tier, self.chosen_ranges())?;
        let glue = self.glue(map, tier, &filter);
        let path = format!("{}.wgsl", self.name);
        let linked = prefilter_wgsl::link(&glue)
            .map_err(|collision| Error::Collision { path: path.clone(), collision })
            .and_then(|text| Shader::new(&path, text))?;
        let mut trips = BTreeMap::from([("texture_knots".to_owned(), filter.trips)]);
        trips.extend(self.driver.map(|driver| (format!("{}_color", self.name), driver.trips())));
        let (module, info) = linked.parsed();
        let table_bytes = filter.tables.iter().map(Table::bytes).sum();
        let calls = exports(&glue).into_iter().map(|export| cost::call(module, info, &export.name, &trips));
        let cost = Cost { table_bytes, ..calls.max_by_key(|cost| cost.weight()).unwrap_or_default() };
        Ok(Candidate { tier, filter, glue, linked, cost })
    }

    fn glue(&self, map: &ColorMap, tier: Tier, filter: &Filter) -> String {
        let (name, ranges) = (&self.name, self.chosen_ranges());
        let mut glue =
            format!("/// Mean color of `{name}` over a pixel that covers a normal distribution, by {tier}.\n///\n");
        let (low, high) = ranges.mean;
        let _ = writeln!(glue, "/// For means from {low} to {high} and deviations up to {}.", ranges.deviation);
        let color = color_type(map);
        let _ =
            writeln!(glue, "fn {name}_texture(mean: f32, deviation: f32{}) -> {color} {{", parameters(&filter.tables));
        glue = glue + &filter.body + "}\n";
        if let Some(driver) = self.driver {
            glue.push('\n');
            glue += &driver.glue(name, color, &parameters(&filter.tables), &arguments(&filter.tables));
        }
        glue
    }

    fn explain(&self, chosen: &Candidate, passed: &[Candidate]) -> String {
        let Ranges { mean: (low, high), deviation } = self.chosen_ranges();
        let mut text = format!("{}: texture (C0) by {}\n", self.name, chosen.tier);
        let _ = writeln!(text, "  error   {}", described(&chosen.filter));
        let _ = writeln!(text, "  cost    {} a call", chosen.cost);
        let _ = writeln!(text, "  ranges  means {low} to {high}, deviations to {deviation}");
        let why = match self.tier {
            Some(_) => "the scene names this tier".to_owned(),
            None => format!("the lightest within {:.1e}", self.accuracy.max_filter_error),
        };
        let _ = writeln!(text, "  chosen  {why}");
        for other in passed {
            let _ = writeln!(text, "  passed  {}: error {}; {}", other.tier, described(&other.filter), other.cost);
        }
        let gap = self.driver.map_or(UNDRIVEN.to_owned(), |driver| driver.gap());
        let _ = writeln!(text, "  not in the error: {gap}");
        text
    }
}

/// What the bound of a filter without a driver does not cover.
const UNDRIVEN: &str = "how far a pixel's values are from a normal distribution of that mean and deviation";

fn described(filter: &Filter) -> String {
    match (filter.bound, filter.tables.first()) {
        (Bound::Estimated(bound), Some(table)) => {
            format!("{bound:.1e}, estimated: twice the {:.1e} measured between texels", table.error)
        }
        (bound, _) => format!("{:.1e}, guaranteed by the shelf's contracts", bound.value()),
    }
}

/// `, table: texture_2d<f32>, table_sampler: sampler` for each table.
fn parameters(tables: &[Table]) -> String {
    let parameter = |table: &Table| match table.sampling {
        Sampling::Loaded => format!(", {}: texture_2d<f32>", table.name),
        Sampling::Filtered => format!(", {0}: texture_2d<f32>, {0}_sampler: sampler", table.name),
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

/// Every function of the glue.
fn exports(glue: &str) -> Vec<Export> {
    let export = |declaration: prefilter_wgsl::Declaration<'_>| Export {
        name: declaration.name.to_owned(),
        documentation: declaration.documentation(),
        signature: declaration.signature,
    };
    prefilter_wgsl::declarations(glue).into_iter().map(export).collect()
}
