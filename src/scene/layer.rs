//! A layer of a combination: the tier of its scene, as a function of what all layers share.

use super::candidate::{arguments, parameters, Candidate, Over};
use super::combination::hull;
use super::Scene;
use crate::driver::Driver;
use crate::filter::distribution::Distribution;
use crate::filter::height::{surface, HeightTier, Microsurface};
use crate::filter::shared::Shared;
use crate::filter::texture::color_type;
use crate::filter::{slope, slope_map, steepness};
use crate::table::Table;
use crate::transfer::color_map::ColorMap;
use crate::{Accuracy, Error};

/// What a combination is given of a pixel, in the order of its parameters.
pub(super) const STATISTICS: [(&str, &str); 9] = [
    ("mean", "f32"),
    ("deviation", "f32"),
    ("noise_mean", "f32"),
    ("noise_deviation", "f32"),
    ("mean_slope", "vec2f"),
    ("slope_covariance", "vec3f"),
    ("view", "vec3f"),
    ("light", "vec3f"),
    ("direction", "vec2f"),
];

/// A layer with its tier.
pub(super) struct Layer<'a> {
    /// The scene as the user gave it.
    pub scene: &'a Scene,
    /// Its tier, under the name of the combination and its own.
    pub chosen: Candidate,
    /// What it reads, under its own name.
    pub tables: Vec<Table>,
    /// The function that is called for its color.
    function: String,
    color_type: &'static str,
    /// The lowest and the highest of its channels.
    pub hull: [f64; 2],
}

/// Whether a text mentions a name, as itself and not as a member of something.
pub(super) fn mentions(text: &str, name: &str) -> bool {
    let part = |letter: char| letter.is_ascii_alphanumeric() || letter == '_';
    text.match_indices(name).any(|(at, _)| {
        let before = text[..at].chars().next_back();
        let after = text[at + name.len()..].chars().next();
        !before.is_some_and(|letter| part(letter) || letter == '.') && !after.is_some_and(part)
    })
}

impl Scene {
    /// What the mean color of a layer depends on.
    pub(super) fn variable(&self) -> String {
        if self.texture.is_some() {
            format!("value `{}`", self.name)
        } else if self.height.is_some() || self.percentile.is_some() {
            "heights".to_owned()
        } else {
            "slopes".to_owned()
        }
    }

    /// The lowest and the highest of the channels of the scene's colors, where it has a map.
    pub(super) fn hull(&self) -> Option<[f64; 2]> {
        let mapped = self.map().map(|map| hull(map.hull(), map.channels()));
        mapped.or(self.map_of_slopes().map(|map| hull(map.hull(), map.channels())))
    }

    /// A layer of this combination, which may err by `share` where it asks for no accuracy.
    ///
    /// # Errors
    /// A scene that no layer can be, or none of whose tiers is close enough.
    pub(super) fn layer<'a>(&self, scene: &'a Scene, share: f64) -> Result<Layer<'a>, Error> {
        let refused = |what: &str| Err(Error::Conflict(format!("the scene `{}` {what}", scene.name)));
        let Some(channels) = scene.channels() else {
            return refused("is no layer of a combination, which has scenes with a color map");
        };
        if scene.combination.is_some() {
            return refused("has a color map and a combination");
        }
        if scene.distribution == Distribution::Pair {
            return refused("takes values for two normal distributions, of which layers have one");
        }
        if scene.microsurface != Microsurface::default() {
            return refused("has a microsurface, which a layer takes from its combination");
        }
        if scene.transfer.is_some() || scene.transfer_tier.is_some() {
            return refused("has a transfer, which a layer takes from its combination");
        }
        let name = format!("{}_{}", self.name, scene.name);
        // A layer of its own accuracy keeps it.
        let share = |accuracy: Accuracy| Accuracy { max_filter_error: share as f32, ..accuracy };
        let accuracy = scene.accuracy.or(self.accuracy.map(share));
        // Heights alone know of a surface that hides.
        let microsurface = if scene.variable() == "heights" { self.microsurface } else { Microsurface::default() };
        let own = Scene { name: name.clone(), accuracy, microsurface, driver: None, ..scene.clone() };
        own.distribution.check()?;
        own.chosen_ranges().check()?;
        own.accuracy.map_or(Ok(()), |accuracy| accuracy.check())?;
        let (chosen, _) = own.choose()?;
        let renamed = |table: &Table| Table { name: format!("{}_{}", scene.name, table.name), ..table.clone() };
        let tables = chosen.filter.tables.iter().map(renamed).collect();
        let kind = match chosen.over {
            Over::Values => "texture",
            Over::Heights(_) => "height",
            Over::Slopes(_) => "slope",
            Over::SlopeMap(..) => "slope_map",
            Over::Steepness(_) => "steepness",
            Over::Normals(_) => "irradiance",
        };
        let function = format!("{name}_{kind}");
        let hull = scene.hull().unwrap_or_default();
        Ok(Layer { scene, chosen, tables, function, color_type: color_type(channels), hull })
    }
}

