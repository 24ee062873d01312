//! What of a height field is in sight and in the light at once.

use super::field::{transpose, Field};
use super::histogram::Histogram;
use super::sight::{nodes, Node};
use std::f64::consts::SQRT_2;

/// Visibility parameters of views and lights: deviation of slopes 0.7 at 50, 70, 80 and 85 degrees from the normal.
pub const PARAMETERS: [f64; 4] = [0.847_602, 0.367_656, 0.178_113, 0.088_373];

/// Angles between the azimuths of view and light, in degrees.
pub const AZIMUTHS: [u32; 3] = [0, 90, 180];

/// Lights: every parameter at every azimuth.
pub const LIGHTS: usize = PARAMETERS.len() * AZIMUTHS.len();

/// What is in sight from one direction, and what of that is lit from each light.
#[derive(Clone, Debug, Default)]
pub struct Lit {
    /// The projected area in sight of what faces each light: the rest is dark without any shadow.
    pub facing: [f64; LIGHTS],
    /// The heights in sight and lit, by the area that the viewer sees.
    pub lit: [Histogram; LIGHTS],
}

/// Sums over nodes of fields, for every view; all heights, to take off what chance made of them.
#[derive(Clone, Debug, Default)]
pub struct Lighting {
    /// One a view, in the order of [`PARAMETERS`].
    pub views: [Lit; 4],
    /// All heights.
    pub all: Histogram,
}

impl Lighting {
    /// A field seen from the far end of its rows.
    pub fn along_rows(field: &Field) -> Self {
        let lights = lights(field);
        let mut lighting = Self::default();
        field.heights.iter().for_each(|height| lighting.all.add_height(*height, 1.0));
        for (index, (parameter, lit)) in PARAMETERS.into_iter().zip(&mut lighting.views).enumerate() {
            let ray = SQRT_2 * parameter * field.slope_deviation();
            let slopes = field.rows().flat_map(slopes);
            for ((height, slope), mask) in field.heights.iter().zip(slopes).zip(&lights) {
                // The view is the light of its own parameter at its own azimuth.
                let area = (ray - slope).max(0.0);
                if mask.lit & (1 << index) == 0 || area == 0.0 {
                    continue;
                }
                for light in 0..LIGHTS {
                    let bit = 1 << light;
                    if mask.facing & bit != 0 {
                        lit.facing[light] += area;
                    }
                    if mask.lit & bit != 0 {
                        lit.lit[light].add_height(*height, area);
                    }
                }
            }
        }
        lighting
    }

    /// Adds the sums of another field.
    pub fn add(&mut self, other: &Self) {
        self.all.add(&other.all);
        for (view, other) in self.views.iter_mut().zip(&other.views) {
            view.facing.iter_mut().zip(other.facing).for_each(|(facing, other)| *facing += other);
            view.lit.iter_mut().zip(&other.lit).for_each(|(lit, other)| lit.add(other));
        }
    }
}

/// A bit for each light, azimuth by azimuth.
#[derive(Clone, Copy, Default)]
struct Mask {
    facing: u16,
    lit: u16,
}

/// Which lights every node faces, and which reach it.
fn lights(field: &Field) -> Vec<Mask> {
    let turned = field.turned();
    let mut masks = vec![Mask::default(); field.heights.len()];
    for (azimuth, degrees) in AZIMUTHS.into_iter().enumerate() {
        for (index, parameter) in PARAMETERS.into_iter().enumerate() {
            let mut nodes = nodes(if degrees == 90 { &turned } else { field }, parameter, degrees == 180);
            if degrees == 90 {
                transpose(&mut nodes, field.size);
            }
            let bit = azimuth * PARAMETERS.len() + index;
            for (mask, node) in masks.iter_mut().zip(nodes) {
                mask.facing |= u16::from(node != Node::Averted) << bit;
                mask.lit |= u16::from(node == Node::Visible) << bit;
            }
        }
    }
    masks
}

/// The slopes at the nodes of a row, from their neighbors on both sides.
fn slopes(row: &[f64]) -> impl Iterator<Item = f64> + '_ {
    let count = row.len();
    (0..count).map(move |index| 0.5 * (row[(index + 1) % count] - row[(index + count - 1) % count]))
}
