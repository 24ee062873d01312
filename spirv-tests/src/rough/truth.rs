//! What a pixel should be, by rays through all heights: no footprint and no filter is involved.

use crate::imaging::pixel::{fill, Pixel};
use crate::imaging::relief::Relief;
use crate::imaging::view::View;
use prefilter::reference::texture::PiecewiseLinear;

/// How far a point is lifted off the surface before it looks for the light, in deviations of heights.
const LIFT: f64 = 1e-6;

/// Ground, in deviations of heights, from which on a pixel takes twice as many strata: the more it sees, the more
/// different it is.
pub const WIDE: f64 = 5.0;

/// What a pixel sees, under each light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Seen<const LIGHTS: usize> {
    /// Mean color of all that is seen.
    pub color: [f64; 3],
    /// Mean of the colors that are lit, the others being black.
    pub lit: [[f64; 3]; LIGHTS],
    /// The share that is lit.
    pub share: [f64; LIGHTS],
}

impl<const LIGHTS: usize> Seen<LIGHTS> {
    /// What nobody wrote: it shows in every figure.
    pub const UNKNOWN: Self = Self { color: [f64::NAN; 3], lit: [[f64::NAN; 3]; LIGHTS], share: [f64::NAN; LIGHTS] };

    /// The mean of two pictures of one pixel.
    pub fn mean(&self, other: &Self) -> Self {
        let half = |one: [f64; 3], other: [f64; 3]| std::array::from_fn(|index| 0.5 * (one[index] + other[index]));
        Self {
            color: half(self.color, other.color),
            lit: std::array::from_fn(|light| half(self.lit[light], other.lit[light])),
            share: std::array::from_fn(|light| 0.5 * (self.share[light] + other.share[light])),
        }
    }
}

/// A surface to look at.
#[derive(Clone, Debug)]
pub struct Scenery<'a> {
    /// Its heights.
    pub relief: &'a Relief,
    /// Their colors.
    pub map: &'a PiecewiseLinear,
    /// How pixels are sampled.
    pub pixel: &'a Pixel,
    /// Ground from which on a pixel takes twice as many strata an axis: [`WIDE`] for the truth.
    pub wide: f64,
}

impl Scenery<'_> {
    /// A picture by `strata`² rays a pixel, each with one more to every light, which are unit vectors toward them; by
    /// four times as many where a pixel is wide. `done` is called after every row, from several threads.
    pub fn picture<const LIGHTS: usize>(
        &self,
        view: &View,
        lights: &[[f64; 3]; LIGHTS],
        strata: usize,
        seed: u64,
        done: &(dyn Fn() + Sync),
    ) -> Vec<Seen<LIGHTS>> {
        let mut picture = vec![Seen::UNKNOWN; view.width * view.height];
        let look = |column: usize, row: usize| {
            let middle = view.middle(column, row);
            let ray = view.ray(middle);
            let strata = if ray.width(ray.crossing(0.0)) < self.wide { strata } else { 2 * strata };
            let places = self.pixel.samples(strata, seed, (row * view.width + column) as u64);
            self.look(view, lights, places.map(|[right, down]| [middle[0] + right, middle[1] + down]))
        };
        fill(&mut picture, view.width, &look, done);
        picture
    }

    fn look<const LIGHTS: usize>(
        &self,
        view: &View,
        lights: &[[f64; 3]; LIGHTS],
        places: impl Iterator<Item = [f64; 2]>,
    ) -> Seen<LIGHTS> {
        let mut seen = Seen { color: [0.0; 3], lit: [[0.0; 3]; LIGHTS], share: [0.0; LIGHTS] };
        let mut count = 0.0;
        for place in places {
            let ray = view.ray(place);
            // Views stay below the horizon; a ray that sees no ground would spoil the pixel.
            let Some(along) = self.relief.hit(ray.from, ray.way) else { return Seen::UNKNOWN };
            let [x, y, height] = ray.at(along);
            let [red, green, blue, _] = self.map.value(height);
            let color = [red, green, blue];
            count += 1.0;
            add(&mut seen.color, color);
            for (light, toward) in lights.iter().enumerate() {
                if self.relief.hit([x, y, height + LIFT], *toward).is_none() {
                    add(&mut seen.lit[light], color);
                    seen.share[light] += 1.0;
                }
            }
        }
        let mean = |sum: [f64; 3]| sum.map(|total| total / count);
        Seen { color: mean(seen.color), lit: seen.lit.map(mean), share: seen.share.map(|total| total / count) }
    }
}

fn add(sum: &mut [f64; 3], color: [f64; 3]) {
    sum.iter_mut().zip(color).for_each(|(total, channel)| *total += channel);
}

#[cfg(test)]
mod tests {
    use super::super::relief::relief;
    use super::*;
    use crate::imaging::view::Lens;
    use crate::imaging::waves::{Wave, Waves};
    use std::f64::consts::TAU;

    /// Straight down on ridges whose light comes from across: a profile in one dimension says what is lit.
    #[test]
    fn ridges_are_lit_as_their_profile_says() {
        let wave = Wave { periods: [1, 0], amplitude: 1.0, phase: 0.0 };
        let relief = relief(&Waves { waves: vec![wave], period: 8.0 });
        // Black below 0.5, white above.
        let map = PiecewiseLinear { knots: vec![(0.5, [0.0; 4], [1.0; 4])] };
        let scenery = Scenery { relief: &relief, map: &map, pixel: &Pixel::default(), wide: WIDE };
        let lens = Lens::Satellite { first: 5.0, farther: 2.0 };
        let view = View { name: "", title: "", lens, width: 24, height: 24, pan: [0.0; 2] };
        let tangent = 0.4;
        let light = [1.0, 0.0, tangent].map(|part| part / f64::hypot(1.0, tangent));
        let picture = scenery.picture(&view, &[light], 16, 1, &|| ());

        let height = |x: f64| (TAU * x / 8.0).cos();
        let lit = |x: f64| {
            (1..4000).all(|step| height(x + 0.004 * f64::from(step)) < height(x) + 0.004 * f64::from(step) * tangent)
        };
        let profile: Vec<(bool, bool)> =
            (0..2000).map(|step| 0.004 * f64::from(step)).map(|x| (lit(x), height(x) > 0.5)).collect();
        let share =
            |of: &dyn Fn(&(bool, bool)) -> bool| profile.iter().filter(|point| of(point)).count() as f64 / 2000.0;
        let mean = |of: &dyn Fn(&Seen<1>) -> f64| picture.iter().map(of).sum::<f64>() / picture.len() as f64;
        // The picture holds some 15 ridges, of which it sees parts.
        assert!((mean(&|seen| seen.share[0]) - share(&|point| point.0)).abs() < 0.02);
        assert!((mean(&|seen| seen.color[1]) - share(&|point| point.1)).abs() < 0.02);
        assert!((mean(&|seen| seen.lit[0][1]) - share(&|point| point.0 && point.1)).abs() < 0.02);
    }
}
