//! Expressions of layers.

use std::collections::BTreeSet;
use std::ops::{Add, Mul, Neg, Sub};

use super::Scene;
use crate::filter::combine::Reflectance;
use crate::filter::height::Microsurface;
use crate::transfer::color_map::ColorMap;
use crate::{name, Error};

/// Colors of several layers, added and multiplied: each layer is a scene of its own, with its name and its settings.
///
/// Scenes, numbers up to ±65504, constant colors and weights that the caller passes are added, subtracted and
/// multiplied, channel by channel: `&snow * &high + &rock * (1.0 - &high)`. A scene may be mentioned more than once,
/// and is evaluated once.
///
/// The mean of a sum is the sum of the means. The mean of a product is the product of the means where its factors know
/// nothing of each other: values of differently named scenes of [`texture`](Scene::texture)s, heights, and slopes are
/// taken for independent, as a Gaussian surface has them. Two factors of heights, or two of slopes, are refused: make
/// one map of them. Masking and shadowing depend on heights alone and are one factor of the whole.
///
/// ```
/// use prefilter::{ColorMap, Combination, Scene};
/// let rock = Scene::new("rock").steepness(ColorMap::gradient([(0.3, [0.2, 0.3, 0.1]), (0.9, [0.4, 0.35, 0.3])])?);
/// let high = Scene::new("high").height(ColorMap::gradient([(0.6, [0.0; 3]), (0.8, [1.0; 3])])?);
/// let snow = Combination::color([0.9, 0.9, 0.95])?;
/// let hills = Scene::new("hills").combination(&rock * (1.0 - &high) + snow * &high);
/// let names: Vec<_> = hills.module()?.exports().iter().map(|export| export.name.clone()).collect();
/// assert_eq!(names, ["hills_combined", "hills_visibility"]);
/// # Ok::<(), prefilter::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(transparent))]
pub struct Combination(pub(super) Expression);

/// The nodes of an expression.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) enum Expression {
    Layer(Box<Scene>),
    Channel(Box<Scene>, usize),
    Number(f32),
    Color(ColorMap),
    Weight(String),
    Sum(Box<Expression>, Box<Expression>),
    Product(Box<Expression>, Box<Expression>),
}

impl Scene {
    /// Colors of several layers, each a scene, added and multiplied.
    ///
    /// Exports `NAME_combined`, the mean color, of the statistics that its layers need: mean and deviation of each
    /// texture's values, `LAYER_mean` and `LAYER_deviation`, then `mean` and `deviation` of the heights, `mean_slope`,
    /// `slope_covariance`, `view`, `light` and `direction`, the weights that it is passed and the tables. Smith's Λ and
    /// the distributions of heights and slopes that are seen are evaluated once for all layers. `NAME_visibility` is as
    /// of [`Self::height`].
    ///
    /// With [`Self::irradiance`] also `NAME_lit(…, x, y, z, …)`, the mean of the color times the irradiance, and with
    /// [`Self::reflectance`] `NAME_radiance(…, radiance, …)`, the whole of a directional light.
    ///
    /// Layers of values may have drivers that are functions of the position, and the combination one of the heights and
    /// slopes that its layers share. Then `NAME_color(position, dpdx, dpdy, …)` calls the last of these exports that
    /// there are with their statistics, and takes what no driver gives. Functions of different layers count as
    /// independent: give noises different seeds.
    ///
    /// The bound is that of the color. Each layer has its own tier, ranges and colors; an accuracy that the combination
    /// asks for is shared among layers that ask for none, by what they need. Accuracies and tiers of layers themselves
    /// are theirs, whatever the whole then errs by.
    #[must_use]
    pub fn combination(self, combination: impl Into<Combination>) -> Self {
        Self { combination: Some(combination.into()), ..self }
    }

    /// What reflects the light of a combination. Default: nothing, and no `NAME_radiance`.
    #[must_use]
    pub fn reflectance(self, reflectance: Reflectance) -> Self {
        Self { reflectance: Some(reflectance), ..self }
    }
}

