//! Inputs of filters, usual ones and those of the hard cases.

use std::f64::consts::TAU;

use super::cases::Case;
use crate::random::Random;

/// All that a filter may take.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// Mean of the values or heights.
    pub mean: f64,
    /// Their deviation.
    pub deviation: f64,
    /// Mean of the slopes.
    pub mean_slope: [f64; 2],
    /// Their covariance: xx, xy, yy.
    pub covariance: [f64; 3],
    /// Towards the viewer.
    pub view: [f64; 3],
    /// Towards the light.
    pub light: [f64; 3],
    /// The vector along which slopes have their component.
    pub direction: [f64; 2],
}

/// The positions of a map.
#[derive(Clone, Debug, PartialEq)]
pub struct Place {
    /// The lowest one.
    pub low: f64,
    /// How far it is to the highest one.
    pub width: f64,
    /// Where colors jump, or else where they bend.
    pub edges: Vec<f64>,
}

/// The axes of the tangent frame in the space of an environment.
pub const FRAME: [[f64; 3]; 3] = [[0.6, 0.0, -0.8], [0.64, 0.6, 0.48], [0.48, -0.8, 0.36]];

/// The numbers as f32 holds them.
fn single<const N: usize>(values: [f64; N]) -> [f64; N] {
    values.map(|value| f64::from(value as f32))
}

/// A number between two, evenly.
fn even(random: &mut Random, low: f64, high: f64) -> f64 {
    low + (high - low) * random.unit()
}

/// The unit vector of a height.
fn direction(height: f64, azimuth: f64) -> [f64; 3] {
    let radius = ((1.0 - height) * (1.0 + height)).max(0.0).sqrt();
    single([radius * azimuth.cos(), radius * azimuth.sin(), height])
}

/// The covariance of axes that are turned.
fn turned([major, minor]: [f64; 2], turn: f64) -> [f64; 3] {
    let ((sin, cos), [a, b]) = (turn.sin_cos(), [major * major, minor * minor]);
    single([cos * cos * a + sin * sin * b, sin * cos * (a - b), sin * sin * a + cos * cos * b])
}

impl Point {
    /// What filters meet every day.
    fn usual(random: &mut Random, place: &Place) -> Self {
        let major = even(random, 0.25, 0.45);
        let turn = TAU * random.unit();
        Self {
            mean: f64::from((place.low + place.width * even(random, 0.1, 0.9)) as f32),
            deviation: f64::from((place.width * even(random, 0.02, 0.3)) as f32),
            mean_slope: single([even(random, -0.2, 0.2), even(random, -0.2, 0.2)]),
            covariance: turned([major, major * even(random, 0.55, 0.95)], TAU * random.unit()),
            view: direction(even(random, 0.4, 0.98), TAU * random.unit()),
            light: direction(even(random, 0.4, 0.98), TAU * random.unit()),
            direction: single([turn.cos(), turn.sin()]),
        }
    }

    /// Points of a case, `count` of them, for a map.
    pub fn all(case: Case, place: &Place, count: usize) -> Vec<Self> {
        let mut random = Random::new(0x4a2d);
        (0..count).map(|index| Self::usual(&mut random, place).hardened(case, place, index, &mut random)).collect()
    }

    /// The point with what is hard about a case.
    fn hardened(self, case: Case, place: &Place, index: usize, random: &mut Random) -> Self {
        let power = |from: f64, to: f64, steps: usize| {
            let part = (index % steps) as f64 / (steps - 1) as f64;
            10f64.powf(from + part * (to - from))
        };
        let azimuth = TAU * random.unit();
        match case {
            Case::Grazing => {
                let low = direction(power(-1.0, -7.0, 7), azimuth);
                match index % 3 {
                    0 => Self { view: low, ..self },
                    1 => Self { light: low, ..self },
                    _ => Self { view: low, light: direction(power(-7.0, -1.0, 7), TAU * random.unit()), ..self },
                }
            }
            Case::BelowHorizon => {
                let low = direction(-[1e-7, 1e-4, 1e-2, 0.1, 0.3, 0.9][index % 6], azimuth);
                match index / 6 % 3 {
                    0 => Self { view: low, ..self },
                    1 => Self { light: low, ..self },
                    _ => Self { view: low, light: low, ..self },
                }
            }
            Case::NoDeviation => {
                let part = [0.0, 1e-30, 1e-15, 1e-8, 1e-6, 1e-4][index % 6];
                self.narrowed(part)
            }
            Case::HugeDeviation => self.narrowed(power(1.0, 18.0, 18)),
            Case::NearSingular => {
                let [one, other] = [even(random, 0.2, 0.5), even(random, 0.2, 0.5)];
                let sign = random.pick([-1.0, 1.0]);
                let covariance = match index % 9 {
                    0 => [one * one, 0.0, 0.0],
                    1 => [0.0, 0.0, one * one],
                    2 => [one * one, sign * one * one, one * one],
                    step => {
                        let correlation = sign * (1.0 - 10f64.powi(1 - step as i32));
                        [one * one, correlation * one * other, other * other]
                    }
                };
                Self { covariance: single(covariance), ..self }
            }
            Case::HardEdges => self.at_an_edge(place, power(-2.0, -6.0, 9), random),
            Case::Stripes => self.at_an_edge(place, power(-0.5, -5.0, 10), random),
            Case::Denormals => self.subnormal(random),
            Case::OneDirection => {
                let toward = direction([1.0, 0.9, 0.6, 0.3, 0.1, 0.01][index % 6], azimuth);
                Self { view: toward, light: toward, ..self }
            }
            Case::Rounded => self.rounded(index),
            Case::NoNumbers => self.with_none(index),
            Case::WideFootprints | Case::FarFromOrigin | Case::HalfTables | Case::OneTexel => self,
        }
    }

