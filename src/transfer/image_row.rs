//! Color maps from rows of images.

use super::color_map::ColorMap;
use super::srgb::color_to_linear;
use crate::Error;

impl ColorMap {
    /// The map in a row of an sRGB-encoded image, its texels spread from `low` to `high` as by [`ColorMap::sampled`].
    ///
    /// An image with alpha gives four channels and is premultiplied, for images store alpha straight.
    ///
    /// # Errors
    /// A row outside the image; otherwise as [`ColorMap::sampled`].
    pub fn image_row(image: &image::DynamicImage, row: u32, low: f32, high: f32) -> Result<Self, Error> {
        if row >= image.height() {
            let allowed = format!("a row below the image's height {}", image.height());
            return Err(Error::Size { what: "the row of a color map's image".into(), count: row as usize, allowed });
        }
        let alpha = image.color().has_alpha();
        let line = image.crop_imm(0, row, image.width(), 1).to_rgba32f();
        let texels: Vec<[f32; 4]> = line.pixels().map(|pixel| color_to_linear(pixel.0)).collect();
        if alpha {
            let premultiplied: Vec<_> = texels.iter().map(|&[r, g, b, a]| [r * a, g * a, b * a, a]).collect();
            return Self::sampled(low, high, &premultiplied);
        }
        let opaque: Vec<_> = texels.iter().map(|&[r, g, b, _]| [r, g, b]).collect();
        Self::sampled(low, high, &opaque)
    }
}
