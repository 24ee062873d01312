//! Height transfer functions: curves from the value of a function to the height of a surface.

use super::color_map::MAX_COLOR;
use super::polynomial::Piece;
use super::shape::{creased, Shape};
use crate::Error;

/// A curve g that turns the values of a function f into the heights h = g(f) of a surface, such as the cushions of moss
/// or the pores of a sponge.
///
/// The surface's slopes are g′(f) times those of f: a curve may bend, but has no cliffs.
///
/// ```
/// use prefilter::HeightTransfer;
/// // Cushions 0.25 high over flat ground, where the noise is above 0.
/// let moss = HeightTransfer::smoothstep(0.0, 1.25)?.scaled(0.25, 0.0)?;
/// assert_eq!((moss.height(-0.5), moss.height(0.625)), (0.0, 0.125));
/// assert!(moss.is_monotone());
/// # Ok::<(), prefilter::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(into = "super::serial::Curve", try_from = "super::serial::Curve"))]
pub struct HeightTransfer {
    pub(super) shape: Shape,
    pub(super) amplitude: f32,
    pub(super) offset: f32,
    pub(super) values: Option<((f32, f32), f32)>,
    pieces: Vec<Piece>,
}

impl HeightTransfer {
    /// Lines between pairs of a value and a height, by rising values; constant below the first and above the last. Its
    /// range is that of the heights.
    ///
    /// # Errors
    /// No knot or more than 2048, a number that is not finite or beyond ±65504, values that do not rise, a slope beyond
    /// ±65504.
    pub fn knots(knots: impl IntoIterator<Item = (f32, f32)>) -> Result<Self, Error> {
        Self::new(Shape::Knots(knots.into_iter().collect()), 1.0, 0.0)
    }

    /// A smooth curve through heights at even steps from `low` to `high`, constant beyond. It rises where the samples
    /// rise and falls where they fall: its range is theirs.
    ///
    /// # Errors
    /// Fewer than two samples or more than 2048, a number that is not finite or beyond ±65504, `high` not above `low`,
    /// twice the slope between two samples beyond ±65504.
    pub fn samples(low: f32, high: f32, heights: &[f32]) -> Result<Self, Error> {
        Self::new(Shape::Samples { low, high, heights: heights.to_vec() }, 1.0, 0.0)
    }

    /// 0 up to `from`, 1 above `to`, and t²(3 − 2t) of t = (f − from)/(to − from) between. Its range is [0, 1].
    ///
    /// # Errors
    /// An end beyond ±65504, `to` not above `from`, or so close that the slope is beyond 65504.
    pub fn smoothstep(from: f32, to: f32) -> Result<Self, Error> {
        Self::new(Shape::Smoothstep { from, to }, 1.0, 0.0)
    }

    /// |f|: creases where f passes 0. Its range is 0 to ∞.
    pub fn absolute() -> Self {
        Self { shape: Shape::Absolute, amplitude: 1.0, offset: 0.0, values: None, pieces: creased().to_vec() }
    }

    /// A staircase from 0 to 1 over f from 0 to 1, constant beyond: a smoothstep in the middle of each of `count` equal
    /// steps, which takes the share `riser` of it, with level treads between. Its range is [0, 1].
    ///
    /// # Errors
    /// A count other than 1 to 512, a riser that is not above 0 and at most 1, or so narrow that the slope is beyond
    /// 65504.
    pub fn terraces(count: usize, riser: f32) -> Result<Self, Error> {
        Self::new(Shape::Terraces { count, riser }, 1.0, 0.0)
    }

    /// |f|^exponent with the sign of f: flat about 0, steep far from it. Its range is −∞ to ∞.
    ///
    /// # Errors
    /// An exponent other than 1 to 8.
    pub fn power(exponent: f32) -> Result<Self, Error> {
        Self::new(Shape::Power { exponent }, 1.0, 0.0)
    }

    /// The curve offset + amplitude · g.
    ///
    /// # Errors
    /// A number that is not finite or beyond ±65504, those of a curve that is scaled already multiplied out.
    pub fn scaled(self, amplitude: f32, offset: f32) -> Result<Self, Error> {
        let scaled = Self::new(self.shape, amplitude * self.amplitude, offset + amplitude * self.offset)?;
        Ok(Self { values: self.values, ..scaled })
    }

    /// The values of f that occur: means between two ends, and deviations up to one. Tables reach as far, and bounds
    /// hold there. Default: half of the part of the values over which the curve changes more on either side, of −1 to 1
    /// for curves that change everywhere, and deviations up to half of that part.
    ///
    /// A scene refuses ends less than 0.001 apart, a deviation below 0.001 and what is beyond ±65504.
    #[must_use]
    pub fn over(self, mean: (f32, f32), deviation: f32) -> Self {
        Self { values: Some((mean, deviation)), ..self }
    }

    /// The curve offset + amplitude · shape, checked: what every constructor ends in.
    pub(super) fn new(shape: Shape, amplitude: f32, offset: f32) -> Result<Self, Error> {
        for (what, value) in [("the amplitude of a height transfer", amplitude), ("the offset of one", offset)] {
            if !(value.abs() <= MAX_COLOR) {
                return Err(Error::value(what, value, format!("a number from -{MAX_COLOR} to {MAX_COLOR}")));
            }
        }
        let pieces = shape.pieces()?.into_iter().map(|piece| piece.scaled(amplitude.into(), offset.into())).collect();
        Ok(Self { shape, amplitude, offset, values: None, pieces })
    }

