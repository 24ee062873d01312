//! The ground: real elevations, mirrored so that they repeat, as rays hit them and as filters read them.

use super::Error;
use crate::imaging::relief::Relief;
use prefilter::gpu::{Address, Device, Texture};
use prefilter::table::Format;
use prefilter::{Edge, MomentMipmap, SlopeMipmap};

const DEM: &[u8] = include_bytes!("../../../examples/data/jacksboro_dem.png");

/// Texels taken of the elevations, and the first of them: the mountains in the west. Mirrored, both sides halve evenly
/// six times.
const TAKEN: [usize; 2] = [288, 320];
const FIRST: [usize; 2] = [0, 24];

/// Texels of a period.
pub const SIDES: [usize; 2] = [2 * TAKEN[0], 2 * TAKEN[1]];

/// Meters from texel to texel, as the source of the elevations states.
pub const SPACING: [f64; 2] = [74.0, 93.0];

/// Heights are so many times the real ones: hills of 30 degrees become cliffs of 49.
const EXAGGERATION: f64 = 2.0;

/// Heights in meters about their mean over a period, row by row.
#[derive(Clone, Debug, PartialEq)]
pub struct Ground {
    /// The heights.
    pub heights: Vec<f32>,
}

impl Ground {
    /// The elevations around the Jacksboro fault.
    ///
    /// # Errors
    /// Damaged data.
    pub fn new() -> Result<Self, Error> {
        let gray = image::load_from_memory_with_format(DEM, image::ImageFormat::Png)?.into_luma16();
        let wide = gray.width() as usize;
        let elevations = gray.into_raw();
        let folded = |axis: usize, at: usize| FIRST[axis] + at.min(SIDES[axis] - 1 - at);
        let node = |node: usize| elevations[folded(1, node / SIDES[0]) * wide + folded(0, node % SIDES[0])];
        let nodes: Vec<f64> = (0..SIDES[0] * SIDES[1]).map(|at| f64::from(node(at))).collect();
        let mean = nodes.iter().sum::<f64>() / nodes.len() as f64;
        Ok(Self { heights: nodes.iter().map(|height| (EXAGGERATION * (height - mean)) as f32).collect() })
    }

    /// What rays hit: the bilinear surface of the heights.
    pub fn relief(&self) -> Relief {
        Relief::new(SIDES, self.heights.clone(), SPACING)
    }

    /// What filters read: the pyramids of heights, in meters, and of slopes, in meters a texel.
    ///
    /// # Errors
    /// Those of the device.
    pub fn textures(&self, device: &Device) -> Result<[Texture; 3], Error> {
        let [wide, deep] = SIDES.map(|side| side as u32);
        let heights = MomentMipmap::new(wide, deep, &self.heights, Edge::Repeat)?;
        let slopes = SlopeMipmap::from_heights(wide, deep, &self.heights, 1.0, Edge::Repeat)?;
        let [slopes, cross] = slopes.tables("slopes", Format::Rgba32Float)?;
        let upload = |table| device.upload(table, Address::Repeat);
        Ok([upload(&heights.table("heights", Format::Rg32Float)?)?, upload(&slopes)?, upload(&cross)?])
    }

    /// Deviation of the heights, and the covariance of the slopes (xx, yy), over a period.
    ///
    /// # Errors
    /// None: there are heights.
    pub fn whole(&self) -> Result<(f64, [f64; 2]), Error> {
        let [wide, deep] = SIDES.map(|side| side as u32);
        let [_, deviation] = MomentMipmap::new(wide, deep, &self.heights, Edge::Repeat)?.moments();
        let (_, [xx, _, yy]) = SlopeMipmap::from_heights(wide, deep, &self.heights, 1.0, Edge::Repeat)?.moments();
        Ok((deviation.into(), [f64::from(xx) / SPACING[0].powi(2), f64::from(yy) / SPACING[1].powi(2)]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The figures that views and colors are chosen by.
    #[test]
    fn the_ground_has_cliffs() -> Result<(), Error> {
        let ground = Ground::new()?;
        let (deviation, [xx, yy]) = ground.whole()?;
        println!("heights {deviation:.0} m, slopes {:.3} and {:.3}", xx.sqrt(), yy.sqrt());
        assert!((300.0..350.0).contains(&deviation) && (0.1..0.3).contains(&xx) && (0.1..0.3).contains(&yy));
        Ok(())
    }

    /// Real elevations stand at the nodes, and the period is mirrored.
    #[test]
    fn the_relief_is_the_data_mirrored() -> Result<(), Error> {
        let ground = Ground::new()?;
        let relief = ground.relief();
        let at = |column: usize, row: usize| relief.height([column as f64 * SPACING[0], row as f64 * SPACING[1]]);
        for (column, row) in [(5, 9), (200, 31), (287, 319)] {
            let mirrored = at(SIDES[0] - 1 - column, SIDES[1] - 1 - row);
            assert!((at(column, row) - mirrored).abs() < 1e-9, "{column} {row}");
        }
        assert!(ground.heights.iter().map(|&height| f64::from(height)).sum::<f64>().abs() < 1.0);
        Ok(())
    }
}
