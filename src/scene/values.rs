//! The tiers of values that a scene tries, and what their distribution is.

use super::candidate::{arguments, parameters, Candidate, Over, Text};
use super::sizes::of_texels;
use super::Scene;
use crate::filter::distribution::Distribution;
use crate::filter::texture::{color_type, number, NODES};
use crate::filter::Tier;
use crate::table::Table;
use crate::transfer::color_map::ColorMap;
use crate::Error;

impl Scene {
    /// What distribution the values of a [`Self::texture`] are taken for. Default: the normal one.
    ///
    /// ```
    /// use prefilter::{ColorMap, Distribution, Scene};
    /// let veins = ColorMap::gradient([(-1.0, [0.1, 0.1, 0.15]), (1.0, [0.9, 0.9, 0.85])])?;
    /// let marble = Scene::new("marble").texture(veins).distribution(Distribution::Beta { low: -1.0, high: 1.0 });
    /// let module = marble.module()?;
    /// assert_eq!(module.tables().len(), 1);
    /// assert!(module.explain().contains("a Beta distribution between -1 and 1"));
    /// # Ok::<(), prefilter::Error>(())
    /// ```
    #[must_use]
    pub fn distribution(self, distribution: Distribution) -> Self {
        Self { distribution, ..self }
    }

    pub(super) fn textures(&self, map: &ColorMap) -> Result<Vec<Candidate>, Error> {
        let tabulated = self.distribution.tabulated();
        let candidate = |tier: Tier, nodes: [usize; 2], worth: f32| {
            let filter = self.distribution.filter(map, self.colors, tier, nodes, self.chosen_ranges(), worth)?;
            let beneath = self.texture_glue(map, tier, self.chosen_ranges(), &filter);
            let color = color_type(map.channels());
            let paired = self.distribution == Distribution::Pair;
            let pair = if paired { self.pair_glue(color, &filter.tables) } else { String::new() };
            let called = if paired { "pair" } else { "texture" };
            let glue = beneath.clone() + &pair + &self.driven(called, color, "", &filter.tables);
            let text = Text { glue, beneath, ..Text::default() };
            let label = if tabulated { format!("a table of {}", self.distribution) } else { tier.to_string() };
            let label = label + &of_texels(nodes, NODES);
            Ok(vec![self.candidate(label, Over::Values, filter.bound.value(), filter, text)?])
        };
        // Closely before and behind an edge among the means narrow values have the two colors of the edge, and a read
        // of a table, however many columns it has, hardly differs: it errs by half of the jump or more on one side. Its
        // bound is twice its error: with an accuracy below the jump no table is tried, as none could be chosen.
        let (low, high) = self.chosen_ranges().mean;
        let edges = map.knots().iter().filter(|knot| (low..=high).contains(&knot.position));
        let jumps = edges.flat_map(|knot| (0..4).map(|channel| (knot.right[channel] - knot.left[channel]).abs()));
        let jump = jumps.fold(0.0, f32::max);
        let far = !tabulated && self.accuracy.is_some_and(|accuracy| jump > accuracy.max_filter_error);
        let tiers = self.tiers().into_iter().filter(|tier| *tier != Tier::Table || self.tier.is_some() || !far);
        let mut candidates = Vec::new();
        self.by_tiers(&mut candidates, tiers.collect(), candidate)?;
        Ok(candidates)
    }

    /// `NAME_pair`: the color over two normal distributions. Rounded weights may add up to more than one.
    fn pair_glue(&self, color: &str, tables: &[Table]) -> String {
        let (name, reach) = (&self.name, number(self.chosen_ranges().deviation));
        let (parameters, arguments) = (parameters(tables), arguments(tables));
        let of = |part: char| format!("{name}_texture(mean + s * pair.offsets.{part}, s * pair.deviation{arguments})");
        format!(
            "
/// Mean color of `{name}` over a pixel that covers two normal distributions of one deviation, whose values together
/// have the mean, the deviation, the skewness and the excess kurtosis, the last two 0 where they are not known.
fn {name}_pair(mean: f32, deviation: f32, skewness: f32, kurtosis: f32{parameters}) -> {color} {{
    let pair = mixture_pair(skewness, kurtosis);
    let s = min(deviation, {reach});
    let higher = {};
    let lower = {};
    return clamp(lower + pair.weights.x * (higher - lower), min(lower, higher), max(lower, higher));
}}
",
            of('x'),
            of('y')
        )
    }

    /// A distribution that what is filtered has none of, or a setting that does not go with the distribution.
    pub(super) fn undistributed(&self, values: bool) -> Option<String> {
        let own = &self.distribution;
        if *own != Distribution::Normal && !values {
            return Some(format!("{own}, which values of a `texture` have"));
        }
        if let Some(driver) = self.driver.as_ref().filter(|driver| *own == Distribution::Pair && !driver.knows_shape())
        {
            return Some(format!("{own} for a driver that gives {}, but not their shape", driver.gives()));
        }
        let tier = self.tier.filter(|tier| own.tabulated() && *tier != Tier::Table);
        let with = format!("{own} together with");
        if let Some(tier) = tier {
            return Some(format!("{with} {tier}: it stands in a table"));
        }
        if own.tabulated() && !self.accuracy.unwrap_or_default().tables {
            return Some(format!("{with} an accuracy without tables: it stands in one"));
        }
        (own.ranges().is_some() && self.ranges.is_some()).then(|| format!("{with} `ranges`, which are its own"))
    }
}
