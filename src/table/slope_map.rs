//! Tables of a map's means over round normal distributions of slopes: baked exactly, because the mean of a product is
//! the product of the means along both components, and judged by quadrature of the map.
//!
//! Reading between nodes is a mean over them: it widens what is read. Nodes are over distributions that are narrower by
//! as much as reads widen them, which leaves half of the largest error and less than that of a typical one.

use std::ops::{Add, Mul, Sub};

use super::grid::Axis;
use super::hats::{of_colors, of_rows, Hats, Weights};
use super::lattice::{half_rounded, Lattice};
use super::threads::{each, rows};
use super::{Format, Table};
use crate::reference::slope_map::Bilinear;

/// A map, the axes of its table, and what the table is judged over.
#[derive(Clone, Copy)]
pub(crate) struct Plan<'a> {
    /// The map.
    pub map: &'a Bilinear,
    /// The columns and the rows: components of the mean slope.
    pub slopes: Axis,
    /// The slices: deviations of a component.
    pub deviations: Axis,
    /// The largest component of a mean slope that occurs; those beyond the axis read the border.
    pub farthest: f64,
    /// The deviation above which the colors change little from cell to cell.
    pub smooth: f64,
    /// How texels are stored.
    pub stored: Stored,
}

/// How the colors of a texel are stored.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Stored {
    /// As four halves.
    Halves,
    /// Three channels as parts of the way from a lowest to a highest value, in ten bits each: half of the bytes. They
    /// err by a 2046th of the way. The fourth is constant.
    Parts { low: [f32; 4], high: [f32; 4] },
}

/// The steps of ten bits.
const STEPS: f32 = 1023.0;

impl Stored {
    /// What is stored of a channel.
    fn texel(self, value: f32, channel: usize) -> f32 {
        match self {
            Self::Halves => half_rounded(value.into()),
            Self::Parts { low, high } if low[channel] < high[channel] => {
                let part = (value - low[channel]) / (high[channel] - low[channel]);
                f32::from((part * STEPS + 0.5).min(STEPS) as u16) / STEPS
            }
            Self::Parts { .. } => 0.0,
        }
    }

    /// The color that stands for what is read.
    fn color<T: Copy + From<f32> + Add<Output = T> + Sub<Output = T> + Mul<Output = T>>(self, read: [T; 4]) -> [T; 4] {
        match self {
            Self::Halves => read,
            Self::Parts { low, high } => std::array::from_fn(|channel| {
                let [low, high] = [low, high].map(|end| T::from(end[channel]));
                low + (high - low) * read[channel]
            }),
        }
    }

    fn format(self) -> Format {
        match self {
            Self::Halves => Format::Rgba16Float,
            Self::Parts { .. } => Format::Rgb10a2Unorm,
        }
    }
}

/// A table, and how far it is from the map's means at each deviation where that was measured.
pub(crate) struct Baked {
    /// The table, with its error over all deviations.
    pub table: Table,
    errors: Vec<(f64, f32)>,
}

impl Baked {
    /// The largest error from a deviation on.
    pub(crate) fn error(&self, from: f64) -> f32 {
        // Those just below stand for what lies between.
        let next = self.errors.iter().map(|error| error.0).filter(|&at| at <= from).fold(0.0, f64::max);
        self.errors.iter().filter(|error| error.0 >= next).map(|error| error.1).fold(0.0, f32::max)
    }
}

