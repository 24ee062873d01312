//! What a pixel should be, by rays to the displaced surface: no footprint and no filter is involved.

use super::body::Body;
use super::mesh::{Hit, Mesh};
use super::scene::DIRECTION;
use super::skin::{Skin, SIDE};
use crate::imaging::camera::{Ray, View};
use crate::imaging::look::Look;
use crate::imaging::pixel::{fill, Pixel};
use prefilter::reference::texture::PiecewiseLinear;
use prefilter::Irradiance;

/// The snake as it is.
#[derive(Clone, Debug)]
pub struct Scenery<'a> {
    /// The body.
    pub body: &'a Body,
    /// Its skin.
    pub skin: &'a Skin,
    /// The body with every height of the skin.
    pub mesh: &'a Mesh,
    /// Greens.
    pub green: &'a PiecewiseLinear,
    /// Reds.
    pub red: &'a PiecewiseLinear,
    /// The light.
    pub light: &'a Irradiance,
    /// How pixels are sampled.
    pub pixel: &'a Pixel,
}

impl Scenery<'_> {
    /// A picture by `strata`² rays a pixel. `done` is called after every row, from several threads.
    pub fn picture(&self, view: &View, strata: usize, seed: u64, done: &(dyn Fn() + Sync)) -> Vec<Look> {
        let mut picture = vec![Look::UNKNOWN; view.width * view.height];
        let look = |column: usize, row: usize| {
            let middle = view.middle(column, row);
            let places = self.pixel.samples(strata, seed, (row * view.width + column) as u64);
            self.look(places.map(|[right, down]| view.ray([middle[0] + right, middle[1] + down])))
        };
        fill(&mut picture, view.width, &look, done);
        picture
    }

    fn look(&self, rays: impl Iterator<Item = Ray>) -> Look {
        let mut look = Look { color: [0.0; 3], lit: [0.0; 3], share: 0.0 };
        let mut count = 0.0;
        for ray in rays {
            count += 1.0;
            let Some(hit) = self.mesh.hit(ray.from, ray.way) else { continue };
            let (color, light) = self.seen(&hit);
            look.share += 1.0;
            for channel in 0..3 {
                look.color[channel] += color[channel];
                look.lit[channel] += color[channel] * light[channel];
            }
        }
        let mean = |total: f64| if look.share == 0.0 { 0.0 } else { total / look.share };
        Look { color: look.color.map(mean), lit: look.lit.map(mean), share: look.share / count }
    }

    /// Color and light of a point of the surface.
    fn seen(&self, hit: &Hit) -> ([f64; 3], [f64; 3]) {
        let [row, column] = hit.place;
        let [x, y, z] = self.body.base(row, column).turned(hit.normal);
        let slope = -(DIRECTION[0] * x + DIRECTION[1] * y) / z;
        let texel = |part: f64| (part + 0.5) / SIDE as f64;
        let green = self.green.value(self.skin.pattern.bilinear([texel(row), texel(column)]));
        let red = self.red.value(slope);
        let light = self.light.value(hit.normal.map(|part| part as f32));
        let color = std::array::from_fn(|channel| red[channel] + (1.0 - red[3]) * green[channel]);
        (color, light.map(|part| f64::from(part) / std::f64::consts::PI))
    }
}

#[cfg(test)]
mod tests {
    use super::super::scene::{views, Material};
    use super::*;

    /// A body without scales has no slopes: nothing of it is red, and the light is the base surface's.
    #[test]
    fn a_smooth_body_is_green() -> Result<(), prefilter::Error> {
        let (body, skin, material) = (Body::new(), Skin::new(1), Material::new()?);
        let mesh = body.mesh(&vec![0.0; SIDE * SIDE], 0);
        let (green, pixel) = (material.green.reference(), Pixel::default());
        // A step at a slope that straight lines between texels do not have.
        let red = PiecewiseLinear { knots: vec![(0.06, [0.0; 4], [1.0; 4])] };
        let light = &material.light;
        let scenery = Scenery { body: &body, skin: &skin, mesh: &mesh, green: &green, red: &red, light, pixel: &pixel };
        let [_, whole, _] = views([60, 42], [1; 3]);
        let looks = scenery.picture(&whole, 4, 1, &|| ());
        let covered: f64 = looks.iter().map(|look| look.share).sum();
        assert!(covered > 0.2 * looks.len() as f64, "{covered} pixels");
        let red = looks.iter().filter(|look| look.color[2] > 0.35).count();
        assert!((red as f64) < 0.01 * covered, "{red} pixels are red");
        assert!(looks.iter().all(|look| look.lit.iter().zip(look.color).all(|(lit, color)| *lit <= 1.5 * color)));
        Ok(())
    }
}
