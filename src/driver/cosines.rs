//! Sums of cosines: waves on water, and any function of a few frequencies.

use std::fmt::Write;

use super::function::{Dimensions, Function};
use super::moment_mipmap::LARGEST;
use super::taps::{Pixel, Taps};
use crate::Error;

/// A wave: `amplitude` times the cosine of 2π times (frequency · position + phase).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Wave {
    /// Cycles a unit of the position along x and along y, up to ±1e6: a wave vector divided by 2π.
    pub frequency: [f32; 2],
    /// Half the distance from trough to crest, up to ±1e6.
    pub amplitude: f32,
    /// In turns, up to ±1e6: a moving wave has its frequency in time, in cycles, times the time here.
    pub phase: f32,
}

/// A driver that is a mean and a sum of cosines in the plane, as values, or as heights with their slopes.
///
/// The filtered function and its gradient are exact. What a footprint loses is known in one pass over the waves: the
/// variance, and the covariance of slopes, are exact for one wave and for waves of quite different lengths, and miss
/// part of what waves of about one length have in common. Relative errors of the deviation, root mean square over
/// footprints, for eight waves of up to four times the shortest frequency and of round footprints in wavelengths of the
/// middle one (`spirv-tests/tests/cosines/moments.rs` measures them again):
///
/// | footprint's deviation | ours | one deviation everywhere | slopes | one covariance everywhere |
/// |---|---|---|---|---|
/// | 0.05 | 0.035 | 0.43 | 0.04 | 0.36 |
/// | 0.15 | 0.115 | 0.32 | 0.13 | 0.25 |
/// | 0.3 | 0.15 | 0.23 | 0.13 | 0.16 |
/// | 1 | 0.09 | 0.09 | 0.05 | 0.05 |
///
/// Where time goes on, call `cosines_wave` of the shelf from a [`Custom`](crate::Custom) driver, or write phases into
/// the text.
///
/// ```
/// use prefilter::{ColorMap, Cosines, Driver, Scene, Wave};
/// let wave = |x: f32, y: f32, amplitude: f32| Wave { frequency: [x, y], amplitude, phase: 0.2 };
/// let waves = vec![wave(0.8, 0.1, 0.1), wave(1.7, -0.6, 0.04), wave(3.1, 1.2, 0.02)];
/// let steep = ColorMap::gradient([(0.0, [0.0, 0.1, 0.2]), (0.6, [0.5, 0.7, 0.7])])?;
/// let sea = Scene::new("sea").steepness(steep).driver(Driver::Cosines(Cosines { waves, ..Cosines::default() }));
/// assert!(sea.module()?.wgsl().contains("fn sea_surface("));
/// # Ok::<(), prefilter::Error>(())
/// ```
///
/// Default: no waves about the mean 0, by one tap and with a pixel deviation of 0.5.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Cosines {
    /// The waves, 1 to 64, which stand in the text.
    pub waves: Vec<Wave>,
    /// The value, or height, that the waves are about; up to ±1e15.
    pub mean: f32,
    /// Evaluations of the color a pixel.
    pub taps: Taps,
    /// The filter that turns samples into a pixel.
    pub pixel: Pixel,
}

/// Most waves of a sum: their terms are unrolled.
const MOST: usize = 64;
/// Largest number of a wave: squares of slopes stay far inside f32.
const LONGEST: f32 = 1e6;

impl Cosines {
    /// Whether the description can be used.
    ///
    /// # Errors
    /// [`Error::Size`] for no wave or too many, [`Error::Value`] for a number that is none or too large.
    pub(crate) fn check(&self) -> Result<(), Error> {
        self.pixel.check()?;
        if !(1..=MOST).contains(&self.waves.len()) {
            let what = "the number of waves".to_owned();
            return Err(Error::Size { what, count: self.waves.len(), allowed: format!("1 to {MOST}") });
        }
        for (index, wave) in self.waves.iter().enumerate() {
            let Wave { frequency: [x, y], amplitude, phase } = *wave;
            let named =
                [("frequency along x", x), ("frequency along y", y), ("amplitude", amplitude), ("phase", phase)];
            // Written so that NaN is refused.
            if let Some((name, value)) = named.into_iter().find(|(_, value)| !(value.abs() <= LONGEST)) {
                let what = format!("the {name} of wave {index}");
                return Err(Error::value(what, value, format!("-{LONGEST:e} to {LONGEST:e}")));
            }
        }
        if !(self.mean.abs() <= LARGEST) {
            return Err(Error::value("the waves' mean", self.mean, format!("-{LARGEST:e} to {LARGEST:e}")));
        }
        Ok(())
    }

    /// What it says of a footprint, as of values or as of heights.
    pub(crate) fn function(&self, slopes: bool) -> Function {
        let mut body = String::from("    var sum = cosines_sum();\n");
        for Wave { frequency: [x, y], amplitude, phase } in &self.waves {
            let phase = f64::from(*phase);
            let turns = (phase - phase.round()) as f32;
            // Writing to a String cannot fail.
            let _ = writeln!(
                body,
                "    sum = cosines_with(sum, cosines_wave(position, across, along, \
                 vec4f({x:?}, {y:?}, {amplitude:?}, {turns:?})));"
            );
        }
        if self.mean != 0.0 {
            let _ = writeln!(body, "    sum.mean += {:?};", self.mean);
        }
        let result = if slopes { "surface" } else { "moments" };
        let _ = writeln!(body, "    return cosines_{result}(sum, across, along);");
        let count = self.waves.len();
        Function {
            what: if count == 1 { "a wave".to_owned() } else { format!("a sum of {count} waves") },
            dimensions: Dimensions::Plane,
            body,
            surface: slopes,
            trips: 1,
            taps: self.taps,
            pixel: self.pixel,
            gap: gap(self.taps),
        }
    }
}

/// What a bound does not cover: the figures of a test of `spirv-tests`.
fn gap(taps: Taps) -> String {
    let (smooth, edged) = match taps {
        Taps::One => (0.012, 0.051),
        Taps::Two => (0.012, 0.038),
        Taps::Four => (0.008, 0.023),
        Taps::Eight => (0.007, 0.016),
    };
    format!(
        "how far waves over a footprint are from normal distributions. Color on a plane of\n    \
         twelve waves seen to the horizon has an RMS of {smooth:.3} with a smooth map and {edged:.3} with a narrow \
         stripe"
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn refuses_what_is_no_sum_of_waves() {
        let wave = Wave { frequency: [0.3, 0.1], amplitude: 0.2, phase: 0.0 };
        let sum = |waves: Vec<Wave>| Cosines { waves, ..Cosines::default() };
        for waves in [vec![], vec![wave; MOST + 1]] {
            assert!(matches!(sum(waves).check(), Err(Error::Size { .. })));
        }
        for one in [
            Wave { frequency: [f32::NAN, 0.0], ..wave },
            Wave { frequency: [0.0, 1e7], ..wave },
            Wave { amplitude: f32::INFINITY, ..wave },
            Wave { phase: f32::NAN, ..wave },
        ] {
            assert!(matches!(sum(vec![wave, one]).check(), Err(Error::Value { .. })), "{one:?}");
        }
        assert!(matches!(Cosines { mean: f32::NAN, ..sum(vec![wave]) }.check(), Err(Error::Value { .. })));
        assert_eq!(sum(vec![wave; MOST]).check(), Ok(()));
    }
}
