//! Pixels at which a filter may be farthest from its integral: about the edges of its map, at the corners of its
//! ranges, of all sizes of footprints, seen from overhead to the horizon.

use std::f64::consts::TAU;

use prefilter::reference::footprint::{deviations, variance_along};
use prefilter::reference::slopes::Visible;
use prefilter::{ColorMap, Ranges};

use crate::random::Random;

/// What is known of a pixel; filters take what they need of it. All numbers are such as a device takes.
#[derive(Clone, Debug)]
pub struct Pixel {
    /// The mean of its values or heights.
    pub mean: f64,
    /// Their deviation.
    pub deviation: f64,
    /// Its slopes as they are seen.
    pub visible: Visible,
    /// The direction to a light.
    pub light: [f64; 3],
    /// What components of slopes are along.
    pub direction: [f64; 2],
    /// The axes of its tangent frame in the environment.
    pub frame: [[f64; 3]; 3],
}

/// The numbers as a device takes them.
fn single<const N: usize>(values: [f64; N]) -> [f64; N] {
    values.map(|value| f64::from(value as f32))
}

/// A horizontal unit vector.
fn turned(angle: f64) -> [f64; 2] {
    [angle.cos(), angle.sin()]
}

/// A unit vector above the horizon, its height even or even in its logarithm from `low` on.
fn direction(random: &mut Random, low: f64) -> [f64; 3] {
    let (even, grazing) = (low + (1.0 - low) * random.unit(), random.between(low.max(1e-6), 1.0));
    let z = random.pick([even, grazing]);
    let radius = ((1.0 - z) * (1.0 + z)).max(0.0).sqrt();
    let [x, y] = turned(TAU * random.unit());
    single([radius * x, radius * y, z])
}

/// A covariance of such deviations along x and y and a correlation up to 0.9.
fn correlated(random: &mut Random, [x, y]: [f64; 2]) -> [f64; 3] {
    single([x * x, 0.9 * (2.0 * random.unit() - 1.0) * x * y, y * y])
}