impl Combination {
    /// A constant color of three or four linear channels.
    ///
    /// # Errors
    /// A channel that is no number or beyond ±65504, another count of channels.
    pub fn color<const N: usize>(color: [f32; N]) -> Result<Self, Error> {
        Ok(Self(Expression::Color(ColorMap::gradient([(0.0, color)])?)))
    }

    /// One channel of a layer as a weight, counted from 0: masks of several layers may be channels of one map.
    ///
    /// # Errors
    /// A layer without a color map, or whose map has no such channel.
    pub fn channel(layer: &Scene, channel: usize) -> Result<Self, Error> {
        let Some(count) = layer.channels() else {
            return Err(Error::Conflict(format!("`{}` has no color map, whose channel could be a weight", layer.name)));
        };
        if channel < count {
            return Ok(Self(Expression::Channel(Box::new(layer.clone()), channel)));
        }
        let what = format!("the channel of `{}`", layer.name);
        Err(Error::Size { what, count: channel, allowed: format!("below {count}, the number of its channels") })
    }

    /// A weight from −1 to 1 that the caller passes as a parameter of this name: bounds hold for those.
    ///
    /// [`Scene::module`] refuses names that the module has for something else, such as `light`.
    ///
    /// # Errors
    /// A name that cannot stand in a shader.
    pub fn weight(name: &str) -> Result<Self, Error> {
        name::check(name)?;
        Ok(Self(Expression::Weight(name.to_owned())))
    }
}

impl From<Scene> for Combination {
    fn from(scene: Scene) -> Self {
        Self(Expression::Layer(Box::new(scene)))
    }
}

impl From<&Scene> for Combination {
    fn from(scene: &Scene) -> Self {
        scene.clone().into()
    }
}

impl From<&Self> for Combination {
    fn from(combination: &Self) -> Self {
        combination.clone()
    }
}

impl From<f32> for Combination {
    fn from(number: f32) -> Self {
        Self(Expression::Number(number))
    }
}

fn sum(a: impl Into<Combination>, b: impl Into<Combination>) -> Combination {
    Combination(Expression::Sum(Box::new(a.into().0), Box::new(b.into().0)))
}

fn product(a: impl Into<Combination>, b: impl Into<Combination>) -> Combination {
    Combination(Expression::Product(Box::new(a.into().0), Box::new(b.into().0)))
}

/// Sums, differences and products of what may stand on the left with what may stand on the right.
macro_rules! arithmetic {
    ($($left:ty, $right:ty $(, $of:ident)?;)*) => {$(
        impl$(<$of: Into<Combination>>)? Add<$right> for $left {
            type Output = Combination;
            fn add(self, other: $right) -> Combination {
                sum(self, other)
            }
        }
        impl$(<$of: Into<Combination>>)? Sub<$right> for $left {
            type Output = Combination;
            fn sub(self, other: $right) -> Combination {
                sum(self, product(-1.0, other))
            }
        }
        impl$(<$of: Into<Combination>>)? Mul<$right> for $left {
            type Output = Combination;
            fn mul(self, other: $right) -> Combination {
                product(self, other)
            }
        }
    )*};
}

arithmetic! {
    Combination, T, T;
    &Combination, T, T;
    Scene, T, T;
    &Scene, T, T;
    f32, Combination;
    f32, &Combination;
    f32, Scene;
    f32, &Scene;
}

impl Neg for Combination {
    type Output = Self;
    fn neg(self) -> Self {
        product(-1.0, self)
    }
}

impl Expression {
    /// The leaves, from left to right.
    pub(super) fn leaves(&self) -> Vec<&Self> {
        match self {
            Self::Sum(a, b) | Self::Product(a, b) => [a.leaves(), b.leaves()].concat(),
            leaf => vec![leaf],
        }
    }

