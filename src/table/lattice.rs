//! The nodes of a table: filled in parallel, read as a sampler does, and judged between.

use super::grid::{Axis, Spacing};
use super::threads::rows;
use super::{Format, Level, Sampling, Table};

/// The third axis of a flat table.
pub(super) const FLAT: Axis = Axis { low: 0.0, high: 1.0, count: 1, spacing: Spacing::Linear };

/// Parts of the judged columns, so that those beyond the axis are judged too.
const EVEN: u32 = 64;

/// Deviations of the narrowest line beside a hard edge where the edge is over.
const BESIDE: f64 = 5.0;

/// Lines next to each other of which the worst place stands for all.
const GROUP: usize = 8;

/// The axes of a table's columns, rows and slices.
#[derive(Clone, Copy)]
pub(super) struct Lattice(pub [Axis; 3]);

/// Where a table is judged: columns from `low` to `high`, those beyond the axis reading the border, rows from `least`
/// on, at one place of the third axis.
#[derive(Clone, Copy)]
pub(super) struct Judged {
    pub low: f64,
    pub high: f64,
    pub least: f64,
    pub third: f64,
}

impl Lattice {
    /// The colors at the nodes, as halves: of a slice's number and a row's value those of columns' values.
    pub(super) fn texels<C: Fn(f64) -> [f64; 4]>(self, color: impl Fn(usize, f64) -> C + Sync) -> Vec<f32> {
        let Self([columns, lines, slices]) = self;
        let slice = |slice: usize| {
            rows(lines.count, |row| {
                let color = color(slice, lines.value(row as f64));
                let texel = |column: usize| color(columns.value(column as f64)).map(half_rounded);
                (0..columns.count).flat_map(texel).collect()
            })
        };
        (0..slices.count).flat_map(slice).collect()
    }

    /// Texels slice by slice, of those of each row in all slices.
    pub(super) fn sliced(self, lines: &[f32]) -> Vec<f32> {
        let [width, height, depth] = self.0.map(|axis| axis.count);
        let starts = |slice: usize| (0..height).map(move |row| 4 * width * (row * depth + slice));
        (0..depth).flat_map(starts).flat_map(|at| lines[at..at + 4 * width].iter().copied()).collect()
    }

    /// The table without texels, which errs by at least so much.
    pub(super) fn unbaked(self, name: &str, error: f32) -> Table {
        self.table(name, Vec::new(), error)
    }

    /// The table of the texels.
    pub(super) fn table(self, name: &str, texels: Vec<f32>, error: f32) -> Table {
        let [width, height, depth] = self.0.map(|axis| axis.count as u32);
        Table {
            name: name.to_owned(),
            format: Format::Rgba16Float,
            sampling: Sampling::Filtered,
            levels: vec![Level { width, height, depth, texels }],
            error,
        }
    }

    /// The largest difference between a filtered read and the color: on the first and the last row, between rows
    /// and on the least, over the centers of all cells of columns, where the color `bends` and beside, and even
    /// places. Of each line, `near` finds the worst place of some next to each other, on which `truth` has the last
    /// word.
    pub(super) fn error<N: Fn(f64) -> [f64; 4]>(
        self,
        texels: &[f32],
        bends: &[f64],
        judged: Judged,
        near: impl Fn(f64) -> N + Sync,
        truth: impl Fn(f64, f64) -> [f64; 4] + Sync,
    ) -> f32 {
        let (Self([columns, deviations, _]), Judged { low, high, least, third }) = (self, judged);
        let centers = (0..columns.count - 1).map(|column| columns.value(column as f64 + 0.5));
        let even = (0..=EVEN).map(|index| low + (high - low) * f64::from(index) / f64::from(EVEN));
        // At a hard edge the color is half way between those of its sides, one of which is farther from what is read.
        let bends = bends.iter().flat_map(|bend| [-BESIDE, 0.0, BESIDE].map(|beside| bend + beside * least));
        let places: Vec<f64> = centers.chain(bends).chain(even).filter(|at| (low..=high).contains(at)).collect();
        let between = (0..deviations.count - 1).map(|row| deviations.value(row as f64 + 0.5));
        let ends = [least, deviations.value(0.0), deviations.high];
        let lines: Vec<f64> = between.chain(ends).filter(|&line| line >= least).collect();
        let error = |at: f64, line: f64, truth: [f64; 4]| {
            let read = self.filtered(texels, [at, line, third]);
            read.iter().zip(truth).map(|(read, truth)| (read - truth).abs()).fold(0.0, f64::max)
        };
        let groups: Vec<&[f64]> = lines.chunks(GROUP).collect();
        let worst = |group: usize| {
            let mut worst = (0.0, low, least);
            for &line in groups[group] {
                let near = near(line);
                let errors = places.iter().map(|&at| (error(at, line, near(at)), at, line));
                worst = errors.fold(worst, |one, next| if next.0 > one.0 { next } else { one });
            }
            let (_, at, line) = worst;
            vec![error(at, line, truth(at, line)) as f32]
        };
        rows(groups.len(), worst).into_iter().fold(0.0, f32::max)
    }

    /// What a filtering sampler returns at a column's, a row's and a slice's value.
    pub(super) fn filtered(self, texels: &[f32], at: [f64; 3]) -> [f64; 4] {
        let numbers = [0, 1, 2].map(|axis| self.0[axis].number(at[axis]));
        let mut sum = [0.0; 4];
        for corner in 0..8 {
            let (mut weight, mut index) = (1.0, 0);
            for axis in (0..3).rev() {
                let far = (corner >> axis) & 1;
                let fraction = numbers[axis].fract();
                weight *= if far == 1 { fraction } else { 1.0 - fraction };
                index = index * self.0[axis].count + (numbers[axis] as usize + far).min(self.0[axis].count - 1);
            }
            if weight == 0.0 {
                continue;
            }
            for (channel, total) in sum.iter_mut().enumerate() {
                *total += weight * f64::from(texels[4 * index + channel]);
            }
        }
        sum
    }
}

/// The value as a half stores it.
pub(super) fn half_rounded(value: f64) -> f32 {
    if !(value.abs() < LARGEST) {
        return half::f16::from_f64(value).to_f32();
    }
    // Next to a number 2⁴² times as large there is no room for more than the ten bits behind a half's first; subnormal
    // halves are as far apart as the smallest normal ones.
    let exponent = (value.to_bits() >> 52 & 0x7ff).max(1023 - 14);
    let large = f64::from_bits((exponent + 42) << 52).copysign(value);
    ((value + large) - large) as f32
}

/// The largest half.
const LARGEST: f64 = 65504.0;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_become_the_nearest_half() {
        let half = |bits: u16| half::f16::from_bits(bits).to_f32();
        for bits in 0..0x7bff {
            let [low, high] = [half(bits), half(bits + 1)];
            let middle = 0.5 * (f64::from(low) + f64::from(high));
            let even = if bits % 2 == 0 { low } else { high };
            for (value, nearest) in
                [(low.into(), low), (middle.next_down(), low), (middle, even), (middle.next_up(), high)]
            {
                assert_eq!(half_rounded(value), nearest, "{value:e}");
                assert_eq!(half_rounded(-value), -nearest, "{value:e}");
            }
        }
        assert!(half_rounded(f64::NAN).is_nan());
        assert_eq!(
            [65504.0, 65519.0, 65520.0, -1e6].map(half_rounded),
            [65504.0, 65504.0, f32::INFINITY, f32::NEG_INFINITY]
        );
    }
}