    /// Moments that differences of sums may have.
    fn rounded(self, index: usize) -> Self {
        let [xx, _, yy] = self.covariance;
        let most = (xx * yy).sqrt();
        let covariance = match index % 6 {
            0 => [xx, most * (1.0 + 1e-5), yy],
            1 => [xx, -most * (1.0 + 1e-5), yy],
            2 => [-1e-9, 0.0, yy],
            3 => [xx, 1e-9, -1e-9],
            4 => [-1e-9, 1e-9, -1e-9],
            _ => self.covariance,
        };
        let deviation = if index % 6 > 3 { f64::from(-1e-9f32) } else { self.deviation };
        Self { covariance: single(covariance), deviation, ..self }
    }

    /// One input that is no number of use.
    fn with_none(mut self, index: usize) -> Self {
        let sign = if (index / 18).is_multiple_of(2) { 1.0 } else { -1.0 };
        let none = sign * [f64::from(f32::MAX), f64::INFINITY, f64::NAN][index / 6 % 3];
        match index % 6 {
            0 => self.mean = none,
            1 => self.deviation = none,
            2 => self.mean_slope[index / 36 % 2] = none,
            3 => self.covariance[index / 36 % 3] = none,
            4 => self.view[index / 36 % 3] = none,
            _ => self.light[index / 36 % 3] = none,
        }
        self
    }

    /// The nearest point that moments can have, where all of it are numbers of use.
    pub fn nearest(self) -> Option<Self> {
        let [xx, xy, yy] = self.covariance;
        let (xx, yy) = (xx.max(0.0), yy.max(0.0));
        let most = xx.sqrt() * yy.sqrt();
        let near = Self { covariance: [xx, xy.clamp(-most, most), yy], deviation: self.deviation.max(0.0), ..self };
        let of_values = [self.mean, self.deviation].into_iter();
        let all = of_values.chain(self.mean_slope).chain(self.covariance).chain(self.view).chain(self.light);
        all.map(f64::abs).all(|number| number < 1e38).then_some(near)
    }

    /// Values and slopes that deviate by a part of what they do.
    fn narrowed(self, part: f64) -> Self {
        let covariance = single(self.covariance.map(|variance| part * part * variance));
        Self { deviation: f64::from((part * self.deviation) as f32), covariance, ..self }
    }

    /// Values, and slopes along the direction, within some deviations of an edge, a deviation being a part of the map.
    fn at_an_edge(self, place: &Place, part: f64, random: &mut Random) -> Self {
        let edge = place.edges[random.word() as usize % place.edges.len()];
        let deviation = part * place.width;
        let at = edge + deviation * even(random, -2.5, 2.5);
        let [x, y] = self.direction;
        Self {
            mean: f64::from(at as f32),
            deviation: f64::from(deviation as f32),
            mean_slope: single([at * x, at * y]),
            covariance: turned([deviation, 0.7 * deviation], TAU * random.unit()),
            ..self
        }
    }

    /// Numbers that f32 holds with fewer digits, or as 0.
    fn subnormal(self, random: &mut Random) -> Self {
        let mut small = || -> f64 { random.pick([-1.0, 1.0]) * random.pick([0.0, 1e-45, 1e-41, 3e-39, 1.2e-38]) };
        let [variance, other] = [small().abs(), small().abs()];
        let tilted = |[x, y]: [f64; 2]| single([x, y, 1.0]);
        Self {
            mean: f64::from(small() as f32),
            deviation: f64::from(small().abs() as f32),
            mean_slope: single([small(), small()]),
            covariance: single([variance, 0.5 * variance.min(other), other]),
            view: tilted([small(), small()]),
            light: tilted([small(), small()]),
            ..self
        }
    }

    /// The numbers of an export's parameters, one behind the other; those of layers are the same.
    pub fn numbers(&self, parameters: &[(&str, &str)]) -> Vec<f32> {
        let of = |name: &str| match name {
            "mean_slope" => self.mean_slope.to_vec(),
            "slope_covariance" => self.covariance.to_vec(),
            "view" => self.view.to_vec(),
            "light" => self.light.to_vec(),
            "direction" => self.direction.to_vec(),
            "x" => FRAME[0].to_vec(),
            "y" => FRAME[1].to_vec(),
            "z" => FRAME[2].to_vec(),
            name if name.ends_with("mean") => vec![self.mean],
            name if name.ends_with("deviation") => vec![self.deviation],
            _ => Vec::new(),
        };
        parameters.iter().flat_map(|(name, _)| of(name)).map(|number| number as f32).collect()
    }
}