    /// What a mean depends on: values by the name of their scene, `heights`, `slopes`. Heights with noise on them
    /// depend on the values of a layer `noise`, whose statistics are the noise's.
    ///
    /// # Errors
    /// A product of factors that depend on the same.
    pub(super) fn variables(&self, surface: Microsurface) -> Result<BTreeSet<String>, Error> {
        match self {
            Self::Layer(scene) | Self::Channel(scene, _) => {
                let own = scene.variable();
                let noise = (surface.perturbed && own == "heights").then(|| "value `noise`".to_owned());
                Ok(noise.into_iter().chain([own]).collect())
            }
            Self::Number(_) | Self::Color(_) | Self::Weight(_) => Ok(BTreeSet::new()),
            Self::Sum(a, b) => Ok(&a.variables(surface)? | &b.variables(surface)?),
            Self::Product(a, b) => {
                let (first, second) = (a.variables(surface)?, b.variables(surface)?);
                match first.intersection(&second).next() {
                    None => Ok(&first | &second),
                    Some(both) => Err(Error::Conflict(format!(
                        "both factors of a product depend on the {both}, so that its mean is not the product of their \
                         means; make one map of both"
                    ))),
                }
            }
        }
    }

    /// The WGSL expression, a layer being `NAME_color`.
    pub(super) fn text(&self, literal: &dyn Fn(&ColorMap) -> String, number: &dyn Fn(f32) -> String) -> String {
        let of = |part: &Self| part.text(literal, number);
        match self {
            Self::Layer(scene) => format!("{}_color", scene.name),
            Self::Channel(scene, channel) => {
                format!("{}_color.{}", scene.name, ["x", "y", "z", "w"].get(*channel).unwrap_or(&"x"))
            }
            Self::Number(value) => number(*value),
            Self::Color(color) => literal(color),
            Self::Weight(name) => name.clone(),
            Self::Sum(a, b) => match (&**a, &**b) {
                (a, Self::Product(minus, b)) if **minus == Self::Number(-1.0) => format!("({} - {})", of(a), of(b)),
                (a, b) => format!("({} + {})", of(a), of(b)),
            },
            Self::Product(a, b) => format!("{} * {}", of(a), of(b)),
        }
    }

    /// The largest error of a channel, and the lowest and the highest value, from those of each layer.
    pub(super) fn error(&self, of: &dyn Fn(&Scene) -> [f64; 3]) -> [f64; 3] {
        match self {
            Self::Layer(scene) | Self::Channel(scene, _) => of(scene),
            Self::Number(value) => [0.0, f64::from(*value), f64::from(*value)],
            Self::Color(color) => {
                let [low, high] = hull(color.hull(), color.channels());
                [0.0, low, high]
            }
            Self::Weight(_) => [0.0, -1.0, 1.0],
            Self::Sum(a, b) => {
                let (a, b) = (a.error(of), b.error(of));
                rounded([0, 1, 2].map(|part| a[part] + b[part]))
            }
            Self::Product(a, b) => {
                let ([first, a, b], [second, c, d]) = (a.error(of), b.error(of));
                let most = |low: f64, high: f64| low.abs().max(high.abs());
                let ends = [a * c, a * d, b * c, b * d];
                let (low, high) =
                    (ends.into_iter().fold(f64::MAX, f64::min), ends.into_iter().fold(f64::MIN, f64::max));
                rounded([first * most(c, d) + second * most(a, b) + first * second, low, high])
            }
        }
    }
}

/// The error of an operation's result with what its rounding adds.
fn rounded([error, low, high]: [f64; 3]) -> [f64; 3] {
    [error + 1.2e-7 * low.abs().max(high.abs()), low, high]
}

/// The lowest and the highest of the channels that a map's hull uses.
pub(super) fn hull((low, high): ([f32; 4], [f32; 4]), used: usize) -> [f64; 2] {
    let ends = low[..used].iter().chain(&high[..used]).map(|channel| f64::from(*channel));
    [ends.clone().fold(f64::MAX, f64::min), ends.fold(f64::MIN, f64::max)]
}
