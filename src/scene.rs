//! From a description to a module: the only file that knows drivers, transfer functions and filters together.

mod candidate;
mod combination;
mod combined;
mod driven;
mod explanation;
mod filtered;
mod heights;
mod irradiance;
#[cfg(feature = "joint")]
mod joint;
mod layer;
mod leaves;
mod percentile;
mod polynomial;
mod sizes;
mod slope;
mod slope_map;
mod stage;
mod steepness;
mod transferred;
mod values;

use crate::accuracy::{Accuracy, Ranges};
use crate::driver::Driver;
use crate::filter::combine::Reflectance;
use crate::filter::distribution::Distribution;
use crate::filter::height::{HeightTier, Microsurface};
use crate::filter::height_transfer::TransferTier;
use crate::filter::irradiance::IrradianceTier;
use crate::filter::slope::SlopeTier;
use crate::filter::slope_map::SlopeTaps;
use crate::filter::{self, Tier};
use crate::module::Module;
use crate::transfer::color_map::{ColorMap, Colors};
use crate::transfer::height_transfer::HeightTransfer;
use crate::transfer::irradiance::Irradiance;
use crate::transfer::slope_map::SlopeMap;
use crate::{name, Error};

pub use combination::Combination;
#[cfg(feature = "joint")]
pub use joint::JointMap;

/// What a material needs: what is filtered, over which values, and how closely.
///
/// A scene filters one thing: one of [`Self::texture`], [`Self::height`], [`Self::height_percentile`], [`Self::slope`],
/// [`Self::slope_map`], [`Self::steepness`] and [`Self::irradiance`], or a [`Self::combination`] of such scenes. A
/// material that needs more has a scene for each, whose modules [`link`](crate::link) takes together. [`Self::module`]
/// refuses two, and settings that have no meaning for what is filtered.
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
    #[cfg_attr(feature = "serde", serde(default))]
    distribution: Distribution,
    height: Option<ColorMap>,
    #[cfg_attr(feature = "serde", serde(default))]
    percentile: Option<ColorMap>,
    #[cfg_attr(feature = "serde", serde(default))]
    slope: Option<ColorMap>,
    #[cfg_attr(feature = "serde", serde(default))]
    slope_map: Option<SlopeMap>,
    #[cfg_attr(feature = "serde", serde(default))]
    slope_taps: Option<SlopeTaps>,
    #[cfg_attr(feature = "serde", serde(default))]
    steepness: Option<ColorMap>,
    #[cfg_attr(feature = "serde", serde(default))]
    irradiance: Option<Irradiance>,
    #[cfg_attr(feature = "serde", serde(default))]
    combination: Option<Combination>,
    #[cfg_attr(feature = "serde", serde(default))]
    reflectance: Option<Reflectance>,
    #[cfg_attr(feature = "serde", serde(default))]
    microsurface: Microsurface,
    #[cfg_attr(feature = "serde", serde(default))]
    transfer: Option<HeightTransfer>,
    #[cfg_attr(feature = "serde", serde(default))]
    transfer_tier: Option<TransferTier>,
    colors: Colors,
    tier: Option<Tier>,
    height_tier: Option<HeightTier>,
    #[cfg_attr(feature = "serde", serde(default))]
    slope_tier: Option<SlopeTier>,
    #[cfg_attr(feature = "serde", serde(default))]
    irradiance_tier: Option<IrradianceTier>,
    accuracy: Option<Accuracy>,
    ranges: Option<Ranges>,
    driver: Option<Driver>,
}

impl Scene {
    /// A scene whose exports' names begin with `name`: an identifier that no shading language reserves.
    pub fn new(name: &str) -> Self {
        Self {
            name: name.to_owned(),
            texture: None,
            distribution: Distribution::default(),
            height: None,
            percentile: None,
            slope: None,
            slope_map: None,
            slope_taps: None,
            steepness: None,
            irradiance: None,
            combination: None,
            reflectance: None,
            microsurface: Microsurface::default(),
            transfer: None,
            transfer_tier: None,
            colors: Colors::default(),
            tier: None,
            height_tier: None,
            slope_tier: None,
            irradiance_tier: None,
            accuracy: None,
            ranges: None,
            driver: None,
        }
    }

    /// C0: color by a value of which a pixel covers a normal distribution. Exports `NAME_texture(mean, deviation)`.
    #[must_use]
    pub fn texture(self, map: ColorMap) -> Self {
        Self { texture: Some(map), ..self }
    }

    /// Ch: color by the height of a rough surface whose hidden parts do not count.
    ///
    /// Exports `NAME_height(mean, deviation, slope_covariance, view, light, …)`, the mean color over the heights that
    /// are seen and lit, and apart from it `NAME_visibility(slope_covariance, view, light)`, the share of what is seen
    /// that is lit.
    ///
    /// The ranges are those of the heights' mean and deviation, and of their sum with noise where the
    /// [`Microsurface`] is perturbed. Bounds are against Smith's model, for Λ of view and
    /// light that add up to 1e4 at most, and but for [`HeightTier::Exact`] for deviations from a thousandth of the
    /// largest mean, or from a tenth of the largest deviation where that is less: move heights far above 0 towards it.
    ///
    /// ```
    /// use prefilter::{ColorMap, HeightTier, Scene};
    /// let moss = ColorMap::bands([0.1, 0.2, 0.05], [(0.4, [0.3, 0.3, 0.25]), (0.8, [0.6, 0.6, 0.55])])?;
    /// let module = Scene::new("moss").height(moss).height_tier(HeightTier::Exact).module()?;
    /// let names: Vec<_> = module.exports().iter().map(|export| export.name.as_str()).collect();
    /// assert_eq!(names, ["moss_height", "moss_visibility"]);
    /// # Ok::<(), prefilter::Error>(())
    /// ```
    #[must_use]
    pub fn height(self, map: ColorMap) -> Self {
        Self { height: Some(map), ..self }
    }

