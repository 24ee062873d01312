//! The module of a combination.

use std::collections::BTreeSet;
use std::fmt::Write;

use super::candidate::{cost, once_each, parameters, Over};
use super::combination::{Combination, Expression};
use super::layer::{listed, literal, mentions, once, shared, Layer, STATISTICS};
use super::leaves::Leaves;
use super::polynomial::largest_error;
use super::Scene;
use crate::accuracy::Bound;
use crate::driver::slope_moments::area;
use crate::filter::combine::{joint, Reflectance, GIVEN_DIRECTION, GIVEN_HEIGHTS, GIVEN_SLOPES, GIVEN_VALUES};
use crate::filter::combine::{GIVEN_REFLECTANCE, INVERSE_PI, LAMBERT};
use crate::filter::height::glue::shares;
use crate::filter::height::{surface, HeightTier};
use crate::filter::irradiance::{irradiance, IrradianceTier};
use crate::filter::shared::{statements, Shared};
use crate::filter::slope::{self, SlopeTier};
use crate::filter::steepness::Lengths;
use crate::filter::texture::{color_type, number, Filter};
use crate::module::Module;
use crate::table::Table;
use crate::Error;

/// The parts of the exports of a combination.
struct Combined<'a> {
    scene: &'a Scene,
    layers: Vec<Layer<'a>>,
    weights: Vec<String>,
    /// What names `color`.
    color: String,
    /// Whether a color has four channels.
    four: bool,
}

impl Scene {
    /// The module of a combination.
    ///
    /// # Errors
    /// A layer that cannot be one, factors that depend on the same, channels that differ, settings that it ignores, a
    /// weight whose name is taken.
    pub(super) fn combined(&self, combination: &Combination) -> Result<Module, Error> {
        let Combination(expression) = combination;
        expression.variables(self.microsurface)?;
        let Leaves { scenes, weights, four } = self.leaves(expression)?;
        let layers = self.layers(expression, scenes)?;
        self.hides(&layers)?;
        let color = expression.text(&literal, &number);
        let combined = Combined { scene: self, layers, weights, color, four };
        let mut filters = Vec::new();
        let mut glue = combined.combined()?;
        glue += &combined.shares();
        if let Some(light) = &self.irradiance {
            let tier = self.irradiance_tier.unwrap_or(IrradianceTier::FourGaussians);
            let filter = irradiance(light, self.colors, tier);
            glue += &combined.lit(tier, &filter)?;
            filters.push(filter);
        }
        if let Some(reflectance) = self.reflectance {
            glue += &combined.radiance(reflectance)?;
        }
        let drivers = self.drivers(&combined.layers)?;
        glue += &self.driven_together(
            &drivers,
            &self.exports(&glue),
            &area("m.slope", "m.slope_covariance"),
            &combined.weights,
        )?;
        let exports = self.exports(&glue);
        glue += &combined.functions(filters.first());
        let foreign = once_each(drivers.iter().map(|driven| driven.driver.foreign()));
        let linked = self.linked(&format!("{glue}{foreign}"))?;
        let mut tables: Vec<Table> = combined.layers.iter().flat_map(|layer| layer.tables.clone()).collect();
        tables.extend(filters.into_iter().flat_map(|filter| filter.tables));
        let trips = combined.layers.iter().map(|layer| layer.chosen.filter.trips).max().unwrap_or(1);
        let mut turns = self.turns(trips);
        turns.extend(self.driven_turns(&drivers));
        let cost = cost(&linked, &exports, &tables, &turns);
        let bound = combined.bound(expression);
        let explanation = self.explain_combined(&combined.layers, &drivers, bound, cost);
        Ok(Module { name: self.name.clone(), exports, glue, foreign, linked, tables, explanation, bound, turns, cost })
    }
}

