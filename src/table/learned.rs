//! What the values of footprints on an image are, by their mean and deviation: the mean color that is not that of a
//! normal distribution.

use super::grid::{Axis, Spacing};
use crate::reference::texture::PiecewiseLinear;
use crate::Error;

/// The farthest value from 0.
const LARGEST: f32 = 65504.0;

/// Texels a side, at least and at most.
const SIDES: std::ops::RangeInclusive<u32> = 4..=4096;

/// Nodes of means and of deviations.
const NODES: [usize; 2] = [64, 16];

/// Footprints a side of the image that a size of footprints is learned from, at most.
const FOOTPRINTS: usize = 128;

/// How many footprints the normal distribution counts for at each node: those of few are not trusted.
const TRUST: f64 = 8.0;

/// The part of the values' range beyond them where what is known of them ends, one over.
const BEYOND: f64 = 16.0;

/// An image whose footprints say what color a footprint of a mean and a deviation has.
///
/// Learned from footprints of deviations from 0.7 texels up to about a tenth of the image, each twice as wide as the
/// one before: the mean over them of what the color has more than that over a normal distribution, on a grid of 64
/// means by 16 deviations. Where the image has few such footprints or none, and for means a sixteenth of its values'
/// range beyond them, the normal distribution stands.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Learned {
    width: u32,
    height: u32,
    values: Vec<f32>,
}

impl Learned {
    /// What an image teaches that is given row by row.
    ///
    /// Of a noise that may be a picture of any part of it. Beyond its edges the image is mirrored.
    ///
    /// # Errors
    /// [`Error::Size`] where a side is below 4 or above 4096 or the number of values is not width times height;
    /// [`Error::Value`] for a value that is no number or beyond ±65504, and for values that all are within 0.002.
    pub fn from_image(width: u32, height: u32, values: &[f32]) -> Result<Self, Error> {
        let learned = Self { width, height, values: values.to_vec() };
        learned.check().map(|()| learned)
    }

    /// Whether the image can be learned from.
    ///
    /// # Errors
    /// As [`Self::from_image`].
    pub(crate) fn check(&self) -> Result<(), Error> {
        for (side, size) in [("width", self.width), ("height", self.height)] {
            if !SIDES.contains(&size) {
                let (what, allowed) = (format!("the {side} of the image to learn from"), "4 to 4096".to_owned());
                return Err(Error::Size { what, count: size as usize, allowed });
            }
        }
        let (count, texels) = (self.values.len(), self.width as usize * self.height as usize);
        if count != texels {
            let what = "the number of values of the image to learn from".to_owned();
            return Err(Error::Size { what, count, allowed: format!("{texels}, width times height") });
        }
        if let Some(value) = self.values.iter().find(|value| !(value.abs() <= LARGEST)) {
            return Err(Error::value("a value of the image to learn from", *value, "a number from -65504 to 65504"));
        }
        let [low, high] = self.ends();
        if high - low < 2e-3 {
            let what = "the largest value of the image to learn from";
            return Err(Error::value(what, high, format!("at least 0.002 above the smallest, {low}")));
        }
        Ok(())
    }

    /// The smallest and the largest value.
    pub(crate) fn ends(&self) -> [f32; 2] {
        let low = self.values.iter().copied().fold(f32::INFINITY, f32::min);
        [low, self.values.iter().copied().fold(f32::NEG_INFINITY, f32::max)]
    }

    /// Texels a row, and rows.
    pub(crate) fn size(&self) -> [u32; 2] {
        [self.width, self.height]
    }

    /// What a map's mean over footprints has more than `normal` says, by mean and deviation.
    pub(super) fn lesson(&self, map: &PiecewiseLinear, normal: impl Fn(f64, f64) -> [f64; 4]) -> Lesson {
        let [low, high] = self.ends().map(f64::from);
        let mut lesson = Lesson::new(low, high);
        let middle = 0.5 * (low + high);
        let point = |value: &f32| {
            let [a, b, c, d] = map.value((*value).into());
            let from = f64::from(*value) - middle;
            [from, from * from, a, b, c, d]
        };
        let mut means: Vec<[f64; 6]> = self.values.iter().map(point).collect();
        let [width, height] = [self.width, self.height].map(|side| side as usize);
        for level in 0.. {
            let step = 1usize << level;
            // Four more of this size are a deviation of an eighth of the image.
            if 5 * step > width.min(height) && level > 0 {
                break;
            }
            means = blurred(&blurred(&means, [width, height], [step, 0]), [width, height], [0, step]);
            let stride = (step / 2).max(width.max(height).div_ceil(FOOTPRINTS)).max(1);
            for (x, y) in (0..height).step_by(stride).flat_map(|y| (0..width).step_by(stride).map(move |x| (x, y))) {
                let [mean, square, color @ ..] = means[y * width + x];
                let deviation = (square - mean * mean).max(0.0).sqrt();
                let expected = normal(mean + middle, deviation);
                lesson.add(mean + middle, deviation, std::array::from_fn(|c| color[c] - expected[c]));
            }
        }
        lesson.close();
        lesson
    }
}

