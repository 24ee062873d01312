//! The stage between driver and filter: filters of the heights h = g(f), of the statistics of f.

use super::candidate::{arguments, cost, once_each, parameters, Turns};
use super::stage::{Moments, Stage};
use super::Scene;
use crate::accuracy::{Accuracy, Bound, Ranges};
use crate::driver::transfer;
use crate::filter::height::transferred;
use crate::filter::height_transfer::{Nodes, TransferTier};
use crate::module::Module;
use crate::table::Table;
use crate::transfer::color_map::ColorMap;
use crate::transfer::height_transfer::HeightTransfer;
use crate::Error;

/// Exports of transferred heights, before those of the driver.
struct Exports {
    /// The functions to call.
    glue: String,
    /// The functions behind them.
    behind: String,
    tables: Vec<Table>,
    turns: Turns,
    bound: Bound,
    foreign: String,
    /// What is said of the filter of h.
    explanation: String,
    /// The deviation of f from which on bounds hold.
    narrow: f32,
    /// What errors of Λ move colors of heights by.
    moved: Option<f32>,
}

/// The steepest slope that a table of halves holds.
const MOST_SLOPE: f64 = 6e4;

impl Scene {
    /// Heights h = g(f): what the scene filters are the heights that a curve g makes of f, and their slopes.
    ///
    /// Every export then takes `mean` and `deviation` of f, where it has heights or not, and mean and covariance of the
    /// slopes of f; a driver is one of f and its slopes. Positions of color maps, and [`Self::ranges`], are of h, as
    /// ever. Besides them there is `NAME_transferred(mean, deviation, …)`: mean and variance of h, mean and variance of
    /// g′. Its first component is the mean height, which displaces vertices; with a driver it is that of
    /// `NAME_displacement(position, dpdx, dpdy, …)`, a vertex passing the ways to its neighbors for derivatives.
    ///
    /// Of [`Self::height`], [`Self::slope`], [`Self::slope_map`], [`Self::steepness`] and [`Self::irradiance`]; of
    /// [`Self::height_percentile`] and [`Self::combination`] by [`TransferTier::Paper`] alone.
    ///
    /// ```
    /// use prefilter::{ColorMap, HeightTier, HeightTransfer, Scene, TransferTier};
    /// let moss = ColorMap::gradient([(0.0, [0.05, 0.1, 0.02]), (1.0, [0.4, 0.5, 0.1])])?;
    /// let cushions = HeightTransfer::smoothstep(0.0, 1.2)?;
    /// let moss = Scene::new("moss").height(moss).height_tier(HeightTier::ClosedForm);
    /// let module = moss.transfer(cushions).transfer_tier(TransferTier::Paper).module()?;
    /// assert_eq!(
    ///     module.exports()[0].signature,
    ///     "fn moss_height(mean: f32, deviation: f32, slope_covariance: vec3f, view: vec3f, light: vec3f) -> vec3f"
    /// );
    /// # Ok::<(), prefilter::Error>(())
    /// ```
    #[must_use]
    pub fn transfer(self, transfer: HeightTransfer) -> Self {
        Self { transfer: Some(transfer), ..self }
    }

    /// This tier of transferred heights. Default: three nodes, or as many of two to four as the accuracy asks for;
    /// where they do not go with what is filtered, or tables are forbidden, the paper's.
    #[must_use]
    pub fn transfer_tier(self, tier: TransferTier) -> Self {
        Self { transfer_tier: Some(tier), ..self }
    }

    /// The curve, where the scene has one.
    ///
    /// # Errors
    /// A tier of transfers without one.
    pub(super) fn curve(&self) -> Result<Option<&HeightTransfer>, Error> {
        match (&self.transfer, self.transfer_tier) {
            (None, Some(tier)) => {
                let what =
                    format!("the scene `{}` has {tier}, a tier of transferred heights, and no `transfer`", self.name);
                Err(Error::Conflict(what))
            }
            (curve, _) => Ok(curve.as_ref()),
        }
    }

    /// The module of a scene of transferred heights: of the lightest tier within the accuracy.
    ///
    /// # Errors
    /// Values, which are not heights; drivers that do not know slopes; what the scene of heights is refused for; no
    /// tier that keeps the accuracy.
    pub(super) fn transferred(&self, curve: &HeightTransfer) -> Result<Module, Error> {
        let (mut lightest, mut nearest): (Option<Module>, _) = (None, (String::new(), f32::INFINITY));
        let asked = self.accuracy.map_or(f32::INFINITY, |accuracy| accuracy.max_filter_error);
        for tier in self.transfer_tiers()? {
            let (label, bound) = match self.transferred_by(curve, tier) {
                Ok(module) if module.bound.value() <= asked => {
                    if lightest.as_ref().is_none_or(|lightest| module.cost.order() < lightest.cost.order()) {
                        lightest = Some(module);
                    }
                    continue;
                }
                Ok(module) => (tier.to_string(), module.bound.value()),
                // What is left of the accuracy is too little for the filter of h.
                Err(Error::Accuracy { closest, bound, .. }) => (format!("{tier} with {closest}"), bound),
                Err(other) => return Err(other),
            };
            if bound < nearest.1 {
                nearest = (label, bound);
            }
        }
        let (closest, bound) = nearest;
        lightest.ok_or(Error::Accuracy { scene: self.name.clone(), asked, closest, bound })
    }