impl Combined<'_> {
    fn name(&self) -> &str {
        &self.scene.name
    }

    fn color_type(&self) -> &'static str {
        color_type(3 + usize::from(self.four))
    }

    /// Whether a layer depends on slopes, so that light and color are averaged together.
    fn sloped(&self) -> bool {
        self.layers.iter().any(Layer::slopes)
    }

    /// Whether what hides the surface has a part in the combination.
    fn hidden(&self) -> bool {
        self.layers.iter().any(Layer::hidden)
    }

    fn shared(&self) -> Vec<Shared> {
        shared(&self.layers, self.scene.microsurface)
    }

    /// The statements that name `color`.
    fn statements(&self, shared: &[Shared]) -> String {
        let mut text = statements(shared);
        text.extend(self.layers.iter().map(|layer| layer.statement(shared)));
        text + &format!("    let color = {};\n", self.color)
    }

    /// A function: `more` are parameters behind the statistics, each with its type.
    ///
    /// # Errors
    /// A weight whose name the function has for something else.
    fn function(
        &self,
        name: &str,
        more: &[(&str, &str)],
        tables: &str,
        result: &str,
        body: &str,
    ) -> Result<String, Error> {
        let own: Vec<_> = self.layers.iter().flat_map(Layer::own_parameters).collect();
        let own = own.iter().map(|(name, kind)| (name.as_str(), *kind));
        let known = STATISTICS.into_iter().filter(|(name, _)| mentions(body, name));
        let mut all: Vec<_> = own.chain(known).chain(more.iter().copied()).collect();
        // The noise on the heights may be a layer, too.
        let mut named = BTreeSet::new();
        all.retain(|(name, _)| named.insert(*name));
        let of_layers: String = self.layers.iter().map(|layer| parameters(&layer.tables)).collect();
        let others = format!("{} {of_layers}{tables} {}", listed(&all), body.replace(&self.color, ""));
        for weight in &self.weights {
            if mentions(&others, weight) || !prefilter_wgsl::mentioned(weight).is_empty() {
                let what = format!("the weight `{weight}` of `{}` has a name that its module needs", self.name());
                return Err(Error::Conflict(what));
            }
            all.push((weight, "f32"));
        }
        Ok(format!("fn {}_{name}({}{of_layers}{tables}) -> {result} {{\n{body}}}\n", self.name(), listed(&all)))
    }

    fn combined(&self) -> Result<String, Error> {
        let body = self.statements(&self.shared()) + "    return color;\n";
        let heights = |layer: &Layer<'_>| matches!(layer.chosen.over, Over::Heights(_));
        let over = match (self.hidden(), self.scene.microsurface.shadowing && self.layers.iter().any(heights)) {
            (false, _) => ".",
            (true, false) => ", over what is seen.\n/// What share of it is seen or lit is not in it.",
            (true, true) => ", over what is seen and lit.\n/// What share of it is seen or lit is not in it.",
        };
        let text =
            format!("/// Mean color of `{}`: of each layer, combined{over}\n///\n{}", self.name(), self.given(&body));
        Ok(text + &self.function("combined", &[], "", self.color_type(), &body)?)
    }

    /// What is said of the statistics that a body mentions.
    fn given(&self, body: &str) -> String {
        let said = [
            (self.layers.iter().any(|layer| !layer.hidden()), GIVEN_VALUES),
            (mentions(body, "mean"), GIVEN_HEIGHTS),
            (self.hidden(), GIVEN_SLOPES),
            (mentions(body, "direction"), GIVEN_DIRECTION),
        ];
        said.into_iter().filter_map(|(needed, text)| needed.then_some(text)).collect()
    }

    /// `NAME_visibility` and `NAME_masking`.
    fn shares(&self) -> String {
        if !self.hidden() {
            return String::new();
        }
        shares(self.name(), HeightTier::Gaussian, self.scene.microsurface)
    }

    /// What averages light and colors together needs besides what the colors share.
    fn with_nodes(&self) -> Vec<Shared> {
        let nodes = if self.sloped() { slope::shared(SlopeTier::Gaussian) } else { Vec::new() };
        once(self.shared().into_iter().chain(nodes).collect())
    }

    /// The statements that name `joint`, the mean of the color times a light: its mean, and that on a node's facets.
    fn joint(&self, mean: &str, facet: &str) -> String {
        let color = if self.four { ".xyz" } else { "" };
        if !self.sloped() {
            return format!("    let joint = color{color} * {mean};\n");
        }
        let sloped = self.layers.iter().filter(|layer| layer.slopes());
        let mut node: String = sloped.map(Layer::node_statement).collect();
        let lit = if self.four { format!("({}).xyz", self.color) } else { self.color.clone() };
        let _ = write!(node, "        let c = {lit};\n        let l = {facet};\n");
        let steep = |layer: &Layer<'_>| matches!(layer.chosen.over, Over::Steepness(Lengths::One));
        joint(mean, &node, color, self.layers.iter().filter(|layer| layer.slopes()).all(steep))
    }

    fn lit(&self, tier: IrradianceTier, filter: &Filter) -> Result<String, Error> {
        let name = self.name();
        let environment: String = filter.tables.iter().map(|table| format!(", {}", table.name)).collect();
        let shared = self.with_nodes();
        let mut body = self.statements(&shared);
        body += &self.joint(
            &format!("{name}_environment(irradiance_turned({}, x, y, z){environment})", tier.means()),
            &format!("{name}_environment(irradiance_facet(node_slope, x, y, z){environment})"),
        );
        body += if self.four { "    return vec4f(joint, color.w);\n" } else { "    return joint;\n" };
        let frame = [("x", "vec3f"), ("y", "vec3f"), ("z", "vec3f")];
        let text = format!(
            "
/// Mean of the color of `{name}` times the irradiance of its environment, over what is seen. Where both depend on the
/// slopes they are averaged together. `x`, `y` and `z` are the axes of the tangent frame in the environment's space.
/// Over pi it is the radiance; what hides the environment is not in it.
"
        );
        Ok(text + &self.function("lit", &frame, &parameters(&filter.tables), self.color_type(), &body)?)
    }

    fn radiance(&self, reflectance: Reflectance) -> Result<String, Error> {
        let (name, color) = (self.name(), if self.four { ".xyz" } else { "" });
        let surface = self.scene.microsurface;
        let visible = if surface.shadowing && self.hidden() { " * visibility_shadowing(seen, lit)" } else { "" };
        let lambdas = if visible.is_empty() { Vec::new() } else { surface::shared(HeightTier::Gaussian, surface) };
        let together = |shared: Vec<Shared>| self.statements(&once(shared.into_iter().chain(lambdas).collect()));
        let mut more = vec![("radiance", "vec3f")];
        let (mut body, what) = match reflectance {
            Reflectance::Given => {
                more.push(("reflectance", "vec3f"));
                let joint = format!("    let joint = color{color} * reflectance;\n");
                (together(self.shared()) + &joint, GIVEN_REFLECTANCE)
            }
            Reflectance::Lambert => {
                let means = IrradianceTier::FourGaussians.means();
                let mean = format!("vec3f(irradiance_lambert({means}, light) * {INVERSE_PI})");
                let facet = format!("vec3f(irradiance_cosine(node_slope, light) * {INVERSE_PI})");
                (together(self.with_nodes()) + &self.joint(&mean, &facet), LAMBERT)
            }
        };
        let result = format!("radiance * joint{visible}");
        body += &if self.four {
            format!("    return vec4f({result}, color.w);\n")
        } else {
            format!("    return {result};\n")
        };
        let shares = if visible.is_empty() { "" } else { " its visibility," };
        let text = format!(
            "\n/// Radiance of `{name}` towards the view under one light: the light's own, `radiance`, \
             times{shares}\n{what}"
        );
        Ok(text + &self.function("radiance", &more, "", self.color_type(), &body)?)
    }

    /// The functions behind the exports.
    fn functions(&self, environment: Option<&Filter>) -> String {
        let shared = self.shared();
        let mut text = String::new();
        let lit = environment.is_some() || self.scene.reflectance == Some(Reflectance::Lambert);
        for layer in &self.layers {
            text += &layer.functions(&shared);
            if lit && layer.slopes() {
                text += &layer.alike();
            }
        }
        if let Some(filter) = environment {
            let (name, tables) = (self.name(), parameters(&filter.tables));
            text += &format!(
                "
/// Irradiance of the means of normals.
fn {name}_environment(m: normals_means{tables}) -> vec3f {{\n{}}}\n",
                filter.body
            );
        }
        text
    }

    fn bound(&self, expression: &Expression) -> Bound {
        let of = |scene: &Scene| {
            let layer = self.layers.iter().find(|layer| layer.scene.name == scene.name);
            layer.map_or([f64::INFINITY; 3], |layer| {
                [f64::from(layer.chosen.filter.bound.value()), layer.hull[0], layer.hull[1]]
            })
        };
        let value = largest_error(expression, &of) as f32;
        let estimated = |layer: &Layer<'_>| matches!(layer.chosen.filter.bound, Bound::Estimated(_));
        if self.layers.iter().any(estimated) {
            Bound::Estimated(value)
        } else {
            Bound::Guaranteed(value)
        }
    }
}
