//! What a filter is told of a pixel.

use crate::random::Random;
use std::f64::consts::TAU;

/// Statistics of what a pixel covers, and its view and light. All numbers are those that a shader is given.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pixel {
    /// The mean of values or heights.
    pub mean: f64,
    /// Their deviation.
    pub deviation: f64,
    /// Mean and deviation of the values of another layer.
    pub value: [f64; 2],
    /// The mean slope.
    pub mean_slope: [f64; 2],
    /// The covariance of the slopes: xx, xy, yy.
    pub covariance: [f64; 3],
    /// The unit vector towards the viewer.
    pub view: [f64; 3],
    /// The unit vector towards the light.
    pub light: [f64; 3],
    /// The horizontal unit vector along which slopes have a component.
    pub direction: [f64; 2],
    /// The axes of the tangent frame in the space of the environment.
    pub frame: [[f64; 3]; 3],
    /// Where a driver finds statistics, and the derivatives of that place to the right and down.
    pub place: [[f64; 2]; 3],
}

/// What pixels are drawn from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drawn {
    /// The means, evenly.
    pub mean: [f64; 2],
    /// The deviations, evenly in their logarithm.
    pub deviation: [f64; 2],
    /// How far a component of the mean slope is from 0 at most.
    pub slope: f64,
    /// The deviations of the slopes along x and y, evenly in their logarithm.
    pub slope_deviation: [f64; 2],
    /// How much of the mean surface's area is in the picture at least.
    pub rise: f64,
}

impl Drawn {
    /// A random pixel: correlations of the slopes up to 0.8, views and lights evenly over the directions that the mean
    /// surface is seen from.
    pub fn pixel(&self, random: &mut Random) -> Pixel {
        let mut statistics = || [even(random, self.mean), random.between(self.deviation[0], self.deviation[1])];
        let ([mean, deviation], value) = (statistics(), statistics());
        let [x, y] = [0, 1].map(|_| random.between(self.slope_deviation[0], self.slope_deviation[1]));
        let both = even(random, [-0.8, 0.8]) * x * y;
        let mean_slope = [0, 1].map(|_| even(random, [-self.slope, self.slope]));
        let (view, light) = (self.above(random, mean_slope), self.above(random, mean_slope));
        let (sin, cos) = (TAU * random.unit()).sin_cos();
        let (turn_sin, turn_cos) = (TAU * random.unit()).sin_cos();
        let frame = [[turn_cos, turn_sin, 0.0], [-turn_sin, turn_cos, 0.0], [0.0, 0.0, 1.0]];
        let covariance = [x * x, both, y * y];
        let long = random.between(0.01, 1.0);
        let short = long * random.between(0.2, 1.0);
        let place =
            [[0; 2].map(|_| even(random, [-50.0, 50.0])), [long * cos, long * sin], [-short * sin, short * cos]];
        let pixel =
            Pixel { mean, deviation, value, mean_slope, covariance, view, light, direction: [cos, sin], frame, place };
        pixel.rounded()
    }

    /// A direction from which the mean surface is seen.
    fn above(&self, random: &mut Random, slope: [f64; 2]) -> [f64; 3] {
        loop {
            let (z, (sin, cos)) = (random.unit(), (TAU * random.unit()).sin_cos());
            let side = (1.0 - z * z).sqrt();
            let direction = [side * cos, side * sin, z];
            if direction[2] - direction[0] * slope[0] - direction[1] * slope[1] >= self.rise {
                return direction;
            }
        }
    }
}

fn even(random: &mut Random, [low, high]: [f64; 2]) -> f64 {
    low + (high - low) * random.unit()
}

impl Pixel {
    /// The same pixel seen and lit from straight above, from where all heights and slopes count alike.
    #[must_use]
    pub fn straight(self) -> Self {
        Self { view: [0.0, 0.0, 1.0], light: [0.0, 0.0, 1.0], ..self }
    }

    fn rounded(self) -> Self {
        fn round<const N: usize>(values: [f64; N]) -> [f64; N] {
            values.map(|value| f64::from(value as f32))
        }
        let [[mean], [deviation]] = [self.mean, self.deviation].map(|value| round([value]));
        let Self { value, mean_slope, covariance, view, light, direction, frame, place, .. } = self;
        let [value, mean_slope, direction] = [value, mean_slope, direction].map(round);
        let [covariance, view, light] = [covariance, view, light].map(round);
        Self {
            mean,
            deviation,
            value,
            mean_slope,
            covariance,
            view,
            light,
            direction,
            frame: frame.map(round),
            place: place.map(round),
        }
    }

    /// The numbers of a function's parameters, known by their names; others are those given, or NaN.
    pub fn numbers(&self, parameters: &[(&str, &str)], given: &[(&str, f64)]) -> Vec<f32> {
        let mut numbers = Vec::new();
        for (name, kind) in parameters {
            if *kind == "sampler" || kind.starts_with("texture") {
                continue;
            }
            let own: &[f64] = match *name {
                "mean" => &[self.mean],
                "deviation" => &[self.deviation],
                "mean_slope" => &self.mean_slope,
                "slope_covariance" => &self.covariance,
                "view" => &self.view,
                "light" => &self.light,
                "direction" => &self.direction,
                "position" => &self.place[0],
                "dpdx" => &self.place[1],
                "dpdy" => &self.place[2],
                "x" => &self.frame[0],
                "y" => &self.frame[1],
                "z" => &self.frame[2],
                layer if layer.ends_with("_mean") => &self.value[..1],
                layer if layer.ends_with("_deviation") => &self.value[1..],
                _ => {
                    let found = given.iter().find(|(given, _)| given == name);
                    numbers.push(found.map_or(f32::NAN, |(_, value)| *value as f32));
                    continue;
                }
            };
            numbers.extend(own.iter().map(|value| *value as f32));
        }
        numbers
    }
}
