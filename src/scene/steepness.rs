//! Scenes of steepness, which have a single candidate.

use super::candidate::{parameters, Candidate, Over, Text};
use super::Scene;
use crate::filter::height::variation;
use crate::filter::shared::statements;
use crate::filter::steepness::{filter, floor, glue, shared, GIVEN, STEP};
use crate::filter::texture::color_type;
use crate::transfer::color_map::ColorMap;
use crate::Error;

/// The view to which all slopes count alike.
const ALIKE: &str = "    let view = vec3f(0.0, 0.0, 1.0);\n";

impl Scene {
    /// Cs by steepness: color by the length |s| of the slopes s of a rough surface that a view sees, such as rock on
    /// cliffs.
    ///
    /// Exports `NAME_steepness(mean_slope, slope_covariance, view, table, table_sampler)`: one read from a table. The
    /// lengths are represented by the distribution of Rice that has the mean and the variance of |s|² of those seen.
    ///
    /// The ranges are those of the mean slope's length and of the deviation along the widest axis of the covariance.
    /// Bounds are for views above the horizon of the mean surface, and for axes of ratios up to 2; up to 4, a step errs
    /// by up to 0.155.
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

    pub(super) fn steepnesses(&self, map: &ColorMap) -> Result<Candidate, Error> {
        if !self.accuracy.unwrap_or_default().tables {
            let what = format!("the scene `{}` filters a `steepness`, which needs a table", self.name);
            return Err(Error::Conflict(what));
        }
        let filter = filter(map, self.colors, self.chosen_ranges());
        let glue = glue(&self.name, map, &parameters(&filter.tables), &filter.body)
            + &self.driven("steepness", color_type(map), GIVEN, &filter.tables);
        let alike = ALIKE.to_owned() + &statements(&shared()) + &filter.body;
        let text = Text { glue, beneath: String::new(), alike };
        self.candidate("one distribution of Rice".to_owned(), Over::Steepness, filter.bound.value(), filter, text)
    }

    /// What the bound of a scene of steepness is made of, and what it holds for.
    pub(super) fn covered_steepness(&self, map: &ColorMap) -> String {
        format!(
            "views above the horizon of the mean surface, deviations of slopes from {:.1e}, at most twice as large \
             along an axis as across: beyond the table a step errs by {STEP:.2e}, times the total variation {:.3}",
            floor(self.chosen_ranges()),
            variation(map)
        )
    }
}
