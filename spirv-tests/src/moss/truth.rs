//! What a pixel should be, by rays to all heights: no footprint and no filter is involved.

use super::log::Log;
use crate::imaging::camera::View;
use crate::imaging::look::Look;
use crate::imaging::pixel::{fill, Pixel};
use crate::imaging::relief::Relief;
use crate::imaging::vector::{difference, dot, scaled, sum, unit, Vector};
use prefilter::reference::texture::PiecewiseLinear;

/// Steps of rays, over which the log is nearly flat: it is 5e-4 off.
const STEP: f64 = 0.5;

/// How far a point is lifted off the surface before it looks for the sun.
const LIFT: f64 = 1e-5;

/// A surface to look at.
#[derive(Clone, Debug)]
pub struct Scenery<'a> {
    /// What it is on.
    pub log: Log,
    /// Its heights.
    pub relief: &'a Relief,
    /// The lowest and the highest.
    pub range: [f64; 2],
    /// Their colors.
    pub map: &'a PiecewiseLinear,
    /// A unit vector toward the sun.
    pub sun: Vector,
    /// How pixels are sampled.
    pub pixel: &'a Pixel,
}

impl Scenery<'_> {
    /// Both halves of the truth, by `strata`² rays a pixel each. `done` is told how many, from several threads.
    pub fn halves(&self, view: &View, seed: u64, done: &(dyn Fn(u64) + Sync)) -> [Vec<Look>; 2] {
        [2 * seed + 1, 2 * seed + 2].map(|seed| self.picture(view, view.strata, seed, done))
    }

    /// A picture by `strata`² rays a pixel. `done` is told how many, from several threads.
    pub fn picture(&self, view: &View, strata: usize, seed: u64, done: &(dyn Fn(u64) + Sync)) -> Vec<Look> {
        let mut picture = vec![Look::UNKNOWN; view.width * view.height];
        let look = |column: usize, row: usize| {
            let middle = view.middle(column, row);
            let places = self.pixel.samples(strata, seed, (row * view.width + column) as u64);
            self.look(view, places.map(|[right, down]| [middle[0] + right, middle[1] + down]))
        };
        let rays = (view.width * strata * strata) as u64;
        fill(&mut picture, view.width, &look, &|| done(rays));
        picture
    }

    fn look(&self, view: &View, places: impl Iterator<Item = [f64; 2]>) -> Look {
        let mut look = Look { color: [0.0; 3], lit: [0.0; 3], share: 0.0 };
        let mut count = 0.0;
        for place in places {
            count += 1.0;
            let way = scaled(view.ray(place).back(), -1.0);
            let Some(hit) = self.hit(view.eye, way) else { continue };
            let (color, light) = self.seen(hit);
            look.share += 1.0;
            look.color = sum(look.color, color);
            look.lit = sum(look.lit, scaled(color, light));
        }
        let mean = |total: f64| if look.share == 0.0 { 0.0 } else { total / look.share };
        Look { color: look.color.map(mean), lit: look.lit.map(mean), share: look.share / count }
    }

    fn hit(&self, from: Vector, way: Vector) -> Option<[f64; 3]> {
        self.log.first(from, way, self.range, STEP, |a, b| self.relief.hit_within(a, difference(b, a), 1.0))
    }

    /// Color of a point of the surface, and Lambert's cosine of the sun there, 0 in shadow.
    fn seen(&self, [x, around, height]: [f64; 3]) -> ([f64; 3], f64) {
        let [red, green, blue, _] = self.map.value(height);
        let [along, across] = self.relief.slope([x, around]);
        let grown = self.log.radius / (self.log.radius + height);
        let light = dot(unit([-along, -grown * across, 1.0]), self.log.turned(around, self.sun));
        let from = self.log.point([x, around, height + LIFT]);
        let dark = light <= 0.0 || self.hit(from, self.sun).is_some();
        ([red, green, blue], if dark { 0.0 } else { light })
    }

    /// The mean of both halves.
    pub fn mean(halves: &[Vec<Look>; 2]) -> Vec<Look> {
        halves[0].iter().zip(&halves[1]).map(|(one, other)| Look::mean(&[*one, *other])).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::super::scene::{sun, views, LOG};
    use super::*;

    /// A log without relief: one color, and the cosine of its own normal.
    #[test]
    fn a_smooth_log_is_lit_by_its_normal() {
        let relief = Relief::new([4, 4], vec![0.1; 16], [8.0; 2]);
        let map = PiecewiseLinear { knots: vec![(0.05, [0.0; 4], [0.5; 4])] };
        let (sun, pixel) = (sun(), Pixel::default());
        let scenery = Scenery { log: LOG, relief: &relief, range: [0.1; 2], map: &map, sun, pixel: &pixel };
        let [_, middle, _] = views([24, 48], [4; 3]);
        let halves = scenery.halves(&middle, 1, &|_| ());
        let looks = Scenery::mean(&halves);
        let mut judged = 0;
        for (number, look) in looks.iter().enumerate() {
            let way = scaled(middle.ray(middle.middle(number % 24, number / 24)).back(), -1.0);
            let ([enter, _], meets) = LOG.crossings(middle.eye, way, 0.1);
            // Away from the silhouette, at 1.318, the middle stands for the pixel.
            let [_, around, _] = LOG.place(sum(middle.eye, scaled(way, enter)));
            if meets && around / LOG.radius < 1.1 {
                let expected = 0.5 * LOG.turned(around, sun)[2];
                assert!((look.lit[1] - expected).abs() < 5e-3, "{number}: {look:?} {expected}");
                assert!((look.color[2] - 0.5).abs() < 1e-12 && look.share == 1.0, "{number}: {look:?}");
                judged += 1;
            }
        }
        assert!(judged > 24 * 40, "{judged}");
        assert!(looks[0].share == 0.0, "no sky: {:?}", looks[0]);
    }
}