    /// The tiers that the scene names or allows.
    ///
    /// # Errors
    /// A tier that does not go with what is filtered.
    fn transfer_tiers(&self) -> Result<Vec<TransferTier>, Error> {
        use TransferTier as T;
        let refused = |what: String| Err(Error::Conflict(format!("the scene `{}` {what}", self.name)));
        if self.texture.is_some() {
            return refused("filters a `texture`, whose values are no heights: it goes without a `transfer`".into());
        }
        let tables = self.accuracy.unwrap_or_default().tables;
        let paper = self.combination.is_some() || self.percentile.is_some() || self.microsurface.perturbed;
        match self.transfer_tier {
            Some(tier) if tier != T::Paper && paper => {
                refused(format!("goes without {tier}, which combinations, percentiles and noise have none of"))
            }
            Some(tier) if tier != T::Paper && !tables => {
                refused(format!("has an accuracy without tables, and {tier}, which stand in one"))
            }
            Some(tier) => Ok(vec![tier]),
            None if paper || !tables => Ok(vec![T::Paper]),
            None if self.accuracy.is_none() || self.height.is_some() => Ok(vec![T::ThreeNodes]),
            None => Ok(vec![T::TwoNodes, T::ThreeNodes, T::FourNodes]),
        }
    }

    fn transferred_by(&self, curve: &HeightTransfer, tier: TransferTier) -> Result<Module, Error> {
        let stage = self.stage(curve, tier)?;
        let Exports { mut glue, behind, mut tables, mut turns, bound, foreign, explanation, narrow, moved } =
            match (&stage.nodes, &self.height) {
                (Some(nodes), Some(map)) => self.of_nodes(map, curve, &stage, nodes)?,
                _ => self.around(&stage)?,
            };
        glue += &format!("\n{}", stage.moments.text);
        tables.extend(stage.moments.tables.iter().cloned());
        tables.extend(stage.nodes.iter().map(|nodes| nodes.table.clone()));
        let drivers = self.driver_of_slopes()?;
        if let Some(driven) = drivers.first() {
            let exports = self.exports(&glue);
            if driven.takes_several() && exports.iter().any(|export| export.takes("mean_slope")) {
                glue += &stage.area();
            }
            glue += &self.driven_together(&drivers, &exports, &stage.area_of_tap(), &self.weights()?)?;
            glue += &stage.displacement(driven.driver);
            turns.extend(self.driven_turns(&drivers));
        }
        let exports = self.exports(&glue);
        glue += &behind;
        let foreign = once_each([foreign.as_str(), &self.foreign()].into_iter());
        let linked = self.linked(&format!("{glue}{foreign}"))?;
        let cost = cost(&linked, &exports, &tables, &turns);
        let explanation =
            self.explain_transferred(&stage, (narrow, moved), [&bound.to_string(), &cost.to_string()], &explanation);
        Ok(Module { name: self.name.clone(), exports, glue, foreign, linked, tables, explanation, bound, turns, cost })
    }

    fn stage(&self, curve: &HeightTransfer, tier: TransferTier) -> Result<Stage, Error> {
        let refused = |what: &str| Err(Error::Conflict(format!("the curve of `{}` {what}", self.name)));
        let ranges = Ranges::of_transfer(curve);
        ranges.check()?;
        let (text, tables) = transfer::stage(&self.name, curve);
        if !tables.is_empty() && !self.accuracy.unwrap_or_default().tables {
            return refused("is a power that needs a table, and its accuracy has none");
        }
        let far = 8.0 * f64::from(ranges.deviation);
        let (least, most) = curve.slopes(f64::from(ranges.mean.0) - far, f64::from(ranges.mean.1) + far);
        if tier != TransferTier::Paper && most.max(-least) > MOST_SLOPE {
            return refused(
                "has slopes beyond 6e4, the largest that its table of nodes holds: take `TransferTier::Paper`",
            );
        }
        let tilted = self.height.is_none() || self.microsurface.mean_slope;
        let nodes = (tier != TransferTier::Paper).then(|| Nodes::new(curve, ranges, tier, tilted));
        Ok(Stage { name: self.name.clone(), tier, ranges, moments: Moments { text, tables }, nodes })
    }

