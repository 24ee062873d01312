//! Maps of slopes: the model of a pyramid's reads, by the moments of single components.
//!
//! A covariance is known from variances alone: of x, of y and of their sum, each the component of the slopes along a
//! vector, which is an image of its own.

use super::moments::Image;

/// A map of slopes as the images of x, of y and of x + y.
#[derive(Clone, Debug, PartialEq)]
pub struct Slopes {
    components: [Component; 3],
}

/// An image with the moments of its texels.
#[derive(Clone, Debug, PartialEq)]
struct Component {
    image: Image,
    texels: Vec<[f64; 2]>,
}

impl Slopes {
    /// The map whose slopes' x and y are two images of one size.
    pub fn new(x: Image, y: Image) -> Self {
        let sum = x.values.iter().zip(&y.values).map(|(x, y)| x + y).collect();
        let both = Image { values: sum, ..x.clone() };
        let components = [x, y, both].map(|image| {
            let places = 0..image.values.len();
            let texels = places.map(|at| image.over_texel(at % image.width, at / image.width)).collect();
            Component { image, texels }
        });
        Self { components }
    }

    /// The image of the slopes' x, which has the map's levels and kernels.
    pub fn image(&self) -> &Image {
        &self.components[0].image
    }

    /// Mean x and y and covariance xx, xy, yy that reading a pyramid of the map over a footprint is to give: those of
    /// the mixture of two levels that [`Image::mixture`] describes.
    pub fn read(&self, position: [f64; 2], footprint: [f64; 3]) -> [f64; 5] {
        let read = |Component { image, texels }: &Component| image.mixture(texels, position, footprint);
        let [[x, xx], [y, yy], [_, both]] = self.components.each_ref().map(read);
        [x, y, xx, 0.5 * (both - xx - yy), yy]
    }

    /// The four parts of a level around a position: means x, means y, then the triangular factors' xx, yx and yy, and
    /// the position's place between the parts' centers.
    pub fn cell(&self, position: [f64; 2], level: usize) -> [f64; 22] {
        let cell = |Component { image, texels }: &Component| image.cell(texels, position, level);
        let [x, y, both] = self.components.each_ref().map(cell);
        let mut cell = [0.0; 22];
        for part in 0..4 {
            let [xx, yy, both] = [x, y, both].map(|cell| cell[4 + part] * cell[4 + part]);
            // Of y, the part that goes along with x and the rest.
            let along = if xx > 0.0 { 0.5 * (both - xx - yy) / xx.sqrt() } else { 0.0 };
            let rest = (yy - along * along).max(0.0).sqrt();
            for (number, value) in [x[part], y[part], xx.sqrt(), along, rest].into_iter().enumerate() {
                cell[4 * number + part] = value;
            }
        }
        (cell[20], cell[21]) = (x[8], x[9]);
        cell
    }
}
