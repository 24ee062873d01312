//! Maps of slopes from images.

use super::slope_map::SlopeMap;
use super::srgb::color_to_linear;
use crate::Error;

impl SlopeMap {
    /// The map in the sRGB-encoded picture of a lit sphere, as [`SlopeMap::from_normals`] reads it.
    ///
    /// An image with alpha gives four channels and is premultiplied, for images store alpha straight.
    ///
    /// # Errors
    /// As [`SlopeMap::from_normals`].
    pub fn image_normals(size: usize, image: &image::DynamicImage) -> Result<Self, Error> {
        let (width, height) = (image.width() as usize, image.height() as usize);
        let pixels = image.to_rgba32f();
        let linear = pixels.pixels().map(|pixel| color_to_linear(pixel.0));
        if image.color().has_alpha() {
            let premultiplied: Vec<_> = linear.map(|[r, g, b, a]| [r * a, g * a, b * a, a]).collect();
            return Self::from_normals(size, width, height, &premultiplied);
        }
        let opaque: Vec<_> = linear.map(|[r, g, b, _]| [r, g, b]).collect();
        Self::from_normals(size, width, height, &opaque)
    }
}