    /// The height h at a value of f.
    pub fn height(&self, value: f64) -> f64 {
        let [amplitude, offset] = self.scale();
        match self.piece(value) {
            Some(piece) => piece.height(value),
            None => offset + amplitude * value.signum() * value.abs().powf(self.exponent().unwrap_or(1.0)),
        }
    }

    /// The slope dh/df at a value of f; where the curve bends, that above the value.
    pub fn slope(&self, value: f64) -> f64 {
        let exponent = self.exponent().unwrap_or(1.0);
        match self.piece(value) {
            Some(piece) => piece.slope(value),
            None => self.scale()[0] * exponent * value.abs().powf(exponent - 1.0),
        }
    }

    /// Height and slope at a finite value of f.
    pub(crate) fn at(&self, value: f64) -> (f64, f64) {
        self.piece(value).map_or_else(|| (self.height(value), self.slope(value)), |piece| piece.at(value))
    }

    /// The lowest and the highest height over values from `low` to `high`, which may be infinite.
    pub fn range(&self, low: f64, high: f64) -> (f64, f64) {
        self.extremes(low, high, 0, |value| [self.height(value); 2])
    }

    /// The least and the greatest slope dh/df over values from `low` to `high`, which may be infinite.
    pub fn slopes(&self, low: f64, high: f64) -> (f64, f64) {
        // On both sides of where the curve bends.
        self.extremes(low, high, 1, |value| {
            let pieces = self.pieces().unwrap_or_default();
            let before = pieces.iter().find(|piece| piece.to == value && value > low);
            let before = before.map(|piece| piece.slope(value));
            let after = self.slope(value);
            [before.unwrap_or(after), if value < high { after } else { before.unwrap_or(after) }]
        })
    }

    /// Whether the curve never falls or never rises.
    pub fn is_monotone(&self) -> bool {
        let (least, greatest) = self.slopes(f64::NEG_INFINITY, f64::INFINITY);
        least >= 0.0 || greatest <= 0.0
    }

    /// The values at which the curve or its slope bends and those at which its height has an extremum, from the lowest.
    pub fn bends(&self) -> Vec<f64> {
        let Some(pieces) = self.pieces() else { return vec![0.0] };
        let turns = pieces.iter().flat_map(|piece| piece.turns()[0].clone());
        let mut bends: Vec<f64> = pieces.iter().skip(1).map(|piece| piece.from).chain(turns).collect();
        bends.sort_by(f64::total_cmp);
        bends
    }

    /// The values between `low` and `high` at which the curve passes a height or begins or ends to stay on it, from the
    /// lowest. Infinite ends count as the largest numbers.
    pub fn crossings(&self, low: f64, high: f64, height: f64) -> Vec<f64> {
        let [low, high] = [low, high].map(|end| end.clamp(f64::MIN, f64::MAX));
        let inner = self.bends().into_iter().filter(|&bend| low < bend && bend < high);
        let ends: Vec<f64> = [low].into_iter().chain(inner).chain([high]).collect();
        let above = |value: f64| self.height(value) - height;
        let mut found = Vec::new();
        for pair in ends.windows(2) {
            let [from, to] = [pair[0], pair[1]];
            let [start, end] = [from, to].map(above);
            if start == 0.0 && end != 0.0 && from > low && found.last() != Some(&from) {
                found.push(from);
            }
            if start * end < 0.0 {
                found.push(bisected(from, to, |value| above(value) * start < 0.0));
            }
            if end == 0.0 && start != 0.0 && to < high {
                found.push(to);
            }
        }
        found
    }

    /// The means between which f is, and its largest deviation, by [`Self::over`].
    pub(crate) fn values(&self) -> Option<((f32, f32), f32)> {
        self.values
    }

    /// The curve as cubics from −∞ to ∞; none for powers other than 1, 2 and 3.
    pub(crate) fn pieces(&self) -> Option<&[Piece]> {
        Some(self.pieces.as_slice()).filter(|pieces| !pieces.is_empty())
    }

    fn piece(&self, value: f64) -> Option<&Piece> {
        let pieces = self.pieces()?;
        pieces.get(pieces.partition_point(|piece| piece.to <= value)).or(pieces.last())
    }

    /// The exponent of a power.
    pub(crate) fn exponent(&self) -> Option<f64> {
        match self.shape {
            Shape::Power { exponent } => Some(f64::from(exponent)),
            _ => None,
        }
    }

    /// The amplitude and the offset of the curve.
    pub(crate) fn scale(&self) -> [f64; 2] {
        [self.amplitude, self.offset].map(f64::from)
    }

    /// The least and the greatest of the results at both ends, at the ends of pieces and at turns between them.
    fn extremes(&self, low: f64, high: f64, turn: usize, results: impl Fn(f64) -> [f64; 2]) -> (f64, f64) {
        let pieces = self.pieces().unwrap_or_default().iter();
        let inner = pieces.flat_map(|piece| piece.turns()[turn].clone().into_iter().chain([piece.to]));
        let inner = inner.chain([0.0]).filter(|&value| low < value && value < high);
        let results = inner.chain([low, high]).flat_map(results);
        results.fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), next| (least.min(next), most.max(next)))
    }
}

/// The value between two where a condition begins to hold.
fn bisected(from: f64, to: f64, holds: impl Fn(f64) -> bool) -> f64 {
    let [mut low, mut high] = [from, to];
    // Halves until there is no number between.
    loop {
        let middle = 0.5 * low + 0.5 * high;
        // Written so that what is no number ends it.
        if !(low < middle && middle < high) {
            return high;
        }
        if holds(middle) {
            high = middle;
        } else {
            low = middle;
        }
    }
}
