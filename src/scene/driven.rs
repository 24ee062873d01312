//! The export of a combination whose statistics come from drivers.

use std::collections::BTreeSet;

use super::layer::{mentions, Layer};
use super::Scene;
use crate::driver::function::{Evaluation, Function};
use crate::driver::Driver;
use crate::module::Export;
use crate::Error;

/// Exports that drivers may call together, the more of the picture the later.
const CALLED: [&str; 8] = ["height", "slope", "slope_map", "steepness", "irradiance", "combined", "lit", "radiance"];

/// A driver of a combination.
pub(super) struct Driven<'a> {
    /// The name of the layer whose values it gives; none for heights and slopes, which all layers share.
    layer: Option<&'a str>,
    /// The driver.
    pub driver: &'a Driver,
    function: Function,
}

impl Driven<'_> {
    /// What no bound covers with it.
    pub fn gap(&self) -> &str {
        &self.function.gap
    }

    /// Whether it has several taps.
    pub(super) fn takes_several(&self) -> bool {
        self.function.taps.count() > 1
    }

    /// The name of the statistics in the body of the export.
    fn variable(&self) -> String {
        self.layer.map_or("m".to_owned(), |layer| format!("{layer}_statistics"))
    }

    /// The scene's name for the function's: its own, and that of the layer.
    fn prefix(&self, scene: &str) -> String {
        self.layer.map_or(scene.to_owned(), |layer| format!("{scene}_{layer}"))
    }

    /// What it gives for a parameter of the export that it calls.
    fn gives(&self, parameter: &str) -> Option<String> {
        let variable = self.variable();
        let statistic = match self.layer {
            Some(layer) => parameter.strip_prefix(layer)?.strip_prefix('_')?,
            None => parameter,
        };
        let moments = if self.function.surface { format!("{variable}.moments") } else { variable.clone() };
        match (statistic, self.function.surface) {
            ("mean", _) => Some(format!("{moments}.x")),
            ("deviation", _) => Some(format!("sqrt(max({moments}.y, 0.0))")),
            ("mean_slope", true) => Some(format!("{variable}.slope")),
            ("slope_covariance", true) => Some(format!("{variable}.slope_covariance")),
            _ => None,
        }
    }
}

