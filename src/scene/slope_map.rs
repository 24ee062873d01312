//! The tiers of maps of the whole slope that a scene tries, and what their bounds hold for.

use super::candidate::{parameters, Candidate, Over, Text};
use super::sizes::of_texels;
use super::Scene;
use crate::filter::slope::SlopeTier;
use crate::filter::slope_map::atlas::{floor, Atlas, NODES, SIZES};
use crate::filter::slope_map::{body, edge_error, given, glue, over, SlopeTaps};
use crate::filter::texture::color_type;
use crate::transfer::color_map::ColorMap;
use crate::transfer::slope_map::SlopeMap;
use crate::Error;

/// Tiers and reads from which an accuracy chooses: five reads are lost on one normal distribution, and three are too
/// few for each of two where slopes vary twice as much across the view as along it. Seven lose nothing there, and
/// eleven little where they vary four times as much.
const CHOICES: [(SlopeTier, SlopeTaps); 5] = [
    (SlopeTier::Gaussian, SlopeTaps::One),
    (SlopeTier::Gaussian, SlopeTaps::Three),
    (SlopeTier::Pair, SlopeTaps::Five),
    (SlopeTier::Pair, SlopeTaps::Seven),
    CLOSEST,
];

/// The closest of them, for whoever asks for no accuracy.
const CLOSEST: (SlopeTier, SlopeTaps) = (SlopeTier::Pair, SlopeTaps::Eleven);

/// Those from which it chooses where the scene names the other.
const TIERS: [SlopeTier; 2] = [SlopeTier::Gaussian, SlopeTier::Pair];
const TAPS: [SlopeTaps; 5] = [SlopeTaps::One, SlopeTaps::Three, SlopeTaps::Five, SlopeTaps::Seven, SlopeTaps::Eleven];

impl Scene {
    /// Cs of a map of the whole slope: color by direction and steepness of the slopes of a rough surface that a view
    /// sees, such as snow on one side, or a color for each aspect.
    ///
    /// Exports `NAME_slope_map(mean_slope, slope_covariance, view, table, table_sampler)`: reads from a volume of
    /// 96 × 96 × 20 texels, or of 32, 64 or 128 along either component where an accuracy asks for no more or for more.
    /// It takes 720 KiB where colors have three channels from 0 to 1, stored in ten bits each as parts of what the map
    /// spans, and 1.4 MiB in halves otherwise.
    /// [`SlopeTier`] says what stands for the visible slopes and [`Self::slope_taps`] how many reads for each normal
    /// distribution of those. The colors are, whichever [`Colors`](crate::Colors), in the table, which takes some
    /// hundredths of a second to bake.
    ///
    /// The ranges are those of each component of the mean slope and of the deviation along the widest axis of the
    /// covariance; by default means to 1 either way and deviations to 0.5. Bounds are estimates, for views above the
    /// horizon of the mean surface, for deviations from 0.24 of the largest, for axes of ratios up to 2 and for maps
    /// with one edge at a time: steps, discs and sectors were measured.
    ///
    /// ```
    /// use prefilter::{Scene, SlopeDomain, SlopeMap};
    /// let wheel = SlopeMap::from_function(64, SlopeDomain::All, |[x, y]| {
    ///     let azimuth = y.atan2(x);
    ///     [0.5 + 0.5 * azimuth.cos(), 0.5 + 0.5 * azimuth.sin(), 0.5]
    /// })?;
    /// let module = Scene::new("aspect").slope_map(wheel).module()?;
    /// assert_eq!(module.exports()[0].name, "aspect_slope_map");
    /// # Ok::<(), prefilter::Error>(())
    /// ```
    #[must_use]
    pub fn slope_map(self, map: SlopeMap) -> Self {
        Self { slope_map: Some(map), ..self }
    }

    /// So many reads for each normal distribution of slopes instead of the cheapest that keep the accuracy;
    /// [`SlopeTier::Naive`] has none. A [`Self::steepness`] takes one or three, or five for each of two, which is its
    /// [`SlopeTier::Pair`].
    #[must_use]
    pub fn slope_taps(self, taps: SlopeTaps) -> Self {
        Self { slope_taps: Some(taps), ..self }
    }

    /// The map of the whole slope, where the scene has one.
    pub fn map_of_slopes(&self) -> Option<&SlopeMap> {
        self.slope_map.as_ref()
    }

    /// The channels of the scene's colors, where it has a map.
    pub(super) fn channels(&self) -> Option<usize> {
        self.map().map(ColorMap::channels).or(self.map_of_slopes().map(SlopeMap::channels))
    }

    pub(super) fn slope_maps(&self, map: &SlopeMap) -> Result<Vec<Candidate>, Error> {
        if !self.accuracy.unwrap_or_default().tables {
            let what = format!("the scene `{}` filters a `slope_map`, which needs a table", self.name);
            return Err(Error::Conflict(what));
        }
        let choices = match (self.slope_tier, self.slope_taps) {
            (Some(SlopeTier::Naive), Some(taps)) => {
                return Err(Error::Conflict(format!("{} goes without {taps}", SlopeTier::Naive)))
            }
            (Some(SlopeTier::Naive), None) => vec![(SlopeTier::Naive, SlopeTaps::One)],
            (None, None) if self.accuracy.is_none() => vec![CLOSEST],
            (None, None) => CHOICES.to_vec(),
            (Some(tier), None) => TAPS.map(|taps| (tier, taps)).to_vec(),
            (None, Some(taps)) => TIERS.map(|tier| (tier, taps)).to_vec(),
            (Some(tier), Some(taps)) => vec![(tier, taps)],
        };
        let attempt = |nodes: usize| {
            let mut atlas = Atlas::new(map, nodes, self.chosen_ranges());
            let candidate = |(number, &(tier, taps)): (usize, &(SlopeTier, SlopeTaps))| {
                let table = if number + 1 == choices.len() { atlas.take(tier) } else { atlas.table(tier) };
                let filter = over(body(&atlas, map, tier, taps), table, map, tier, taps);
                let alike = body(&atlas, map, SlopeTier::Unweighted, taps);
                let label = format!("{tier} by {taps}{}", of_texels([nodes; 2], [NODES; 2]));
                let glue = glue(&self.name, map, &atlas, tier, &label, &parameters(&filter.tables), &filter.body)
                    + &self.driven("slope_map", color_type(map.channels()), given(tier), &filter.tables);
                let text = Text { glue, beneath: String::new(), alike };
                self.candidate(label, Over::SlopeMap(tier, taps), filter.bound.value(), filter, text)
            };
            choices.iter().enumerate().map(candidate).collect()
        };
        let named = self.slope_tier.is_some() && self.slope_taps.is_some();
        let sizes = if named { vec![NODES] } else { self.sizes(&SIZES, NODES) };
        self.by_sizes(&sizes, attempt)
    }

    /// What the bound of a scene of a slope map is made of, and what it holds for.
    pub(super) fn covered_slope_map(&self, tier: SlopeTier, taps: SlopeTaps, map: &SlopeMap) -> String {
        format!(
            "views above the horizon of the mean surface, deviations of slopes from {:.3}, at most twice as large \
             along an axis as across: beyond the table a step, a disc or a sector errs by {:.1e}, times the span \
             {:.3} of the colors",
            floor(self.chosen_ranges()),
            edge_error(tier, taps),
            map.widest_span()
        )
    }
}