    /// A setting that has no meaning for colors by transferred heights, which stand in a table of their own.
    ///
    /// # Errors
    /// As [`Self::filtered`], or a tier, or ranges.
    fn check_heights(&self) -> Result<(), Error> {
        let alone = Self { driver: None, ..self.clone() };
        alone.filtered()?;
        let tier = self.tier.map(|tier| format!("a color map's tier, {tier}"));
        let height_tier = self.height_tier.map(|tier| format!("a tier of heights, {tier}"));
        let ranges = self.ranges.map(|_| "`ranges`: those of f are the transfer's".to_owned());
        match tier.or(height_tier).or(ranges) {
            None => Ok(()),
            Some(setting) => {
                let what = format!(
                    "the scene `{}` colors by transferred heights, from a table, and goes without {setting}",
                    self.name
                );
                Err(Error::Conflict(what))
            }
        }
    }

    /// Colors by height, from a table that knows the curve.
    ///
    /// # Errors
    /// Settings that it would ignore; what the closed form of heights is refused for.
    fn of_nodes(&self, map: &ColorMap, curve: &HeightTransfer, stage: &Stage, nodes: &Nodes) -> Result<Exports, Error> {
        self.check_heights()?;
        let (name, surface) = (&self.name, self.microsurface);
        let heights = format!("{name}_narrow(mean, deviation{})", arguments(&stage.moments.tables));
        let found = transferred::transferred(name, map, self.colors, curve, surface, nodes, &heights)?;
        let own = parameters(std::slice::from_ref(&nodes.table));
        let all = parameters(&found.filter.tables) + &parameters(&stage.moments.tables) + &own;
        let hiding = if surface.mean_slope { String::new() } else { nodes.lambda(name) };
        Ok(Exports {
            glue: transferred::glue(name, map, surface, nodes, &found.filter.body, [&all, &own]),
            behind: transfer::narrow(name, curve) + &found.level + &hiding,
            tables: found.filter.tables,
            turns: self.turns(found.filter.trips),
            bound: found.filter.bound,
            foreign: String::new(),
            explanation: String::new(),
            narrow: found.narrow,
            moved: Some(found.moved),
        })
    }

    /// The scene with what something that errs by `part` leaves of its accuracy.
    ///
    /// # Errors
    /// Nothing is left.
    fn within(self, part: f32) -> Result<Self, Error> {
        let Some(accuracy) = self.accuracy else { return Ok(self) };
        let left = accuracy.max_filter_error - part;
        if left > 0.0 {
            let accuracy = Some(Accuracy { max_filter_error: left, ..accuracy });
            return Ok(Self { accuracy, ..self });
        }
        let closest = "the nodes' table alone".to_owned();
        Err(Error::Accuracy { scene: self.name, asked: accuracy.max_filter_error, closest, bound: part })
    }

    /// Around each export of the scene of heights one that takes the statistics of f.
    ///
    /// # Errors
    /// What that scene is refused for; layers with drivers.
    fn around(&self, stage: &Stage) -> Result<Exports, Error> {
        let name = format!("{}_heights", self.name);
        let heights = Self { name, transfer: None, transfer_tier: None, driver: None, ..self.clone() };
        let nodes = stage.nodes.as_ref().map_or(0.0, |nodes| nodes.table.part() * self.varied());
        let heights = heights.within(nodes)?.generated().map_err(|error| match error {
            Error::Accuracy { scene, asked, closest, bound } => {
                Error::Accuracy { scene, asked: asked + nodes, closest, bound: bound + nodes }
            }
            other => other,
        })?;
        if heights.exports.iter().any(|export| export.name == format!("{}_color", heights.name)) {
            let what =
                format!("the layers of `{}` have drivers, and it a `transfer`: pass their statistics", self.name);
            return Err(Error::Conflict(what));
        }
        let around: Vec<String> = heights.exports.iter().map(|export| stage.around(export, heights.name())).collect();
        let mut turns = heights.turns;
        let looping = heights.exports.iter().map(|export| (stage.outer(export, &heights.name), stage.tier.nodes()));
        turns.extend(looping);
        let takes = |name: &str| heights.exports.iter().any(|export| export.takes(name));
        if !takes("mean") && !takes("slope_covariance") {
            let what = format!("the combination `{}` has neither heights nor slopes, and a `transfer`", self.name);
            return Err(Error::Conflict(what));
        }
        let bound = match (heights.bound, &stage.nodes) {
            (bound, None) => bound,
            (bound, Some(_)) => Bound::Estimated(bound.value() + nodes),
        };
        let narrow = stage.nodes.as_ref().map_or(0.0, Nodes::narrow);
        Ok(Exports {
            glue: around.join("\n"),
            behind: format!("\n{}", heights.glue),
            tables: heights.tables,
            turns,
            bound,
            foreign: heights.foreign,
            explanation: heights.explanation,
            narrow,
            moved: None,
        })
    }
}