/// What the tiers of the layers share, of heights what the closest of them needs.
pub(super) fn shared(layers: &[Layer<'_>], surface: Microsurface) -> Vec<Shared> {
    let exact = layers.iter().any(|layer| matches!(layer.chosen.over, Over::Heights(HeightTier::Exact)));
    let mut all: Vec<Shared> = Vec::new();
    for layer in layers {
        let of = match layer.chosen.over {
            Over::Heights(tier) => surface::shared(if exact { HeightTier::Exact } else { tier }, surface),
            Over::Slopes(tier) => slope::shared(tier),
            Over::SlopeMap(tier, _) => slope_map::shared(tier),
            Over::Steepness(tier) => steepness::shared(tier),
            Over::Values | Over::Normals(_) => Vec::new(),
        };
        all.extend(of);
    }
    once(all)
}

/// The first of every name.
pub(super) fn once(all: Vec<Shared>) -> Vec<Shared> {
    let mut kept: Vec<Shared> = Vec::new();
    for value in all {
        if kept.iter().all(|known| known.name != value.name) {
            kept.push(value);
        }
    }
    kept
}

impl Layer<'_> {
    /// Whether the color depends on slopes.
    pub(super) fn slopes(&self) -> bool {
        !self.chosen.text.alike.is_empty()
    }

    /// Whether a rough surface hides parts of what is colored.
    pub(super) fn hidden(&self) -> bool {
        !self.values()
    }

    /// Whether the color is that of values, whose statistics are the layer's own.
    fn values(&self) -> bool {
        matches!(self.chosen.over, Over::Values)
    }

    /// The statistics of the layer's own values, as parameters.
    pub(super) fn own_parameters(&self) -> Vec<(String, &'static str)> {
        let own = |of: &str| (format!("{}_{of}", self.scene.name), "f32");
        if self.values() {
            vec![own("mean"), own("deviation")]
        } else {
            Vec::new()
        }
    }

    /// The body of the color, of statistics and shared values.
    pub(super) fn body(&self) -> &str {
        if self.values() {
            ""
        } else {
            &self.chosen.filter.body
        }
    }

    /// The functions of the layer: that of its color and what it stands on.
    pub(super) fn functions(&self, shared: &[Shared]) -> String {
        let Self { function, color_type, .. } = self;
        let beneath = &self.chosen.text.beneath;
        if self.values() {
            return format!("\n{beneath}");
        }
        let (body, tables) = (self.body(), parameters(&self.chosen.filter.tables));
        let list = listed(&given(body, shared));
        let own = format!(
            "\n/// Color of the layer `{}`, by {}.\nfn {function}({list}{tables}) -> {color_type} {{\n{body}}}\n",
            self.scene.name, self.chosen.label
        );
        if beneath.is_empty() {
            own
        } else {
            format!("{own}\n{beneath}")
        }
    }

    /// The function of the color over a normal distribution of slopes, all seen alike.
    pub(super) fn alike(&self) -> String {
        let Self { function, color_type, .. } = self;
        let (body, tables) = (&self.chosen.text.alike, parameters(&self.chosen.filter.tables));
        let list = listed(&given(body, &[]).into_iter().filter(|(name, _)| *name != "view").collect::<Vec<_>>());
        format!(
            "\n/// Color of the layer `{}` over slopes of that mean and covariance, all seen alike.
fn {function}_alike({list}{tables}) -> {color_type} {{\n{body}}}\n",
            self.scene.name
        )
    }

    /// The statement that names the layer's color, as `NAME_color`.
    pub(super) fn statement(&self, shared: &[Shared]) -> String {
        let (name, function) = (&self.scene.name, &self.function);
        let own = self.own_parameters().into_iter().map(|(name, _)| name);
        let names = given(self.body(), shared).into_iter().map(|(name, _)| name.to_owned());
        let call = |list: &str| format!("{function}({list}{})", arguments(&self.tables));
        let color = match self.scene.driver.as_ref().and_then(Driver::pattern) {
            Some(pattern) => pattern.mixed(&format!("{name}_mean"), call),
            None => call(&own.chain(names).collect::<Vec<String>>().join(", ")),
        };
        format!("    let {name}_color = {color};\n")
    }

    /// The statement that names the color of a node of the visible slopes, inside a loop.
    pub(super) fn node_statement(&self) -> String {
        let (name, function) = (&self.scene.name, &self.function);
        let given = given(&self.chosen.text.alike, &[]).into_iter().filter_map(|(name, _)| match name {
            "mean_slope" => Some("node_slope"),
            "slope_covariance" => Some("node_covariance"),
            "view" => None,
            other => Some(other),
        });
        let list: Vec<&str> = given.collect();
        format!("        let {name}_color = {function}_alike({}{});\n", list.join(", "), arguments(&self.tables))
    }
}

/// The statistics and shared values that a text mentions, with their types.
pub(super) fn given<'a>(text: &str, shared: &'a [Shared]) -> Vec<(&'a str, &'a str)> {
    let shared = shared.iter().map(|Shared { name, kind, .. }| (*name, *kind));
    STATISTICS.into_iter().chain(shared).filter(|(name, _)| mentions(text, name)).collect()
}

/// The parameters of a function.
pub(super) fn listed(parameters: &[(&str, &str)]) -> String {
    let list: Vec<String> = parameters.iter().map(|(name, kind)| format!("{name}: {kind}")).collect();
    list.join(", ")
}

/// A constant color as WGSL.
pub(super) fn literal(map: &ColorMap) -> String {
    crate::filter::texture::color(map, map.knots()[0].left)
}
