//! Axes of tables: the value at each node. The way back, from a value to a coordinate, is `wgsl/math/grid.wgsl`.

/// Steps and shifts tried for an axis.
const FITS: u32 = 48;

/// One axis of a table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axis {
    /// The value at the low end.
    pub low: f64,
    /// The value at the high end.
    pub high: f64,
    /// Nodes: two or more for a range.
    pub count: usize,
    /// How the nodes are spread.
    pub spacing: Spacing,
}

/// How the nodes of an axis are spread between its ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Spacing {
    /// Evenly, a node on each end.
    Linear,
    /// Evenly in the cube root of the value, a node on each end; the low end is 0.
    CubeRoot,
    /// Evenly in the square root of the value, a node on each end; the low end is 0.
    SquareRoot,
    /// Evenly at the centers of `count` cells, as a texture's texels lie in [0, 1].
    Centers,
    /// Evenly in v / (unit + |v|), a node on each end: denser about 0, in the end to all numbers.
    Companded {
        /// The value that half of the nodes of an endless axis lie below.
        unit: f64,
    },
    /// Evenly in the logarithm of 1 + 12 v / high, a node on each end: at small values as evenly as linear, at large
    /// ones in even ratios. The low end is 0.
    Logarithm,
    /// Evenly in the logarithm of the value, a node on each end; both are above 0.
    Ratio,
}

/// How many times the value at the high end is that from which on the nodes of [`Spacing::Logarithm`] keep their ratio;
/// the shader of `wgsl/filter/slope_map.wgsl` is given it.
pub(crate) const BEND: f64 = 12.0;

impl Axis {
    /// An evenly spaced axis that covers a range with its nodes on round numbers: a power of ten is a whole number of
    /// steps, at least two. Maps bend at round numbers, and a bend on a node is read without error.
    ///
    /// With 512 nodes over −0.25 to 1.25 the step is 1/300, and every hundredth is a node.
    pub fn round(low: f64, high: f64, count: usize) -> Self {
        let steps = count.saturating_sub(1) as f64;
        let finest = (high - low) / steps;
        let unit = 10f64.powf((2.0 * finest).log10().ceil());
        let covered = |step: f64| (high / step).ceil() - (low / step).floor() <= steps;
        let most = (unit / finest).floor() as usize;
        let step = (1..=most).rev().map(|parts| unit / parts as f64).find(|&step| covered(step)).unwrap_or(unit);
        let start = (low / step).floor();
        Self { low: start * step, high: (start + steps) * step, count, spacing: Spacing::Linear }
    }

    /// An evenly spaced axis that covers a range, laid so that a map's bends are read as well as they can be.
    ///
    /// Interpolating a bend of slope change Δ at a fraction t between nodes errs by Δ h t (1 − t), where nothing is
    /// smoothed yet: of the steps h up to an eighth above the finest, and of the places of the first node, the pair
    /// with the smallest largest error. Each bend is a position and a slope change.
    pub fn fitted(low: f64, high: f64, count: usize, bends: &[(f64, f64)]) -> Self {
        let steps = count.saturating_sub(1) as f64;
        let finest = (high - low) / steps;
        let error = |start: f64, step: f64| {
            let miss = |&(at, change): &(f64, f64)| {
                let fraction = ((at - start) / step).rem_euclid(1.0);
                change.abs() * step * fraction * (1.0 - fraction)
            };
            bends.iter().map(miss).fold(0.0, f64::max)
        };
        let mut best = (f64::INFINITY, low, finest);
        for wider in 0..=FITS {
            let step = finest * (1.0 + 0.125 * f64::from(wider) / f64::from(FITS));
            let spare = steps * step - (high - low);
            for shift in 0..=FITS {
                let start = low - spare.min(step) * f64::from(shift) / f64::from(FITS);
                let candidate = (error(start, step), start, step);
                if candidate.0 < best.0 {
                    best = candidate;
                }
            }
        }
        Self { low: best.1, high: best.1 + steps * best.2, count, spacing: Spacing::Linear }
    }

    /// The first nodes alone, of an even spacing or one by roots.
    pub(crate) fn first(self, count: usize) -> Self {
        Self { high: self.value(count.saturating_sub(1) as f64), count, ..self }
    }

    /// The same axis with its ends as a shader knows them, and tells apart: far from 0 short axes are drawn longer.
    pub(crate) fn in_f32(self) -> Self {
        let [low, high] = [self.low, self.high].map(|end| end as f32);
        Self { low: low.into(), high: high.max(low.next_up()).into(), ..self }
    }

    /// The value at a node number; fractions lie between nodes as bilinear filtering sees them.
    pub fn value(&self, number: f64) -> f64 {
        let span = self.high - self.low;
        let part = number / self.count.saturating_sub(1).max(1) as f64;
        match self.spacing {
            Spacing::Linear => self.low + span * part,
            Spacing::CubeRoot => self.low + span * part * part * part,
            Spacing::SquareRoot => self.low + span * part * part,
            Spacing::Centers => self.low + span * (number + 0.5) / self.count as f64,
            Spacing::Companded { unit } => {
                let [low, high] = [self.low, self.high].map(|end| end / (unit + end.abs()));
                let companded = low + (high - low) * part;
                unit * companded / (1.0 - companded.abs())
            }
            Spacing::Logarithm => self.high * (part * BEND.ln_1p()).exp_m1() / BEND,
            Spacing::Ratio => self.low * (self.high / self.low).powf(part),
        }
    }