/// Means over three points along one axis, weighted 1, 2 and 1: a deviation of 0.7 steps.
fn blurred(means: &[[f64; 6]], [width, height]: [usize; 2], [across, down]: [usize; 2]) -> Vec<[f64; 6]> {
    let mirrored = |at: usize, step: usize, size: usize| {
        let back = if at >= step { at - step } else { step - at - 1 };
        let ahead = if at + step < size { at + step } else { 2 * size - 1 - at - step };
        [back.min(size - 1), ahead.min(size - 1)]
    };
    let mean = |index: usize| {
        let (x, y) = (index % width, index / width);
        let ([left, right], [above, below]) = (mirrored(x, across, width), mirrored(y, down, height));
        let sides =
            if across > 0 { [y * width + left, y * width + right] } else { [above * width + x, below * width + x] };
        std::array::from_fn(|number| {
            0.5 * means[index][number] + 0.25 * (means[sides[0]][number] + means[sides[1]][number])
        })
    };
    (0..means.len()).map(mean).collect()
}

/// What is to be added to the color over a normal distribution, by mean and deviation.
pub(super) struct Lesson {
    axes: [Axis; 2],
    /// Sums of weighted colors, or in the end their means.
    nodes: Vec<[f64; 4]>,
    weights: Vec<f64>,
}

impl Lesson {
    fn new(low: f64, high: f64) -> Self {
        let means = Axis { low, high, count: NODES[0], spacing: Spacing::Linear };
        let deviations = Axis { low: 0.0, high: 0.5 * (high - low), count: NODES[1], spacing: Spacing::CubeRoot };
        let count = NODES[0] * NODES[1];
        Self { axes: [means, deviations], nodes: vec![[0.0; 4]; count], weights: vec![0.0; count] }
    }

    /// The four nodes around a mean and a deviation, with their weights in bilinear interpolation.
    fn around(&self, mean: f64, deviation: f64) -> [(usize, f64); 4] {
        let place = |value: f64, axis: Axis| {
            let number = axis.number(value);
            let node = (number as usize).min(axis.count - 2);
            (node, number - node as f64)
        };
        let ((x, along), (y, up)) = (place(mean, self.axes[0]), place(deviation, self.axes[1]));
        let node = y * NODES[0] + x;
        let weights = [(1.0 - along) * (1.0 - up), along * (1.0 - up), (1.0 - along) * up, along * up];
        [(node, weights[0]), (node + 1, weights[1]), (node + NODES[0], weights[2]), (node + NODES[0] + 1, weights[3])]
    }

    fn add(&mut self, mean: f64, deviation: f64, color: [f64; 4]) {
        for (node, weight) in self.around(mean, deviation) {
            self.weights[node] += weight;
            self.nodes[node].iter_mut().zip(color).for_each(|(sum, channel)| *sum += weight * channel);
        }
    }

    fn close(&mut self) {
        for (node, weight) in self.nodes.iter_mut().zip(&self.weights) {
            *node = node.map(|sum| sum / (weight + TRUST));
        }
    }

    /// What is to be added at a mean and a deviation: at a deviation of 0 and far from all values nothing.
    pub(super) fn at(&self, mean: f64, deviation: f64) -> [f64; 4] {
        let Axis { low, high, .. } = self.axes[0];
        let beyond = (low - mean).max(mean - high).max(0.0);
        let known = (1.0 - BEYOND * beyond / (high - low)).max(0.0);
        let mut sum = [0.0; 4];
        for (node, weight) in self.around(mean, deviation).into_iter().filter(|(node, _)| *node >= NODES[0]) {
            sum.iter_mut().zip(self.nodes[node]).for_each(|(sum, channel)| *sum += known * weight * channel);
        }
        sum
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn refuses_images_that_teach_nothing() {
        for (width, height, values) in [(2, 8, vec![0.5; 16]), (4, 4, vec![0.0; 15]), (5000, 4, vec![0.0; 20_000])] {
            let refused = Learned::from_image(width, height, &values);
            assert!(matches!(refused, Err(Error::Size { .. })), "{refused:?}");
        }
        for value in [0.25, f32::NAN, f32::INFINITY, 70_000.0, 0.2501] {
            let mut values = vec![0.25; 16];
            values[7] = value;
            assert!(matches!(Learned::from_image(4, 4, &values), Err(Error::Value { .. })), "{value}");
        }
    }

    /// Of an image of two values in large regions every footprint's color is a mixture of two.
    #[test]
    fn two_values_are_learned() {
        let values: Vec<f32> =
            (0..64 * 64).map(|at| if (at / 16 + at / 64 / 16) % 2 == 0 { 0.2 } else { 0.8 }).collect();
        let image = Learned::from_image(64, 64, &values).unwrap();
        let step = |value: f64| [0.0, 1.0, 0.5, 0.0].map(|end| if value < 0.5 { end } else { 0.3 });
        let knots = vec![(0.5, step(0.2), step(0.8))];
        let map = PiecewiseLinear { knots };
        let normal = |mean: f64, deviation: f64| crate::reference::texture::mean(&map, mean, deviation.max(1e-6));
        let lesson = image.lesson(&map, normal);
        for share in [0.3, 0.5, 0.7] {
            let (mean, deviation) = (0.2 + 0.6 * share, 0.6 * f64::sqrt(share * (1.0 - share)));
            let (taught, before) = (lesson.at(mean, deviation), normal(mean, deviation));
            let error = |with: f64| (before[1] + with * taught[1] - (1.0 - share) - share * 0.3).abs();
            assert!(error(1.0) < 0.02 + 0.2 * error(0.0), "{share}: {} {}", error(1.0), error(0.0));
        }
        assert_eq!(lesson.at(0.5, 0.0), [0.0; 4]);
    }
}
