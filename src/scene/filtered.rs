//! What a scene filters, and which settings go with that.

use super::Scene;
use crate::driver::indicator_mipmap::MOST_EDGES;
use crate::driver::moments::Moments;
use crate::driver::Driver;
use crate::filter::height::{HeightTier, Microsurface};
use crate::filter::slope::SlopeTier;
use crate::transfer::color_map::{ColorMap, Colors};
use crate::transfer::irradiance::Irradiance;
use crate::transfer::slope_map::SlopeMap;
use crate::Error;

/// What a scene filters, of which it has one.
#[derive(Clone, Copy)]
pub(super) enum Filtered<'a> {
    /// C0.
    Texture(&'a ColorMap),
    /// Ch over heights.
    Height(&'a ColorMap),
    /// Ch over percentiles of heights.
    HeightPercentile(&'a ColorMap),
    /// Cs by a component.
    Slope(&'a ColorMap),
    /// Cs by the whole slope.
    SlopeMap(&'a SlopeMap),
    /// Cs by length.
    Steepness(&'a ColorMap),
    /// Light on the normals that are seen.
    Irradiance(&'a Irradiance),
}

impl std::fmt::Display for Filtered<'_> {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter.write_str(match self {
            Self::Texture(_) => "a `texture`",
            Self::Height(_) => "a `height`",
            Self::HeightPercentile(_) => "a `height_percentile`",
            Self::Slope(_) => "a `slope`",
            Self::SlopeMap(_) => "a `slope_map`",
            Self::Steepness(_) => "a `steepness`",
            Self::Irradiance(_) => "`irradiance`",
        })
    }
}

impl Filtered<'_> {
    /// Whether a driver gives the statistics that are needed.
    fn driven_by(self, driver: &Driver) -> bool {
        match driver {
            Driver::Moments(Moments { slopes: true, .. }) => matches!(self, Self::Height(_)),
            Driver::Moments(_) => matches!(self, Self::Texture(_) | Self::Height(_)),
            Driver::Indicators(_) => {
                let edges = if let Self::Texture(map) = self { map.edges() } else { None };
                edges.is_some_and(|edges| (1..=MOST_EDGES).contains(&edges.len()))
            }
            Driver::SlopeMoments(_) => self.of_slopes(),
            _ => matches!(self, Self::Texture(_) | Self::Height(_)) || driver.knows_slopes() && self.of_slopes(),
        }
    }

    /// Whether it is slopes that are filtered.
    fn of_slopes(self) -> bool {
        matches!(self, Self::Slope(_) | Self::SlopeMap(_) | Self::Steepness(_) | Self::Irradiance(_))
    }
}

impl Scene {
    /// What the scene filters.
    ///
    /// # Errors
    /// Nothing, or more than one; or a setting that it would ignore.
    pub(super) fn filtered(&self) -> Result<Filtered<'_>, Error> {
        let mut all = [
            self.texture.as_ref().map(Filtered::Texture),
            self.height.as_ref().map(Filtered::Height),
            self.percentile.as_ref().map(Filtered::HeightPercentile),
            self.slope.as_ref().map(Filtered::Slope),
            self.slope_map.as_ref().map(Filtered::SlopeMap),
            self.steepness.as_ref().map(Filtered::Steepness),
            self.irradiance.as_ref().map(Filtered::Irradiance),
        ]
        .into_iter()
        .flatten();
        let refused = |what: String| Err(Error::Conflict(format!("the scene `{}` {what}", self.name)));
        match (all.next(), all.next()) {
            (Some(one), None) => match self.ignored(one) {
                None => Ok(one),
                Some(setting) => Err(Error::Conflict(format!("{one} goes without {setting}"))),
            },
            (Some(one), Some(other)) => {
                refused(format!("has more than one filter, {one} and {other}; make a scene of each"))
            }
            (None, _) => refused(
                "filters nothing; give it a `texture`, a `height`, a `height_percentile`, a `slope`, a `slope_map`, a \
                 `steepness`, `irradiance` or a `combination`"
                    .into(),
            ),
        }
    }

    /// Whether the settings go with a combination.
    ///
    /// # Errors
    /// Another filter, or a setting that belongs to its layers.
    pub(super) fn combines(&self) -> Result<(), Error> {
        let irradiance = self.irradiance_tier.filter(|_| self.irradiance.is_none());
        let settings = [
            self.map().map(|_| "a color map of its own".to_owned()),
            self.undistributed(false),
            self.slope_map.as_ref().map(|_| "a map of slopes of its own".to_owned()),
            self.tier.map(|tier| format!("a color map's tier, {tier}")),
            self.height_tier.map(|tier| format!("a tier of heights, {tier}")),
            self.slope_tier.map(|tier| format!("a tier of slopes, {tier}")),
            self.slope_taps.map(|taps| format!("reads of a map of slopes, {taps}")),
            self.ranges.map(|_| "`ranges`".to_owned()),
            (self.colors == Colors::Dynamic && self.irradiance.is_none()).then(|| "dynamic colors".to_owned()),
        ];
        if let Some(setting) = settings.into_iter().flatten().next() {
            let what = format!("the combination `{}` goes without {setting}: give it to a layer", self.name);
            return Err(Error::Conflict(what));
        }
        match irradiance {
            Some(tier) => {
                Err(Error::Conflict(format!("{tier} is a tier of `irradiance`, which `{}` has not", self.name)))
            }
            None => Ok(()),
        }
    }

    /// A setting that has no meaning for what is filtered.
    fn ignored(&self, filtered: Filtered<'_>) -> Option<String> {
        use Filtered as F;
        let (heights, percentiles) = (matches!(filtered, F::Height(_)), matches!(filtered, F::HeightPercentile(_)));
        let mapped = heights || matches!(filtered, F::Texture(_) | F::Slope(_));
        let exact = |tier: HeightTier| percentiles && tier == HeightTier::Exact;
        let height_tier = self.height_tier.filter(|tier| !heights && !exact(*tier));
        let alike = self.slope_tier == Some(SlopeTier::Unweighted);
        let slopes = matches!(filtered, F::Slope(_) | F::SlopeMap(_)) || matches!(filtered, F::Steepness(_)) && !alike;
        let slope_tier = self.slope_tier.filter(|_| !slopes);
        let slope_taps = self.slope_taps.filter(|_| !matches!(filtered, F::SlopeMap(_) | F::Steepness(_)));
        let ranged = mapped || matches!(filtered, F::SlopeMap(_) | F::Steepness(_) | F::Irradiance(_));
        let irradiance_tier = self.irradiance_tier.filter(|_| !matches!(filtered, F::Irradiance(_)));
        let hidden = !heights && !percentiles && self.microsurface != Microsurface::default();
        let driver = self.driver.as_ref().filter(|driver| !filtered.driven_by(driver));
        let settings = [
            driver.map(|driver| format!("a driver that gives {}", driver.gives())),
            self.undistributed(matches!(filtered, F::Texture(_))),
            self.tier.filter(|_| !mapped).map(|tier| format!("a color map's tier, {tier}")),
            height_tier.map(|tier| format!("a tier of heights, {tier}")),
            slope_tier.map(|tier| format!("a tier of slopes, {tier}")),
            slope_taps.map(|taps| format!("{taps} from a table of slopes")),
            irradiance_tier.map(|tier| format!("a tier of irradiance, {tier}")),
            hidden.then(|| "a `microsurface`, which hides heights".to_owned()),
            (self.ranges.is_some() && !ranged).then(|| "`ranges`, which are those of values".to_owned()),
            self.reflectance.map(|_| "a `reflectance`, which a combination has".to_owned()),
            (percentiles && self.microsurface.perturbed)
                .then(|| "noise on the heights, which has no percentile".to_owned()),
        ];
        settings.into_iter().flatten().next()
    }
}
