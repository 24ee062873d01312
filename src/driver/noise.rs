//! The driver of noise: sums of octaves on lattices, and what a footprint holds of them.

use super::bend;
use super::fold::NoiseFold;
use super::function::{Dimensions, Function};
use super::solid::{self, Solid};
use super::taps::{Pixel, Taps};
use crate::Error;

/// A driver that sums octaves of noise, fractional Brownian motion, and knows of a footprint the mean and the variance,
/// in the plane those of its slopes, too.
///
/// Nothing is stored and nothing sampled twice: mean and variance follow from one evaluation of the noise and its
/// gradient, whatever the footprint's size, length and turn. Where an octave is resolved the variance is what its
/// gradient tells; where it is lost it is the whole octave's.
///
/// ```
/// use prefilter::{ColorMap, Driver, Noise, Scene, Taps};
/// let rock = ColorMap::gradient([(0.2, [0.2, 0.15, 0.1]), (0.8, [0.7, 0.65, 0.6])])?;
/// let noise = Noise { octaves: 5, taps: Taps::Four, ..Noise::default() };
/// let module = Scene::new("rock").texture(rock).driver(Driver::Noise(noise)).module()?;
/// assert_eq!(module.exports()[2].signature, "fn rock_color(position: vec2f, dpdx: vec2f, dpdy: vec2f) -> vec3f");
/// # Ok::<(), prefilter::Error>(())
/// ```
///
/// Noise in the plane, not folded and by [`NoiseMethod::Gradient`], is also a height field with slopes, in heights a
/// unit of the position. The mean slope is what the gradients at the point tell of it, and around that the covariance
/// is the one that footprints of this size, length and turn have on the average: within 3 % of samples for every
/// lattice, of one octave and of several (`spirv-tests/tests/noise/slopes.rs`). An octave has the slopes of the one
/// before times gain and lacunarity, by default as many: where the last octaves are lost, so are most slopes.
/// Root mean square errors of the color by the slope along a direction, in thousandths, for six octaves with slopes of
/// a deviation of about ½ on a plane to the horizon, all slopes counted alike:
///
/// | map | 1 tap | 2 taps | 4 taps | 8 taps | mean slope | slope of a point |
/// |---|---|---|---|---|---|---|
/// | terrain | 48.7 | 42.3 | 36.5 | 30.9 | 233.1 | 297.1 |
/// | steps6 | 42.6 | 37.2 | 32.5 | 28.1 | 257.3 | 312.5 |
///
/// ```
/// use prefilter::{ColorMap, Driver, Noise, Scene};
/// let steep = ColorMap::gradient([(0.2, [0.3, 0.4, 0.1]), (0.6, [0.5, 0.45, 0.4])])?;
/// let hills = Driver::Noise(Noise { deviation: 0.1, ..Noise::default() });
/// let module = Scene::new("hills").steepness(steep).driver(hills).module()?;
/// assert!(module.wgsl().contains("fn hills_surface("));
/// # Ok::<(), prefilter::Error>(())
/// ```
///
/// Default: six octaves of Perlin's noise with a gain of ½ and a lacunarity of 2, each turned by half a radian against
/// the one before, around 0.5 with a deviation of 0.18; one tap and a pixel deviation of 0.5.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct Noise {
    /// The noise of one octave. The first has cells of the size 1.
    pub basis: NoiseBasis,
    /// What becomes of every octave before they are summed.
    pub fold: NoiseFold,
    /// How many octaves, 1 to 16.
    pub octaves: u32,
    /// An octave's amplitude over that of the one before, above 0 and up to 1.
    pub gain: f32,
    /// An octave's frequency over that of the one before, 1 to 16.
    pub lacunarity: f32,
    /// How far each octave is turned against the one before, −6.3 to 6.3 radians; in space about a cell's diagonal.
    pub rotation: f32,
    /// Seeds have noise of their own.
    pub seed: u32,
    /// After how many cells of the first octave it repeats along every axis, up to 2²⁰ of the last octave's; 0 is
    /// never. Tiles need a square or cubic lattice, a whole lacunarity and no rotation.
    pub period: u32,
    /// Its mean over all places, −1e6 to 1e6.
    pub mean: f32,
    /// Its deviation over all places, 0 to 1e6.
    pub deviation: f32,
    /// How mean and variance are told from one evaluation.
    pub method: NoiseMethod,
    /// Evaluations of the color a pixel.
    pub taps: Taps,
    /// The filter that turns samples into a pixel.
    pub pixel: Pixel,
}

