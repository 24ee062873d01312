//! What the demo filters: two real height images, each with a color map and a place on the ground.

use super::heights::{Address, Heights};
use super::plane::Plane;
use super::Error;
use crate::maps;
use prefilter::ColorMap;

const DEM: &[u8] = include_bytes!("../../../examples/data/jacksboro_dem.png");
const GRAVEL: &[u8] = include_bytes!("../../../examples/data/gravel.png");

/// A height image, its color map, and how the ground is seen.
#[derive(Clone, Debug)]
pub struct Input {
    /// One word, for files and tables.
    pub name: &'static str,
    /// What it is, for people.
    pub title: &'static str,
    /// The heights.
    pub heights: Heights,
    /// The colors of the heights.
    pub map: ColorMap,
    /// Width of a texel on the ground divided by its height.
    pub aspect: f64,
    /// Texels that a pixel is wide in the lowest row.
    pub density: f64,
}

impl Input {
    /// Elevations around the Jacksboro fault, their range stretched over matplotlib's `terrain` colors, mirrored at the
    /// edges. A texel is 74 m wide and 93 m high.
    ///
    /// Two texels a pixel in the lowest row: filtering is for pictures that are minified. Closer up every method is
    /// nearer to the truth, naive most: at 128x128 one tap has 0.30 of naive's RMS here, 0.33 at one texel a pixel and
    /// 0.35 at half a texel.
    ///
    /// # Errors
    /// Damaged data.
    pub fn terrain() -> Result<Self, Error> {
        Ok(Self {
            name: "terrain",
            title: "elevations around the Jacksboro fault, colored by height",
            heights: Heights::from_png(DEM, true, Address::Mirror)?,
            map: maps::named("terrain").map_err(|error| Error::Map(error.to_string()))?,
            aspect: 74.0 / 93.0,
            density: 2.0,
        })
    }

    /// A photograph of gravel, its brightness cut into moss, stone and lichen with hard edges, repeated.
    ///
    /// # Errors
    /// Damaged data.
    pub fn gravel() -> Result<Self, Error> {
        Ok(Self {
            name: "gravel",
            title: "a photograph of gravel, cut into moss, stone and lichen by brightness",
            heights: Heights::from_png(GRAVEL, false, Address::Repeat)?,
            map: ColorMap::bands([0.02, 0.05, 0.03], [(0.42, [0.20, 0.17, 0.14]), (0.58, [0.80, 0.62, 0.22])])?,
            aspect: 1.0,
            density: 1.0,
        })
    }

    /// Both inputs.
    ///
    /// # Errors
    /// Damaged data.
    pub fn all() -> Result<[Self; 2], Error> {
        Ok([Self::terrain()?, Self::gravel()?])
    }

    /// The ground from just below the horizon down, through a lens with a view of 44 degrees. The texture is turned so
    /// that footprints are aligned with neither of its axes.
    pub fn plane(&self, width: usize, height: usize) -> Plane {
        let first_row = 2.5;
        // A unit of the ground is as wide as that many pixels in the lowest row.
        let unit = first_row + height as f64 - 1.0;
        let texels = [self.density * unit, self.density * unit * self.aspect];
        Plane {
            width,
            height,
            first_row,
            focal: 1.25 * width as f64,
            pan: [0.0, 0.0],
            periods: [texels[0] / self.heights.width as f64, texels[1] / self.heights.height as f64],
            turn: 0.35,
            origin: [0.3, 0.1],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn inputs_fill_their_ranges() -> Result<(), Error> {
        let [terrain, gravel] = Input::all()?;
        assert_eq!((terrain.heights.width, terrain.heights.height), (403, 344));
        assert_eq!((gravel.heights.width, gravel.heights.height), (512, 512));
        let range = |input: &Input| {
            let texels = input.heights.texels.iter();
            texels.fold((1.0f32, 0.0f32), |(low, high), &texel| (low.min(texel), high.max(texel)))
        };
        assert_eq!(range(&terrain), (0.0, 1.0));
        let (low, high) = range(&gravel);
        assert!(low < 0.05 && high > 0.9 && high < 1.0, "{low} {high}");
        assert_eq!((terrain.map.knots().len(), gravel.map.knots().len()), (6, 2));
        Ok(())
    }
}
