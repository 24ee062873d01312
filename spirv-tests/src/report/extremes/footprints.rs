//! Footprints of drivers in hard cases.

use std::f64::consts::TAU;

use super::cases::Case;
use crate::random::Random;

/// A position and the two vectors of a footprint's covariance; drivers of the plane leave out the third coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Footprint {
    /// Where it is.
    pub position: [f64; 3],
    /// One vector.
    pub across: [f64; 3],
    /// The other.
    pub along: [f64; 3],
}

fn single([x, y, z]: [f64; 3]) -> [f64; 3] {
    [x, y, z].map(|part| f64::from(part as f32))
}

/// Two vectors at right angles of these lengths.
fn vectors(random: &mut Random, [one, other]: [f64; 2]) -> [[f64; 3]; 2] {
    let (sin, cos) = (TAU * random.unit()).sin_cos();
    let (rise, flat) = (TAU * random.unit()).sin_cos();
    [
        single([one * cos, one * sin * flat, one * sin * rise]),
        single([-other * sin, other * cos * flat, other * cos * rise]),
    ]
}

impl Footprint {
    /// Footprints of a case, about an edge across x where there is one.
    pub fn all(case: Case, edge: Option<f64>, count: usize) -> Vec<Self> {
        let mut random = Random::new(0xf007);
        (0..count).map(|index| Self::new(case, edge, index, &mut random)).collect()
    }

    fn new(case: Case, edge: Option<f64>, index: usize, random: &mut Random) -> Self {
        let power = |from: f64, to: f64, steps: usize| {
            let part = (index % steps) as f64 / (steps - 1) as f64;
            10f64.powf(from + part * (to - from))
        };
        let mut place = |reach: f64| single([(); 3].map(|()| reach * (2.0 * random.unit() - 1.0)));
        let position = match case {
            Case::FarFromOrigin => place(power(4.0, 5.9, 5)),
            _ => place(4.0),
        };
        let usual = [0.05 + 0.4 * random.unit(), 0.05 + 0.4 * random.unit()];
        let lengths = match case {
            Case::Grazing => [0.01, 0.01 * power(3.0, 6.0, 4)],
            Case::NoDeviation => usual.map(|length| length * [0.0, 1e-30, 1e-15, 1e-8, 1e-6, 1e-4][index % 6]),
            Case::HugeDeviation => usual.map(|length| length * power(7.0, 18.0, 12)),
            Case::WideFootprints => usual.map(|length| 1e6 * length),
            Case::HardEdges | Case::Stripes => [power(-2.0, -6.0, 9); 2],
            Case::Denormals => [[0.0, 1e-45, 1e-41, 3e-39, 1.2e-38][index % 5], 1e-41],
            Case::BelowHorizon
            | Case::NearSingular
            | Case::FarFromOrigin
            | Case::HalfTables
            | Case::OneDirection
            | Case::Rounded
            | Case::OneTexel
            | Case::NoNumbers => usual,
        };
        let [mut across, mut along] = vectors(random, lengths);
        if case == Case::NearSingular {
            let part = if index.is_multiple_of(7) { 0.0 } else { 10f64.powi(-((index % 7) as i32)) };
            along = single([0, 1, 2].map(|axis| 0.8 * across[axis] + part * along[axis]));
        }
        let mut position = position;
        if case == Case::NoNumbers {
            let sign = if (index / 9).is_multiple_of(2) { 1.0 } else { -1.0 };
            let none = sign * [f64::from(f32::MAX), f64::INFINITY, f64::NAN][index / 3 % 3];
            [&mut position, &mut across, &mut along][index % 3][index / 18 % 2] = none;
        }
        let position = match (case, edge) {
            (Case::Denormals, None) => position.map(|part| f64::from((1e-39 * part) as f32)),
            (Case::HardEdges | Case::Stripes, Some(edge)) => {
                single([edge + lengths[0] * 2.0 * (2.0 * random.unit() - 1.0), position[1], position[2]])
            }
            _ => position,
        };
        Self { position, across, along }
    }

    /// The covariance in the plane: xx, xy, yy.
    pub fn covariance(&self) -> [f64; 3] {
        let ([a, b, _], [c, d, _]) = (self.across, self.along);
        [a * a + c * c, a * b + c * d, b * b + d * d]
    }

    /// Its numbers, of so many coordinates.
    pub fn numbers(&self, dimensions: usize) -> Vec<f32> {
        let vectors = [self.position, self.across, self.along];
        vectors.iter().flat_map(|vector| vector[..dimensions].iter().map(|part| *part as f32)).collect()
    }
}