/// The noise of one octave. All have the mean 0 and are smooth: quintic fades, or kernels of degree 8.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum NoiseBasis {
    /// Perlin's: lines at the points of a square lattice.
    #[default]
    Perlin,
    /// Values at the points of a square lattice.
    Value,
    /// Lines at the points of a lattice of triangles, which cannot tile.
    Simplex,
    /// Perlin's in space, of a position with three coordinates: a surface cuts it.
    PerlinSolid,
    /// Values at the points of a cubic lattice in space.
    ValueSolid,
}

/// How mean and variance over a footprint are told from one evaluation of the noise.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum NoiseMethod {
    /// By the noise and its gradient, as a Gaussian process of the same spectrum has them on the average.
    #[default]
    Gradient,
    /// By its second derivatives, too, of which the mean has what a footprint bends: half the error of the mean where
    /// footprints are smaller than a cell, and less shimmer, in 1.25 times the time. Of noise in the plane that is not
    /// folded; slopes are not known.
    Curvature,
    /// The paper's: every octave with the deviation that the footprint leaves it, and the variance that it loses over
    /// the whole plane, for a round footprint of the major deviation. For comparison.
    Stationary,
}

/// Names of the shelf's functions, and the variance of the noise.
pub(super) struct Shelf {
    pub name: &'static str,
    pub variance: f64,
    /// Its mean of |n| over the plane, over its deviation; a test measures it.
    pub folded: f64,
    pub periodic: bool,
}

impl Default for Noise {
    fn default() -> Self {
        Self {
            basis: NoiseBasis::default(),
            fold: NoiseFold::default(),
            octaves: 6,
            gain: 0.5,
            lacunarity: 2.0,
            rotation: 0.5,
            seed: 0,
            period: 0,
            mean: 0.5,
            deviation: 0.18,
            method: NoiseMethod::default(),
            taps: Taps::default(),
            pixel: Pixel::default(),
        }
    }
}

impl NoiseBasis {
    pub(super) fn shelf(self) -> Shelf {
        let (name, variance, folded, periodic) = match self {
            Self::Perlin => ("perlin", 0.0465311504, 0.8166, true),
            Self::Value => ("value", 0.204650088, 0.837, true),
            Self::Simplex => ("simplex", 0.144655223, 0.8667, false),
            Self::PerlinSolid => ("perlin_solid", 0.0729189457, 0.0, true),
            Self::ValueSolid => ("value_solid", 0.160353532, 0.0, true),
        };
        Shelf { name, variance, folded, periodic }
    }

    /// The variance of its slopes along either axis over that of its values, of a noise in the plane.
    fn steepness(self) -> Option<f64> {
        match self {
            Self::Perlin => Some(8.38395208),
            Self::Value => Some(3.64640884),
            Self::Simplex => Some(160.0 / 7.0),
            Self::PerlinSolid | Self::ValueSolid => None,
        }
    }

    /// Names of the shelf, of a noise in space.
    fn solid(self) -> Option<Solid> {
        match self {
            Self::Perlin | Self::Value | Self::Simplex => None,
            Self::PerlinSolid => Some(Solid { noise: "perlin_solid", filter: "perlin_solid" }),
            // A plane cuts its correlation to that of the noise in the plane.
            Self::ValueSolid => Some(Solid { noise: "value_solid", filter: "value" }),
        }
    }
}

impl Noise {
    /// Whether the description can be used.
    ///
    /// # Errors
    /// [`Error::Size`] and [`Error::Value`] for numbers outside their ranges, [`Error::Conflict`] for tiles that do not
    /// repeat.
    pub(crate) fn check(&self) -> Result<(), Error> {
        self.pixel.check()?;
        if !(1..=16).contains(&self.octaves) {
            let (what, count) = ("the noise's number of octaves".into(), self.octaves as usize);
            return Err(Error::Size { what, count, allowed: "1 to 16".into() });
        }
        if self.fold != NoiseFold::None && self.method != NoiseMethod::Gradient {
            return Err(Error::Conflict("folded noise has the method `Gradient`: no other knows folds".into()));
        }
        if self.method == NoiseMethod::Curvature && self.basis.solid().is_some() {
            return Err(Error::Conflict("noise by its `Curvature` is of the plane: its basis is not in space".into()));
        }
        if self.fold != NoiseFold::None && self.basis.solid().is_some() {
            return Err(Error::Conflict("folded noise is of the plane: its basis is not in space".into()));
        }
        let numbers = [
            ("gain", self.gain, f32::MIN_POSITIVE, 1.0),
            ("lacunarity", self.lacunarity, 1.0, 16.0),
            ("rotation", self.rotation, -6.3, 6.3),
            ("mean", self.mean, -1e6, 1e6),
            ("deviation", self.deviation, 0.0, 1e6),
        ];
        // Written so that NaN is refused.
        if let Some((name, value, low, high)) =
            numbers.into_iter().find(|(_, value, low, high)| !(low..=high).contains(&value))
        {
            return Err(Error::value(format!("the noise's {name}"), value, format!("{low} to {high}")));
        }
        self.check_period()
    }

