//! The tiers of steepness that a scene tries.

use super::candidate::{parameters, Candidate, Over, Text};
use super::sizes::of_texels;
use super::Scene;
use crate::filter::height::variation;
use crate::filter::steepness::{filter, floor, glue, Lengths, Steepness, GIVEN, NODES, SIZES};
use crate::filter::texture::color_type;
use crate::transfer::color_map::ColorMap;
use crate::Error;

impl Scene {
    /// Cs by steepness: color by the length |s| of the slopes s of a rough surface that a view sees, such as rock on
    /// cliffs.
    ///
    /// Exports `NAME_steepness(mean_slope, slope_covariance, view, table, table_sampler)`. With
    /// [`SlopeTier::Gaussian`](crate::SlopeTier::Gaussian), and where neither a tier nor an accuracy is asked for, that
    /// is one read from a table: the lengths are represented by the distribution of Rice that has the mean and the
    /// variance of |s|² of those seen. With [`SlopeTaps::Three`](crate::SlopeTaps::Three) those are three, a part of
    /// the slopes each: a step errs by a third of that, and slopes that vary more along an axis than across are told
    /// from those that do not. [`SlopeTier::Pair`](crate::SlopeTier::Pair) reads ten times, five round normal
    /// distributions for each of two: a fourth. [`SlopeTier::Naive`](crate::SlopeTier::Naive) is the map at the mean
    /// slope.
    ///
    /// The ranges are those of the mean slope's length and of the deviation along the widest axis of the covariance.
    /// Bounds are for views above the horizon of the mean surface, and for axes of ratios up to 2; up to 4, a step errs
    /// by up to 0.155, with three reads 0.072, with ten 0.062.
    ///
    /// ```
    /// use prefilter::{ColorMap, Scene};
    /// let cliff = ColorMap::gradient([(0.4, [0.1, 0.2, 0.05]), (0.7, [0.3, 0.3, 0.3]), (1.0, [0.4, 0.4, 0.4])])?;
    /// let module = Scene::new("cliff").steepness(cliff).module()?;
    /// assert_eq!(module.exports()[0].name, "cliff_steepness");
    /// # Ok::<(), prefilter::Error>(())
    /// ```
    #[must_use]
    pub fn steepness(self, map: ColorMap) -> Self {
        Self { steepness: Some(map), ..self }
    }

    pub(super) fn steepnesses(&self, map: &ColorMap) -> Result<Vec<Candidate>, Error> {
        if !self.accuracy.unwrap_or_default().tables {
            let what = format!("the scene `{}` filters a `steepness`, which needs a table", self.name);
            return Err(Error::Conflict(what));
        }
        let named = self.slope_tier.is_some() || self.slope_taps.is_some();
        let tiers = match (named, self.accuracy) {
            (true, _) => vec![self.named_lengths()?],
            (false, Some(_)) => vec![Lengths::One, Lengths::Three, Lengths::Ten],
            (false, None) => vec![Lengths::One],
        };
        let candidate = |tier: Lengths, nodes| {
            let Steepness { filter, alike } = filter(map, self.colors, tier, nodes, self.chosen_ranges());
            let glue = glue(&self.name, map, tier, &parameters(&filter.tables), &filter.body)
                + &self.driven("steepness", color_type(map.channels()), GIVEN, &filter.tables);
            let text = Text { glue, beneath: String::new(), alike };
            let table: f32 = filter.tables.iter().map(|table| 2.0 * table.error).sum();
            let judged = if named { table } else { filter.bound.value() };
            let label = tier.label().to_owned() + &of_texels(nodes, NODES);
            self.candidate(label, Over::Steepness(tier), judged, filter, text)
        };
        let mut candidates = Vec::new();
        for tier in tiers {
            let attempt = |nodes| Ok(vec![candidate(tier, nodes)?]);
            candidates.extend(self.by_sizes(&self.sizes(&SIZES, NODES), attempt)?);
        }
        Ok(candidates)
    }

    /// What the tier of slopes and the reads name.
    fn named_lengths(&self) -> Result<Lengths, Error> {
        Lengths::named(self.slope_tier, self.slope_taps).ok_or_else(|| {
            let tier = self.slope_tier.map(|tier| tier.to_string());
            let taps = self.slope_taps.map(|taps| taps.to_string());
            let both: Vec<String> = tier.into_iter().chain(taps).collect();
            Error::Conflict(format!("a `steepness` goes without {}", both.join(" by ")))
        })
    }

    /// What the bound of a scene of steepness is made of, and what it holds for.
    pub(super) fn covered_steepness(&self, tier: Lengths, map: &ColorMap) -> String {
        format!(
            "views above the horizon of the mean surface, deviations of slopes from {:.1e}, at most twice as large \
             along an axis as across: beyond the table a step errs by {:.2e}, times the total variation {:.3}",
            floor(self.chosen_ranges()),
            tier.step(),
            variation(map)
        )
    }
}