    /// By how much reading between a node and those beside it widens what is read: half of the largest variance that
    /// linear weights have, a quarter of the square of their distance. Nodes over so much less are as far off between
    /// nodes, one way, as at them the other.
    pub(crate) fn widening(&self, node: usize) -> f64 {
        let last = self.count.saturating_sub(1);
        let beside = [node.saturating_sub(1), (node + 1).min(last)].map(|beside| self.value(beside as f64));
        let here = self.value(node as f64);
        0.0625 * beside.map(|beside| (here - beside).powi(2)).iter().sum::<f64>()
    }

    /// The node number of a value: the inverse of [`Self::value`], clamped to the nodes as a clamping sampler does.
    pub fn number(&self, value: f64) -> f64 {
        let part = (value - self.low) / (self.high - self.low);
        let last = self.count.saturating_sub(1) as f64;
        let number = match self.spacing {
            Spacing::Linear => part * last,
            Spacing::CubeRoot => part.max(0.0).cbrt() * last,
            Spacing::SquareRoot => part.max(0.0).sqrt() * last,
            Spacing::Centers => part * self.count as f64 - 0.5,
            Spacing::Companded { unit } => {
                let [low, high, at] = [self.low, self.high, value].map(|value| value / (unit + value.abs()));
                (at - low) / (high - low) * last
            }
            Spacing::Logarithm => (BEND * value.max(0.0) / self.high).ln_1p() / BEND.ln_1p() * last,
            Spacing::Ratio => (value / self.low).max(1.0).ln() / (self.high / self.low).ln() * last,
        };
        number.clamp(0.0, last)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An axis of every spacing, with ends that are no round numbers.
    fn axes() -> Vec<Axis> {
        let spacings = [
            Spacing::Linear,
            Spacing::CubeRoot,
            Spacing::SquareRoot,
            Spacing::Centers,
            Spacing::Companded { unit: 0.7 },
            Spacing::Logarithm,
            Spacing::Ratio,
        ];
        let axis = |spacing: Spacing| match spacing {
            Spacing::Linear | Spacing::Centers => Axis { low: -0.3, high: 1.9, count: 17, spacing },
            Spacing::Companded { .. } => Axis { low: -23.0, high: 5.0, count: 17, spacing },
            Spacing::Ratio => Axis { low: 0.013, high: 0.61, count: 24, spacing },
            _ => Axis { low: 0.0, high: 0.61, count: 24, spacing },
        };
        spacings.map(axis).to_vec()
    }

    #[test]
    fn numbers_are_the_inverse_of_values() {
        for axis in axes() {
            let last = axis.count - 1;
            for part in 0..=4 * last {
                let number = 0.25 * part as f64;
                let found = axis.number(axis.value(number));
                assert!((found - number).abs() < 1e-9, "{axis:?}: {number} became {found}");
            }
            let rises = (1..=last).all(|node| axis.value(node as f64) > axis.value(node as f64 - 1.0));
            assert!(rises, "{axis:?}");
        }
    }

    #[test]
    fn what_is_beyond_the_ends_is_read_from_them() {
        for axis in axes() {
            let Axis { low, high, count, spacing } = axis;
            let last = (count - 1) as f64;
            let off = if spacing == Spacing::Centers { 0.5 * (high - low) / count as f64 } else { 0.0 };
            let [first, end] = [axis.value(0.0), axis.value(last)];
            assert!((first - low - off).abs() < 1e-12 && (high - off - end).abs() < 1e-12, "{axis:?}: {first}, {end}");
            for beyond in [1e-9, 1.0, 1e30] {
                assert_eq!([low - beyond, high + beyond].map(|at| axis.number(at)), [0.0, last], "{axis:?}: {beyond}");
            }
        }
    }

    /// Deviations of nothing, where logarithms end, read the first node.
    #[test]
    fn ratios_are_even_and_hold_at_and_below_zero() {
        let axis = Axis { low: 0.013, high: 0.61, count: 24, spacing: Spacing::Ratio };
        let ratio = axis.value(1.0) / axis.value(0.0);
        for node in 1..24 {
            let next = axis.value(f64::from(node)) / axis.value(f64::from(node) - 1.0);
            assert!((next / ratio - 1.0).abs() < 1e-12, "{node}: {next}, not {ratio}");
        }
        assert!((axis.value(11.5) - (0.013f64 * 0.61).sqrt()).abs() < 1e-15);
        for nothing in [0.013, 1e-3, f64::MIN_POSITIVE, 0.0, -0.0, -0.013, -1.0] {
            assert_eq!(axis.number(nothing), 0.0, "{nothing}");
        }
    }
}