impl Plan<'_> {
    /// The table, and how far it is from the map's means between its nodes.
    pub(crate) fn table(self, name: &str) -> Baked {
        let sheet = Sheet::new(self);
        let nodes: Vec<f64> = (0..self.slopes.count).map(|node| self.slopes.value(node as f64)).collect();
        let widened: Vec<f64> = (0..self.slopes.count).map(|node| self.slopes.widening(node)).collect();
        let mut texels = vec![0.0; 4 * nodes.len() * nodes.len() * self.deviations.count];
        each(texels.chunks_exact_mut(4 * nodes.len() * nodes.len()), |slice, texels| {
            let variance = self.deviations.value(slice as f64).powi(2) - self.deviations.widening(slice);
            let sums = sheet.hats.narrowed(&nodes, variance, &widened);
            sheet.means([&sums, &sums], |row, column, color| {
                let texel = &mut texels[4 * (row * nodes.len() + column)..][..4];
                for (channel, (texel, value)) in texel.iter_mut().zip(color).enumerate() {
                    *texel = self.stored.texel(value, channel);
                }
            });
        });
        let errors = self.errors(&sheet, &texels);
        let lattice = Lattice([self.slopes, self.slopes, self.deviations]);
        let table = lattice.table(name, texels, errors.iter().map(|error| error.1).fold(0.0, f32::max));
        Baked { table: Table { format: self.stored.format(), ..table }, errors }
    }

    /// The largest difference between a filtered read and the map's mean at each deviation; the map itself has the last
    /// word on the largest of all, and on that of the deviations above which colors are smooth.
    fn errors(self, sheet: &Sheet<'_>, texels: &[f32]) -> Vec<(f64, f32)> {
        let halves = 2 * self.deviations.count - 1;
        let deviation = |half: usize| self.deviations.value(0.5 * half as f64);
        let places = rows(halves, |half| self.worst(sheet, texels, deviation(half)).to_vec());
        let mut errors: Vec<(f64, f32)> = (0..halves).map(|half| (deviation(half), places[3 * half])).collect();
        for from in [0.0, self.smooth] {
            let counted = errors.iter().enumerate().filter(|(_, error)| error.0 >= from);
            let Some((half, _)) = counted.max_by(|one, other| one.1 .1.total_cmp(&other.1 .1)) else { continue };
            let (deviation, place) = (deviation(half), [1, 2].map(|axis| f64::from(places[3 * half + axis])));
            let lattice = Lattice([self.slopes, self.slopes, self.deviations]);
            let read = self.stored.color(lattice.filtered(texels, [place[0], place[1], deviation]));
            let truth = self.map.mean(place, [deviation * deviation, 0.0, deviation * deviation]);
            errors[half].1 =
                read.iter().zip(truth).map(|(read, truth)| (read - truth).abs() as f32).fold(0.0, f32::max);
        }
        errors
    }

    /// The largest difference at a deviation and where it is: at the centers of cells, beside them on the lines of
    /// nodes, on nodes, and beyond the axis.
    fn worst(self, sheet: &Sheet<'_>, texels: &[f32], deviation: f64) -> [f32; 3] {
        let asked = |slope: &f64| slope.abs() <= self.farthest;
        let half = |half: usize| self.slopes.value(0.5 * half as f64);
        let beyond = [-self.farthest, self.farthest];
        // What is blurred over cells changes little from one to the next.
        let [every, other] = if deviation < self.smooth { [1, 1] } else { [3, 2] };
        let columns = (0..2 * self.slopes.count - 1).step_by(every).map(half);
        let centers = (1..self.slopes.count).step_by(other).map(|cell| half(2 * cell - 1));
        let centers = centers.chain((0..self.slopes.count).step_by(4).map(|node| half(2 * node)));
        let columns: Vec<f64> = columns.chain(beyond).filter(asked).collect();
        let centers: Vec<f64> = centers.chain(beyond).filter(asked).collect();
        let size = self.slopes.count;
        let between = |at: f64, last: usize| {
            let low = (at as usize).min(last.saturating_sub(1));
            Weights { first: low, weights: vec![1.0 - (at - low as f64) as f32, (at - low as f64) as f32] }
        };
        let [along, down] = [&columns, &centers]
            .map(|places| places.iter().map(|&at| between(self.slopes.number(at), size - 1)).collect::<Vec<_>>());
        // What a sampler reads: between two slices, then between two rows of them, then between two columns.
        let slices = [between(self.deviations.number(deviation), self.deviations.count - 1)];
        let lines = of_rows(&down, &of_rows(&slices, texels, 4 * size * size), 4 * size);
        let mut read = Vec::with_capacity(columns.len() * centers.len());
        of_colors(&along, &lines, 4 * size, |_, _, color| read.push(self.stored.color(color)));
        let sums = [&columns, &centers].map(|places| sheet.hats.all(places, deviation));
        let mut worst = [0.0; 3];
        sheet.means([&sums[0], &sums[1]], |row, column, near| {
            let read = read[row * columns.len() + column];
            let errors: [f32; 4] = std::array::from_fn(|channel| (read[channel] - near[channel]).abs());
            // Few are worse than all before.
            if errors.iter().any(|&error| error > worst[0]) {
                worst = [errors.into_iter().fold(0.0, f32::max), columns[column] as f32, centers[row] as f32];
            }
        });
        worst
    }
}

/// A map's colors in a row, and what weighs its nodes.
struct Sheet<'a> {
    hats: Hats<'a>,
    colors: Vec<f32>,
    length: usize,
}

impl<'a> Sheet<'a> {
    fn new(plan: Plan<'a>) -> Self {
        let colors = plan.map.colors.iter().flatten().map(|&channel| channel as f32).collect();
        Self { hats: Hats(&plan.map.nodes), colors, length: 4 * plan.map.nodes.len() }
    }

    /// The means of the map by weights along columns and rows: row and column of each, and its color.
    fn means(&self, [columns, rows]: [&[Weights]; 2], color: impl FnMut(usize, usize, [f32; 4])) {
        of_colors(columns, &of_rows(rows, &self.colors, self.length), self.length, color);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::table::grid::Spacing;

    /// Sums of f32 are as near to the integral as 1e-6 of the largest color, a 200th of what halves leave.
    #[test]
    fn means_are_those_of_the_reference() {
        // Uneven nodes, few and many, and colors without symmetry.
        let uneven = |count: usize| (0..count).map(move |node| 0.1 * node as f64 + (node as f64).sin() * 0.04 - 2.0);
        for nodes in [vec![-2.0, -0.5, 0.1, 0.3, 4.0], uneven(40).collect::<Vec<f64>>()] {
            let color = |at: usize| [0, 1, 2, 3].map(|channel| f64::from(((7 * at + 5 * channel) % 11) as f32 / 11.0));
            let map = Bilinear { colors: (0..nodes.len() * nodes.len()).map(color).collect(), nodes };
            let axis = Axis { low: 0.0, high: 1.0, count: 2, spacing: Spacing::Linear };
            let sheet = Sheet::new(Plan {
                map: &map,
                slopes: axis,
                deviations: axis,
                farthest: 1.0,
                smooth: 0.0,
                stored: Stored::Halves,
            });
            let places = [([0.2, -0.3], 0.4), ([-1.9, 3.7], 0.05), ([8.0, -6.0], 1.5), ([0.1, 0.2], 0.0)];
            for (place, deviation) in places.into_iter().chain([([0.11, 0.2], 1e-4), ([0.7, -1.2], 2.1)]) {
                let truth = map.mean(place, [deviation * deviation, 0.0, deviation * deviation]);
                let [x, y] = [0, 1].map(|axis| sheet.hats.all(&place[axis..=axis], deviation));
                sheet.means([&x, &y], |_, _, found| {
                    let error = truth.iter().zip(found).map(|(truth, found)| (truth - f64::from(found)).abs());
                    let worst = error.fold(0.0, f64::max);
                    assert!(worst < 1e-6, "{place:?}, {deviation}: {found:?} {truth:?}");
                });
            }
        }
    }
}
