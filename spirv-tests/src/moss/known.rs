//! What filters know of a pixel: a few rays to the displaced log, and the statistics of f over their footprints.

use super::displacement::Displacement;
use super::log::Log;
use crate::imaging::camera::{Ray, View};
use crate::imaging::pixel::fill;
use crate::imaging::taps::{places, ALL_TAPS, TAP_DEVIATION};
use crate::imaging::vector::{across, length, scaled, sum, Vector};
use crate::imaging::waves::{Filtered, Waves};

/// Steps of rays to the displaced log, in wavelengths, and halvings of the one that passes it.
const STEP: f64 = 1.0 / 12.0;
const HALVINGS: usize = 12;

/// How far a point is lifted off the surface before it looks for the sun.
const LIFT: f64 = 1e-4;

/// What is known of a tap.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Known {
    /// Mean of f.
    pub mean: f64,
    /// Its deviation.
    pub deviation: f64,
    /// Mean of the slopes of f, along the log and around it.
    pub slope: [f64; 2],
    /// Their covariance.
    pub slope_covariance: [f64; 3],
    /// A unit vector to the eye, in the axes of the place.
    pub view: Vector,
    /// One to the sun.
    pub sun: Vector,
    /// Whether the displaced log leaves the sun to the place.
    pub sunlit: bool,
}

/// A log displaced by mean heights.
#[derive(Clone, Copy, Debug)]
pub struct Displaced<'a> {
    /// What is displaced.
    pub log: Log,
    /// f.
    pub waves: &'a Waves,
    /// Mean heights.
    pub displacement: &'a Displacement,
    /// The lowest and the highest height.
    pub range: [f64; 2],
    /// Deviation of all heights by that of their slopes: how wide faces are.
    pub face: f64,
    /// A unit vector toward the sun.
    pub sun: Vector,
}

impl Displaced<'_> {
    /// What is known of every pixel of a view: of its taps, None where they miss the log.
    pub fn picture(&self, view: &View) -> Vec<[Option<Known>; ALL_TAPS]> {
        let mut picture = vec![[None; ALL_TAPS]; view.width * view.height];
        let work =
            |column: usize, row: usize| places(view.middle(column, row)).map(|place| self.known(&view.ray(place)));
        fill(&mut picture, view.width, &work, &|| ());
        picture
    }

    fn known(&self, ray: &Ray) -> Option<Known> {
        let filtered = self.waves.filtered(self.footprint(ray));
        let deviation = filtered.variance.sqrt();
        let hit = |from: Vector, way: Vector| self.hit(&filtered, deviation, from, way);
        let [x, around, _] = hit(ray.from, scaled(ray.back(), -1.0))?;
        let place = [x, around];
        let mean = filtered.height(place);
        let height = self.displacement.height(mean, deviation);
        let (from, slope) = (self.log.point([x, around, height + LIFT]), filtered.slope(place));
        let sun = self.log.turned(around, self.sun);
        let steepness = self.displacement.slope(mean, deviation);
        // What faces away is not the displaced log's concern.
        let rise = sun[2] - steepness * (slope[0] * sun[0] + slope[1] * sun[1]);
        Some(Known {
            mean,
            deviation,
            slope,
            slope_covariance: filtered.slope_covariance,
            view: self.log.turned(around, ray.back()),
            sun,
            sunlit: rise <= 0.0 || hit(from, self.sun).is_none(),
        })
    }

    /// Covariance of the places that a tap covers.
    ///
    /// As far as a surface that bends away is seen at all, what is flat to the ray is covered farther. A pixel thinner
    /// than faces sees one, which is turned to it: the footprint is as long as wide.
    fn footprint(&self, ray: &Ray) -> [f64; 3] {
        let (back, middle) = (ray.back(), 0.5 * (self.range[0] + self.range[1]));
        let ([along, _], _) = self.log.crossings(ray.from, scaled(back, -1.0), middle);
        let [_, around, _] = self.log.place(sum(ray.from, scaled(back, -along)));
        let [x, y, z] = self.log.turned(around, back);
        // Widths of the pixel across the ray: on the right and below.
        let [right, below] = ray.changes.map(|change| length(across(change, back)) * along / length(ray.way));
        let width = (right * below).sqrt();
        let reach = TAP_DEVIATION * width;
        let bend = y * y / (x * x + y * y).max(1e-9) / self.log.radius;
        let cosine = z.max(0.0).powi(2) + 2.0 * bend * reach;
        let many = width * width / (width * width + self.face * self.face) / cosine;
        [1.0 + many * x * x, many * x * y, 1.0 + many * y * y].map(|part| reach * reach * part)
    }

    /// The first place at which a ray comes to the log that the filtered values displace.
    fn hit(&self, filtered: &Filtered, deviation: f64, from: Vector, way: Vector) -> Option<[f64; 3]> {
        let over =
            |place: [f64; 3]| place[2] - self.displacement.height(filtered.height([place[0], place[1]]), deviation);
        self.log.first(from, way, self.range, STEP, |a, b| {
            if over(b) > 0.0 {
                return None;
            }
            let (mut above, mut below) = (0.0, 1.0);
            for _ in 0..HALVINGS {
                let middle = 0.5 * (above + below);
                if over(std::array::from_fn(|axis| a[axis] + middle * (b[axis] - a[axis]))) > 0.0 {
                    above = middle;
                } else {
                    below = middle;
                }
            }
            Some(0.5 * (above + below))
        })
    }
}