impl Scene {
    /// The drivers of a combination and of its layers.
    ///
    /// # Errors
    /// A driver that reads images, whose statistics the caller passes; one of a layer without values of its own; one
    /// whose statistics no layer takes; drivers that do not share positions, taps and the pixel's filter.
    pub(super) fn drivers<'a>(&'a self, layers: &'a [Layer<'a>]) -> Result<Vec<Driven<'a>>, Error> {
        let own = self.driver.iter().map(|driver| (None, driver));
        let of_layers = layers.iter().filter_map(|layer| Some((Some(layer), layer.scene.driver.as_ref()?)));
        let mut all: Vec<Driven<'a>> = Vec::new();
        for (layer, driver) in own.chain(of_layers) {
            let name = layer.map_or(&self.name, |layer| &layer.scene.name);
            let refused = |what: String| Err(Error::Conflict(format!("the driver of `{name}` {what}")));
            driver.check()?;
            let Some(function) = driver.function(layer.is_none() && driver.knows_slopes()) else {
                return refused("reads an image: pass its statistics to the combination".into());
            };
            if layer.is_some_and(|layer| layer.hidden()) {
                return refused(format!("gives heights or slopes, which all layers share: give it to `{}`", self.name));
            }
            if layer.is_none() && !layers.iter().any(Layer::hidden) {
                return refused("gives heights or slopes, which no layer takes: give it to a layer of values".into());
            }
            if let Some(Driven { function: first, .. }) = all.first() {
                if (first.dimensions, first.taps, first.pixel) != (function.dimensions, function.taps, function.pixel) {
                    return refused(format!("differs in dimensions, taps or pixel from others of `{}`", self.name));
                }
            }
            all.push(Driven { layer: layer.map(|layer| layer.scene.name.as_str()), driver, function });
        }
        Ok(all)
    }

    /// The driver of a scene whose statistics are those of values and of their slopes.
    ///
    /// # Errors
    /// A driver that reads images, whose statistics the caller passes; one that does not know slopes.
    pub(super) fn driver_of_slopes(&self) -> Result<Vec<Driven<'_>>, Error> {
        let Some(driver) = &self.driver else { return Ok(Vec::new()) };
        match driver.function(true).filter(|_| driver.knows_slopes()) {
            Some(function) => Ok(vec![Driven { layer: None, driver, function }]),
            None => {
                let (name, gives) = (&self.name, driver.gives());
                let what = format!("the scene `{name}` has a `transfer`, which needs a function and its slopes");
                Err(Error::Conflict(format!("{what}; its driver gives {gives}")))
            }
        }
    }

    /// The functions of the drivers and `NAME_color`, which calls the export that shows the most.
    ///
    /// `area` is the expression of a tap's area in the picture.
    ///
    /// # Errors
    /// A driver none of whose statistics the export takes, a weight whose name it has for something else.
    pub(super) fn driven_together(
        &self,
        drivers: &[Driven<'_>],
        exports: &[Export],
        area: &str,
        weights: &[String],
    ) -> Result<String, Error> {
        let called = |name: &str| exports.iter().find(|export| export.name == format!("{}_{name}", self.name));
        let called = CALLED.into_iter().rev().find_map(called);
        let (Some(called), Some(Driven { function, .. })) = (called, drivers.first()) else {
            return Ok(String::new());
        };
        let taken = |driven: &Driven<'_>| called.parameters().iter().any(|(name, _)| driven.gives(name).is_some());
        if let Some(driven) = drivers.iter().find(|driven| !taken(driven)) {
            let gives = driven.driver.gives();
            let what = format!("the combination `{}` takes nothing of a driver that gives {gives}", self.name);
            return Err(Error::Conflict(what));
        }
        let given = |parameter: &str| drivers.iter().find_map(|driven| driven.gives(parameter));
        let argument = |(name, _): (&str, &str)| given(name).unwrap_or(name.to_owned());
        let arguments: Vec<String> = called.parameters().into_iter().map(argument).collect();
        let passed = called.parameters().into_iter().filter(|(name, _)| given(name).is_none());
        let parameters: String = passed.map(|(name, kind)| format!(", {name}: {kind}")).collect();
        let read = |driven: &Driven<'_>| {
            (driven.variable(), format!("{}_{}", driven.prefix(&self.name), driven.function.suffix()))
        };
        let reads: Vec<_> = drivers.iter().map(read).collect();
        let sees = function.surface && called.takes("mean_slope") && called.takes("view");
        let evaluation = Evaluation {
            reads: &reads,
            named: &[],
            color: &format!("{}({})", called.name, arguments.join(", ")),
            weight: sees.then(|| area.to_owned()),
            color_type: called.result(),
            dimensions: function.dimensions,
            taps: function.taps,
            pixel: function.pixel,
        };
        let unweighted = Evaluation { color: "", ..evaluation.clone() }.export(&self.name, "", "");
        if let Some(weight) = weights.iter().find(|weight| mentions(&unweighted, weight)) {
            let what = format!("the weight `{weight}` of `{}` has a name that its driven color needs", self.name);
            return Err(Error::Conflict(what));
        }
        let of = |driven: &Driven<'_>| format!("\n{}", driven.function.statistics(&driven.prefix(&self.name)));
        let functions: String = drivers.iter().map(of).collect();
        let what: BTreeSet<&str> = drivers.iter().map(|driven| driven.function.what.as_str()).collect();
        let what = what.into_iter().collect::<Vec<_>>().join(" and ");
        Ok(format!("{functions}\n{}", evaluation.export(&self.name, &what, &parameters)))
    }

    /// Turns of the loops in the functions of drivers, by their names.
    pub(super) fn driven_turns(&self, drivers: &[Driven<'_>]) -> Vec<(String, usize)> {
        let of = |driven: &Driven<'_>| {
            let Function { taps, trips, .. } = driven.function;
            let statistics = format!("{}_{}", driven.prefix(&self.name), driven.function.suffix());
            let shelf = driven.driver.shelf_trips().into_iter().map(|(name, turns)| (name.to_owned(), turns));
            let own = [(format!("{}_color", self.name), taps.count() as usize), (statistics, trips)];
            own.into_iter().chain(shelf)
        };
        drivers.iter().flat_map(of).collect()
    }
}
