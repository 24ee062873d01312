//! What of a height field is in sight and in the light at once.

use super::field::{transpose, Field};
use super::histogram::Histogram;
use super::sight::{middles, Point};
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

/// Sums over the cells of fields, for every view; all heights, to take off what chance made of them.
#[derive(Clone, Debug, Default)]
pub struct Lighting {
    /// One a view, in the order of [`PARAMETERS`].
    pub views: [Lit; 4],
    /// All heights.
    pub all: Histogram,
}

impl Lighting {
    /// A field seen from the far end of its rows, at the middles of its bilinear cells: there slopes and horizons
    /// along rows and along columns are those of straight segments.
    pub fn along_rows(field: &Field) -> Self {
        let [rows, columns] = [field.between_rows(), field.turned().between_rows()];
        let lights = lights(&rows, &columns);
        // Middles of cells lie closer together than nodes.
        let deviation = (rows.middles().map(|height| height * height).sum::<f64>() / lights.len() as f64).sqrt();
        let heights: Vec<f64> = rows.middles().map(|height| height / deviation).collect();
        let mut lighting = Self::default();
        heights.iter().for_each(|height| lighting.all.add_height(*height, 1.0));
        for (index, (parameter, lit)) in PARAMETERS.into_iter().zip(&mut lighting.views).enumerate() {
            let ray = SQRT_2 * parameter * rows.slope_deviation();
            for ((height, slope), mask) in heights.iter().zip(rows.slopes()).zip(&lights) {
                // The view is the light of its own parameter at its own azimuth.
                if mask.lit & (1 << index) == 0 {
                    continue;
                }
                let area = ray - slope;
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

/// Which lights the middle of every cell faces, and which reach it.
fn lights(rows: &Field, columns: &Field) -> Vec<Mask> {
    let mut masks = vec![Mask::default(); rows.heights.len()];
    for (azimuth, degrees) in AZIMUTHS.into_iter().enumerate() {
        for (index, parameter) in PARAMETERS.into_iter().enumerate() {
            let mut points = middles(if degrees == 90 { columns } else { rows }, parameter, degrees == 180);
            if degrees == 90 {
                transpose(&mut points, rows.size);
            }
            let bit = azimuth * PARAMETERS.len() + index;
            for (mask, point) in masks.iter_mut().zip(points) {
                mask.facing |= u16::from(point != Point::Averted) << bit;
                mask.lit |= u16::from(point == Point::Visible) << bit;
            }
        }
    }
    masks
}