/// Two frames: the environment's own, and one that is turned.
const FRAMES: [[[f64; 3]; 3]; 2] =
    [[[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], [[0.6, 0.0, -0.8], [0.64, 0.6, 0.48], [0.48, -0.8, 0.36]]];

impl Pixel {
    fn new(random: &mut Random) -> Self {
        let [x, y] = [random.between(0.05, 1.5), random.between(0.05, 1.5)];
        let covariance = correlated(random, [x, y]);
        let visible = Visible { view: direction(random, 0.0), covariance, mean: [0.0; 2] };
        let frame = random.pick(FRAMES).map(single);
        let (light, angle) = (direction(random, 0.0), TAU * random.unit());
        Self { mean: 0.0, deviation: 0.0, visible, light, direction: single(turned(angle)), frame }
    }

    /// The numbers that an export takes, by the names of its parameters; those of a layer's values begin with its name.
    pub fn numbers(&self, parameters: &[(&str, &str)]) -> Vec<f32> {
        let Visible { view, covariance, mean } = &self.visible;
        let of = |name: &str| match name {
            "slope_covariance" => covariance.to_vec(),
            "mean_slope" => mean.to_vec(),
            "view" => view.to_vec(),
            "light" => self.light.to_vec(),
            "direction" => self.direction.to_vec(),
            "x" => self.frame[0].to_vec(),
            "y" => self.frame[1].to_vec(),
            "z" => self.frame[2].to_vec(),
            name if name.ends_with("mean") => vec![self.mean],
            name if name.ends_with("deviation") => vec![self.deviation],
            _ => Vec::new(),
        };
        parameters.iter().flat_map(|(name, _)| of(name)).map(|value| value as f32).collect()
    }

    /// The same of numbers that a device takes.
    pub fn rounded(self) -> Self {
        let Visible { view, covariance, mean } = self.visible;
        let visible = Visible { view: single(view), covariance: single(covariance), mean: single(mean) };
        let [mean, deviation] = single([self.mean, self.deviation]);
        Self { mean, deviation, visible, light: single(self.light), ..self }
    }

    /// Mean and deviation of the component over all slopes.
    fn component(&self) -> [f64; 2] {
        let Visible { covariance, mean, .. } = self.visible;
        let [x, y] = self.direction;
        [x * mean[0] + y * mean[1], variance_along(covariance, self.direction).sqrt()]
    }
}

/// A place on the axis of a map: about a knot, within so many deviations on either side, or anywhere within the ranges.
fn place(random: &mut Random, map: &ColorMap, ranges: Ranges, deviation: f64, [below, above]: [f64; 2]) -> f64 {
    let [low, high] = [ranges.mean.0, ranges.mean.1].map(f64::from);
    let knot = f64::from(map.knots()[random.word() as usize % map.knots().len()].position);
    let spread = random.pick([deviation, deviation, 0.005 * (high - low)]);
    let near = knot + spread * (below + (above - below) * random.unit());
    let anywhere = low + (high - low) * random.unit();
    random.pick([near, near, near, anywhere]).clamp(low, high)
}

/// A deviation from the smallest to the largest, and often one of these.
fn deviation(random: &mut Random, low: f64, high: f64) -> f64 {
    let between = random.between(low, high);
    random.pick([between, between, between, between, low, high])
}

/// Pixels of values within ranges.
pub fn values(random: &mut Random, map: &ColorMap, ranges: Ranges, count: usize) -> Vec<Pixel> {
    let points = crate::judged::points(map, ranges, count as u32);
    let pixel = Pixel::new(random);
    let at = |point: &[f32]| Pixel { mean: point[0].into(), deviation: point[1].into(), ..pixel.clone() };
    points.chunks_exact(2).map(at).collect()
}

/// Pixels of heights within ranges, from a deviation on, of Λ of view and light that add up to 1e4 at most; `lambda` is
/// that of a direction.
pub fn heights(
    random: &mut Random,
    map: &ColorMap,
    ranges: Ranges,
    floor: f64,
    lambda: impl Fn(&Pixel) -> f64,
    count: usize,
) -> Vec<Pixel> {
    let mut pixels = Vec::new();
    while pixels.len() < count {
        let mut pixel = Pixel::new(random);
        let deviation = deviation(random, floor, ranges.deviation.into());
        // What is seen lies above the mean.
        let mean = place(random, map, ranges, deviation, [-5.5, 2.5]);
        [pixel.mean, pixel.deviation] = single([mean, deviation]);
        if lambda(&pixel) <= 1e4 {
            pixels.push(pixel);
        }
    }
    pixels
}

/// Pixels of slopes whose component along a direction is within ranges, from a deviation on: seen along it, against
/// it, across or from anywhere, from overhead to the horizon of the mean surface.
pub fn components(random: &mut Random, map: &ColorMap, ranges: Ranges, floor: f64, count: usize) -> Vec<Pixel> {
    let [low, high] = [ranges.mean.0, ranges.mean.1].map(f64::from);
    let mut pixels = Vec::new();
    while pixels.len() < count {
        let mut pixel = Pixel::new(random);
        let size = deviation(random, floor, ranges.deviation.into());
        let at = place(random, map, ranges, size, [-3.0, 3.0]);
        let [x, y] = pixel.direction;
        let scale = size / pixel.component()[1];
        let aside = 0.3 * (2.0 * random.unit() - 1.0);
        let mean = single([at * x - aside * y, at * y + aside * x]);
        let covariance = single(pixel.visible.covariance.map(|value| scale * scale * value));
        let turn = libm::atan2(y, x) + random.pick([0.0, 0.5 * TAU, 0.0, 0.5 * TAU, 0.25 * TAU, 1.0]);
        let parameter = random.pick([1e-3, 0.3, 1.0, 2.2, 2.9]) + random.pick([0.0, 3.0]) * random.unit();
        pixel.visible = seen(turn, parameter, covariance, mean);
        let [mean, deviation] = pixel.component();
        let inside = (low..=high).contains(&mean) && (floor..=ranges.deviation.into()).contains(&deviation);
        if inside && pixel.visible.parameter() >= 0.0 {
            pixels.push(pixel);
        }
    }
    pixels
}

/// Slopes seen from an azimuth, at a parameter from the horizon of the mean surface.
fn seen(azimuth: f64, parameter: f64, covariance: [f64; 3], mean: [f64; 2]) -> Visible {
    let [x, y] = turned(azimuth);
    let z = x * mean[0] + y * mean[1] + parameter * variance_along(covariance, [x, y]).sqrt();
    let length = libm::hypot(1.0, z);
    Visible { view: single([x / length, y / length, z / length]), covariance, mean }
}

/// Pixels of whole slopes: `mean` draws a mean slope by the deviation along the longer axis of the covariance, which is
/// up to twice the other one; both are from `floor` on.
pub fn slopes(
    random: &mut Random,
    [floor, most]: [f64; 2],
    mean: impl Fn(&mut Random, f64) -> [f64; 2],
    count: usize,
) -> Vec<Pixel> {
    let mut pixels = Vec::new();
    while pixels.len() < count {
        let mut pixel = Pixel::new(random);
        let aspect = random.pick([1.0, 2.0, 1.0 + random.clone().unit()]);
        let long = deviation(random, aspect * floor, 0.9999 * most);
        let (sin, cos) = (TAU * random.unit()).sin_cos();
        let [a, b] = [long * long, (long / aspect).powi(2)];
        let covariance = single([a * cos * cos + b * sin * sin, (a - b) * sin * cos, a * sin * sin + b * cos * cos]);
        let mean = single(mean(random, long));
        let parameter = random.pick([1e-3, 0.3, 1.0, 2.2, 2.9]) + random.pick([0.0, 3.0]) * random.unit();
        pixel.visible = seen(TAU * random.unit(), parameter, covariance, mean);
        if pixel.visible.parameter() >= 0.0 && pixel.visible.view[2] >= 0.0 {
            pixels.push(pixel);
        }
    }
    pixels
}

/// Pixels of normals: slope deviations up to a largest one along any axis, views from 5 degrees above the plane and the
/// mean surface, and mean slopes to 0.3 on each axis.
pub fn normals(random: &mut Random, most: f64, count: usize) -> Vec<Pixel> {
    let mut pixels = Vec::new();
    while pixels.len() < count {
        let mut pixel = Pixel::new(random);
        let sizes = [(); 2].map(|()| deviation(random, 0.05, most));
        let covariance = correlated(random, sizes);
        // What deviates by more along an axis aslant is drawn together to that.
        let part = (0.999_999 * most / deviations(covariance)[0]).min(1.0);
        let covariance = single(covariance.map(|value| part * part * value));
        let mean = single([(); 2].map(|()| 0.3 * (2.0 * random.unit() - 1.0)));
        pixel.visible = Visible { view: direction(random, 0.0872), covariance, mean };
        let above = pixel.visible.rise() / (1.0 + mean[0] * mean[0] + mean[1] * mean[1]).sqrt();
        if above >= 0.0872 {
            pixels.push(pixel);
        }
    }
    pixels
}
