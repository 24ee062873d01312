//! Spectra of solid Gabor noise.

use std::f64::consts::{PI, TAU};

use crate::Error;

/// The frequencies of the kernels of [`Gabor`](super::gabor::Gabor) noise, in cycles a unit of the position.
///
/// Frequencies go up to sixteen times the bandwidth: beyond, f32 has no digits for the phase.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Spectrum {
    /// One frequency: waves that all lie across the same direction.
    Anisotropic {
        /// Its vector.
        frequency: [f32; 3],
    },
    /// One length in all directions.
    Isotropic {
        /// The length.
        frequency: f32,
    },
    /// Ranges in polar coordinates about the third axis, each spread evenly.
    Hybrid {
        /// Least and largest length.
        frequency: (f32, f32),
        /// First and last angle about the third axis, in radians: at most one turn apart, from −2π to 2π.
        azimuth: (f32, f32),
        /// Least and largest cosine of the angle to the third axis, −1 to 1: 0 for directions at right angles to it.
        height: (f32, f32),
    },
}

/// Frequencies whose mean stands for that over all of a hybrid spectrum with some extent.
pub(super) const NODES: usize = 16;

/// Largest frequency in bandwidths.
const HIGHEST: f32 = 16.0;

/// Ranges in polar coordinates: lengths, angles about the third axis and cosines of the angle to it.
#[derive(Clone, Copy)]
pub(super) struct Polar {
    pub frequency: [f64; 2],
    pub azimuth: [f64; 2],
    pub height: [f64; 2],
}

impl Spectrum {
    /// Whether the description can be used.
    ///
    /// # Errors
    /// [`Error::Value`] for a number outside its range.
    pub(super) fn check(&self, bandwidth: f32) -> Result<(), Error> {
        let within = |what: &str, value: f32, low: f32, high: f32, unit: &str| {
            // Written so that NaN is refused.
            if (low..=high).contains(&value) {
                return Ok(());
            }
            Err(Error::value(format!("the spectrum's {what}"), value, format!("{low} to {high}{unit}")))
        };
        let highest = HIGHEST * bandwidth;
        let length = |what: &str, value: f32| within(what, value, 0.0, highest, ", sixteen bandwidths");
        match *self {
            Self::Anisotropic { frequency } => {
                let [x, y, z] = frequency.map(f64::from);
                length("frequency", (x * x + y * y + z * z).sqrt() as f32)
            }
            Self::Isotropic { frequency } => length("frequency", frequency),
            Self::Hybrid { frequency, azimuth, height } => {
                let turn = TAU as f32;
                length("least frequency", frequency.0)?;
                within("largest frequency", frequency.1, frequency.0, highest, ", the least to sixteen bandwidths")?;
                within("first azimuth", azimuth.0, -turn, turn, "")?;
                within("last azimuth", azimuth.1, azimuth.0, (azimuth.0 + turn).min(turn), ", up to a turn further")?;
                within("least height", height.0, -1.0, 1.0, "")?;
                within("largest height", height.1, height.0, 1.0, "")
            }
        }
    }

    /// The ranges, starts and extents, with frequencies in cycles of `unit`.
    pub(super) fn polar(&self, unit: f64) -> Polar {
        let range = |(from, to): (f32, f32)| [f64::from(from), f64::from(to) - f64::from(from)];
        match *self {
            Self::Anisotropic { frequency } => {
                let [x, y, z] = frequency.map(f64::from);
                let length = (x * x + y * y + z * z).sqrt();
                let height = if length > 0.0 { z / length } else { 0.0 };
                Polar { frequency: [unit * length, 0.0], azimuth: [libm::atan2(y, x), 0.0], height: [height, 0.0] }
            }
            Self::Isotropic { frequency } => {
                Polar { frequency: [unit * f64::from(frequency), 0.0], azimuth: [0.0, TAU], height: [-1.0, 2.0] }
            }
            Self::Hybrid { frequency, azimuth, height } => Polar {
                frequency: range(frequency).map(|part| unit * part),
                azimuth: range(azimuth),
                height: range(height),
            },
        }
    }
}

impl Polar {
    /// Frequencies whose weighted mean stands for that over the ranges, with their weights: by as many for each range
    /// as leave [`NODES`] for all that have an extent.
    pub(super) fn nodes(&self) -> Vec<([f64; 3], f64)> {
        let wide = |range: [f64; 2]| range[1] > 0.0;
        let (f, a, h) = (wide(self.frequency), wide(self.azimuth), wide(self.height));
        // Squares of lengths and heights are exact by two; angles need more.
        let (others, around) = match (f, a, h) {
            (true, true, true) => (2, 4),
            (true, true, false) | (false, true, true) | (true, false, true) => (4, 4),
            _ => (16, 16),
        };
        let lengths = shares(self.frequency, others, false);
        let heights = shares(self.height, others, false);
        let azimuths = shares(self.azimuth, around, self.azimuth[1] > 1.5 * PI);
        let mut nodes = Vec::new();
        for &(length, by_length) in &lengths {
            for &(height, by_height) in &heights {
                for &(azimuth, by_azimuth) in &azimuths {
                    let level = length * (1.0 - height * height).max(0.0).sqrt();
                    let (sin, cos) = libm::sincos(azimuth);
                    nodes.push(([level * cos, level * sin, length * height], by_length * by_height * by_azimuth));
                }
            }
        }
        nodes
    }
}

/// Places in a range with their weights, `count` of 2, 4 or 16 where it has an extent: those of Gauss and Legendre, in
/// four parts for sixteen, or the middles of even parts.
///
/// Source: Abramowitz and Stegun 1964, "Handbook of Mathematical Functions", table 25.4.
fn shares([start, extent]: [f64; 2], count: usize, even: bool) -> Vec<(f64, f64)> {
    const TWO: [(f64, f64); 2] = [(-0.577_350_269_189_626, 1.0), (0.577_350_269_189_626, 1.0)];
    const FOUR: [(f64, f64); 4] = [
        (-0.861_136_311_594_053, 0.347_854_845_137_454),
        (-0.339_981_043_584_856, 0.652_145_154_862_546),
        (0.339_981_043_584_856, 0.652_145_154_862_546),
        (0.861_136_311_594_053, 0.347_854_845_137_454),
    ];
    let (parts, rule): (usize, &[(f64, f64)]) = match count {
        _ if !(extent > 0.0) => return vec![(start, 1.0)],
        _ if even => (count, &[(0.0, 2.0)]),
        2 => (1, &TWO),
        _ => (count / 4, &FOUR),
    };
    let part = |part: usize| {
        let place = move |place: f64| start + extent * (part as f64 + 0.5 + 0.5 * place) / parts as f64;
        rule.iter().map(move |&(node, weight)| (place(node), 0.5 * weight / parts as f64))
    };
    (0..parts).flat_map(part).collect()
}