    fn check_period(&self) -> Result<(), Error> {
        let refuse =
            |what: &str| Err(Error::Conflict(format!("noise that repeats after {} cells {what}", self.period)));
        let cells = f64::from(self.period) * f64::from(self.lacunarity).powi(self.octaves as i32 - 1);
        match self.period {
            0 => Ok(()),
            _ if self.basis == NoiseBasis::Simplex => {
                refuse("is not `Simplex`, whose lattice has no periods; take `Perlin`")
            }
            _ if self.rotation != 0.0 => refuse("has octaves that are not turned; give it a `rotation` of 0"),
            _ if self.lacunarity.fract() != 0.0 => refuse("has a whole `lacunarity`"),
            _ if cells > 1_048_576.0 => refuse("has at most 2²⁰ of them in the last octave"),
            _ => Ok(()),
        }
    }

    /// Whether it knows the slopes of its heights: in the plane, without folds, by [`NoiseMethod::Gradient`].
    pub(crate) fn knows_slopes(&self) -> bool {
        self.steepness().is_some()
    }

    /// The variance of the noise's slopes along either axis over that of its values, where a footprint's are known.
    fn steepness(&self) -> Option<f64> {
        let known = self.fold == NoiseFold::None && self.method == NoiseMethod::Gradient;
        self.basis.steepness().filter(|_| known)
    }

    /// What it says of a footprint, as of values or, where it knows slopes, as of heights.
    pub(crate) fn function(&self, slopes: bool) -> Function {
        let solid = self.basis.solid();
        let steepness = self.steepness().filter(|_| slopes);
        Function {
            what: format!("{} octaves of noise", self.octaves),
            dimensions: if solid.is_some() { Dimensions::Solid } else { Dimensions::Plane },
            body: match (solid, steepness) {
                (Some(solid), _) => solid::body(self, &solid, self.placed(), self.basis.shelf().variance),
                (None, Some(steepness)) => self.surface(steepness),
                (None, None) if self.method == NoiseMethod::Curvature => self.bent_body(),
                (None, None) => self.body(),
            },
            surface: steepness.is_some(),
            trips: self.octaves as usize,
            taps: self.taps,
            pixel: self.pixel,
            gap: steepness.map_or_else(|| self.gap(), |_| self.gap() + &self.gap_of_slopes()),
        }
    }

    /// What no bound covers: one point with its gradient cannot tell all of a footprint.
    ///
    /// Of six octaves of Perlin's noise; `spirv-tests/tests/noise/figures.rs` and `folds.rs` measure them again.
    fn gap(&self) -> String {
        let [found, naive] = self.fold.errors(self.taps);
        let [terrain, steps] = match self.method {
            NoiseMethod::Gradient => found,
            NoiseMethod::Curvature => bend::errors(self.taps),
            NoiseMethod::Stationary => [0.070, 0.089],
        };
        let taps = if self.method == NoiseMethod::Stationary { " by one tap" } else { "" };
        format!(
            "how far a point of the noise tells what a footprint holds{taps}. Of six octaves of Perlin's noise\n    \
             on a plane to the horizon the largest error of a channel has an RMS of {terrain:.3} under a\n    \
             terrain map and {steps:.3} under hard steps; the naive map has {:.3} and {:.3}",
            naive[0], naive[1]
        )
    }

    /// Where the sum of octaves is 0, and its scale.
    pub(super) fn placed(&self) -> [f32; 2] {
        let sum = |power: i32| -> f64 {
            (0..self.octaves).map(|octave| f64::from(self.gain).powi(power * octave as i32)).sum()
        };
        let Shelf { variance, folded, .. } = self.basis.shelf();
        let deviation = f64::from(self.deviation) / (sum(2) * variance).sqrt();
        let [start, scale] = match self.fold.sign() {
            None => [0.0, deviation],
            Some(sign) => {
                let scale = sign * deviation / (1.0 - folded * folded).sqrt();
                [-scale * sum(1) * folded * variance.sqrt(), scale]
            }
        };
        [(f64::from(self.mean) + start) as f32, scale as f32]
    }
}