    /// What hides parts of the surface that is colored by height. Default: view and light, taken for independent.
    #[must_use]
    pub fn microsurface(self, microsurface: Microsurface) -> Self {
        Self { microsurface, ..self }
    }

    /// Where the module finds the colors. Default: in the text.
    #[must_use]
    pub fn colors(self, colors: Colors) -> Self {
        Self { colors, ..self }
    }

    /// This tier instead of the cheapest that keeps the accuracy; of a scene of heights or slopes, the tier of the
    /// color map that theirs stands on.
    #[must_use]
    pub fn tier(self, tier: Tier) -> Self {
        Self { tier: Some(tier), ..self }
    }

    /// This tier of heights instead of the cheapest that keeps the accuracy, which is then the color map's alone.
    #[must_use]
    pub fn height_tier(self, tier: HeightTier) -> Self {
        Self { height_tier: Some(tier), ..self }
    }

    /// This tier of slopes instead of the cheapest that keeps the accuracy, which is then the color map's alone.
    #[must_use]
    pub fn slope_tier(self, tier: SlopeTier) -> Self {
        Self { slope_tier: Some(tier), ..self }
    }

    /// This tier of irradiance instead of the cheapest that keeps the accuracy.
    #[must_use]
    pub fn irradiance_tier(self, tier: IrradianceTier) -> Self {
        Self { irradiance_tier: Some(tier), ..self }
    }

    /// The largest filter error; the cheapest tier whose bound keeps it is chosen. Default: 1/255, and where no tier
    /// keeps that, but for values of normal distributions, the lightest whose bound is within 1.1 times that of the
    /// closest.
    #[must_use]
    pub fn accuracy(self, accuracy: Accuracy) -> Self {
        Self { accuracy: Some(accuracy), ..self }
    }

    /// The values over which bounds hold and tables reach; larger deviations count as the largest. Percentiles have
    /// none. Default: [`Ranges::of`] the map, which for a map over [0, 1] is [`Ranges::default`].
    #[must_use]
    pub fn ranges(self, ranges: Ranges) -> Self {
        Self { ranges: Some(ranges), ..self }
    }

    /// Where the filter's statistics come from: those of values and heights by [`Driver::Moments`], of slopes by
    /// [`Driver::SlopeMoments`], of either by functions such as [`Driver::Custom`]. Exports `NAME_color(position, dpdx,
    /// dpdy, …)` besides the filter, which takes behind the derivatives what the filter does behind its statistics,
    /// then the driver's textures, then the filter's; and of a function that gives values
    /// `NAME_statistics(position, across, along)`.
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
        let maps = [&self.texture, &self.height, &self.percentile, &self.slope, &self.steepness];
        maps.into_iter().flatten().next()
    }

    /// The ranges that bounds hold over: those of the distribution, those given, or else those of the map.
    pub fn chosen_ranges(&self) -> Ranges {
        let own = match (&self.slope_map, &self.irradiance) {
            (Some(_), _) => filter::slope_map::atlas::RANGES,
            (None, Some(_)) => filter::irradiance::RANGES,
            (None, None) => Ranges::default(),
        };
        self.distribution.ranges().or(self.ranges).unwrap_or_else(|| self.map().map_or(own, Ranges::of))
    }

    /// Generates, links and validates the module.
    ///
    /// In a release build closed forms of some dozen knots take well below 5 ms; beyond some hundred constant knots
    /// naga's time grows with their square. Tables, which are tried unless the scene names a tier or the accuracy
    /// forbids them, take one core some 3 ms to bake of values or heights for a dozen knots, 5 ms of steepness, 15 ms
    /// of maps of the whole slope, 40 ms of heights by a curve, and seconds for a thousand knots.
    ///
    /// # Errors
    /// A name that cannot be used, a scene that filters nothing or more than one thing, a setting that has no meaning
    /// for that, ranges or an accuracy outside their limits, a tier that does not go with the colors, or no tier that
    /// keeps the accuracy.
    pub fn module(&self) -> Result<Module, Error> {
        name::check(&self.name)?;
        self.generated()
    }

    /// The same, whatever the name: scenes within have one that nobody gave.
    fn generated(&self) -> Result<Module, Error> {
        self.distribution.check()?;
        self.chosen_ranges().check()?;
        self.accuracy.map_or(Ok(()), |accuracy| accuracy.check())?;
        self.driver.as_ref().map_or(Ok(()), |driver| driver.check())?;
        if let Some(curve) = self.curve()? {
            return self.transferred(curve);
        }
        if let Some(combination) = &self.combination {
            self.combines()?;
            return self.combined(combination);
        }
        let (chosen, passed) = self.choose()?;
        let explanation = self.explain(&chosen, &passed);
        Ok(Module {
            name: self.name.clone(),
            exports: self.exports(&chosen.text.glue),
            glue: chosen.text.glue,
            foreign: self.foreign(),
            linked: chosen.linked,
            tables: chosen.filter.tables,
            explanation,
            bound: chosen.filter.bound,
            turns: chosen.turns,
            cost: chosen.cost,
        })
    }
}
