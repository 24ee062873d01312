//! Drivers in hard cases: the mean that they find, against the truth.

use std::f64::consts::TAU;

use prefilter::gpu::Device;
use prefilter::reference::cosines;
use prefilter::reference::crossing::line;
use prefilter::reference::footprint::deviations;
use prefilter::reference::gabor_spectrum::Spectrum as Ranges;
use prefilter::reference::pulse::Footprint as Pulse;
use prefilter::reference::retained::Noise as Retained;
use prefilter::reference::{gabor, perlin};
use prefilter::{ColorMap, Cosines, Driver, Gabor, Motif, Noise, Pattern, Scene, Spectrum, Wave};

use super::cases::Case;
use super::footprints::Footprint;
use super::outcome::Outcome;
use super::pyramids;
use crate::contract::{Contract, Promise};
use crate::exports::ExportKernel;
use crate::kernel::Function;

/// What knows a footprint.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Source {
    /// One octave of Perlin's noise, whose filter is that of its model.
    Noise,
    /// Solid Gabor noise.
    Gabor,
    /// Stripes.
    Pattern,
    /// Three waves.
    Cosines,
    /// The pyramid of an image.
    Moments,
    /// That of four moments.
    FourMoments,
    /// That of a map of slopes: mean and covariance.
    SlopeMoments,
}

/// The share of stripes, and that of narrow ones.
const DUTIES: [f32; 2] = [0.3, 1.0 / 256.0];

/// The side of a cell of Gabor noise.
const CELL: f64 = 0.8;

/// What a value up to 1 loses as a half, and any mean of such.
const HALF: f64 = 1.0 / 4096.0;

/// What a covariance of such loses: four of those, of products of two distances up to 1 that are off by twice that, and
/// a quarter of one of its own.
const HALF_COVARIANCE: f64 = 4.25 * HALF;

/// The variance of one octave of Perlin's noise.
const PERLIN: f64 = 0.046_531_150_4;

impl Source {
    /// All of them, in the report's order.
    pub const ALL: [Self; 7] =
        [Self::Noise, Self::Gabor, Self::Pattern, Self::Cosines, Self::Moments, Self::FourMoments, Self::SlopeMoments];

    /// Its name in tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::Noise => "noise",
            Self::Gabor => "gabor",
            Self::Pattern => "pattern",
            Self::Cosines => "cosines",
            Self::Moments => "moments",
            Self::FourMoments => "four moments",
            Self::SlopeMoments => "slope moments",
        }
    }

    /// Whether a case has a meaning: no driver has a view or takes moments, noise and waves have no edges and no
    /// stripes, and only pyramids hold halves or have texels.
    pub fn meets(self, case: Case) -> bool {
        match case {
            Case::BelowHorizon | Case::OneDirection | Case::Rounded => false,
            Case::HardEdges | Case::Stripes => self == Self::Pattern || self.reads(),
            Case::HalfTables | Case::OneTexel => self.reads(),
            Case::Grazing
            | Case::NoDeviation
            | Case::HugeDeviation
            | Case::NearSingular
            | Case::WideFootprints
            | Case::Denormals
            | Case::FarFromOrigin
            | Case::NoNumbers => true,
        }
    }

    /// Whether it reads the pyramid of an image.
    fn reads(self) -> bool {
        matches!(self, Self::Moments | Self::FourMoments | Self::SlopeMoments)
    }

    fn driver(self, case: Case) -> Option<Driver> {
        Some(match self {
            Self::Noise => Driver::Noise(Noise { octaves: 1, mean: 0.0, deviation: 1.0, ..Noise::default() }),
            Self::Gabor => {
                let spectrum = Spectrum::Isotropic { frequency: 1.3 };
                Driver::Gabor(Gabor { spectrum, mean: 0.0, deviation: 1.0, ..Gabor::default() })
            }
            Self::Pattern => {
                Driver::Pattern(Pattern { motif: Motif::Stripes { duty: duty(case) }, ..Pattern::default() })
            }
            Self::Cosines => Driver::Cosines(Cosines { waves: waves(), mean: 0.0, ..Cosines::default() }),
            Self::Moments | Self::FourMoments | Self::SlopeMoments => return None,
        })
    }

    /// How far the shelf's contracts let a mean be from the truth; of waves no contract says it, but the documentation
    /// of `cosines_wave`.
    ///
    /// # Errors
    /// A message where a contract has no absolute error.
    pub fn contract(self) -> Result<f64, String> {
        let (function, most) = match self {
            Self::Pattern => ("pulse_train", 1.0),
            Self::Noise => ("perlin_filter", 1.0 / PERLIN.sqrt()),
            Self::Moments => ("moments_read", 1.0),
            Self::FourMoments => ("four_moments_read", 1.0),
            Self::SlopeMoments => ("slope_moments_read", 1.0),
            Self::Gabor => ("gabor_noise", 1.0),
            Self::Cosines => return Ok(0.0),
        };
        match Contract::of(&Function::of_shelf(function)?)?.promise {
            Promise::Absolute(error) => Ok(error * most),
            other => Err(format!("`{function}` promises {other:?}")),
        }
    }

    /// How far a mean may be off besides: of halves what they lose, of waves all.
    ///
    /// Positions are the device's numbers, and whole parts of far ones are told without rounding by all but waves.
    pub fn besides(self, case: Case, footprint: &Footprint) -> f64 {
        match (case, self) {
            (_, Self::Cosines) => waves().into_iter().map(|wave| rounded(wave, footprint)).sum(),
            (Case::HalfTables, Self::SlopeMoments) => HALF_COVARIANCE,
            (Case::HalfTables, _) => HALF,
            _ => 0.0,
        }
    }

    /// How far a mean may be from 0: the hull of what there is.
    fn hull(self) -> [f64; 2] {
        match self {
            // A corner of a cell has a line of slope 1, four of them up to 1 in all; of deviations.
            Self::Noise => [-1.0 / PERLIN.sqrt(), 1.0 / PERLIN.sqrt()],
            Self::Gabor => [f64::MIN, f64::MAX],
            Self::Pattern | Self::Moments | Self::FourMoments | Self::SlopeMoments => [0.0, 1.0],
            Self::Cosines => {
                let most = waves().iter().map(|wave| f64::from(wave.amplitude)).sum::<f64>() * (1.0 + 1e-6);
                [-most, most]
            }
        }
    }

    fn truth(self, case: Case, footprint: &Footprint) -> f64 {
        let Footprint { position, across, along } = footprint;
        let [x, y, _] = *position;
        match self {
            Self::Noise => {
                // Narrower ones keep, and wider ones lose, all but 1e-5.
                let kept = deviations(footprint.covariance()).map(|deviation| deviation.clamp(1e-3, 30.0));
                perlin::noise([x, y], [0; 2], 0) * Retained::Perlin.filter(kept)[0] / PERLIN.sqrt()
            }
            Self::Gabor => {
                let spectrum = Ranges { frequency: [1.3f32.into(), 0.0], azimuth: [0.0, TAU], height: [-1.0, 2.0] };
                let spectrum = Ranges { frequency: spectrum.frequency.map(|part| part * CELL), ..spectrum };
                let cells = position.map(|part| f64::from(part as f32 * 1.25));
                let scaled = [across, along].map(|vector| vector.map(|part| part / CELL));
                gabor::noise(cells, Gabor::default().kernels, Gabor::default().seed, &spectrum, scaled).0
            }
            Self::Pattern => {
                let (duty, deviation) = (f64::from(duty(case)), across[0].hypot(along[0]));
                match deviation {
                    narrow if narrow < 1e-12 => f64::from(u8::from(x - x.floor() < duty)),
                    narrow if narrow < 1.2 => Pulse::Gaussian(narrow).train(x, duty),
                    wide => line(x, duty, wide),
                }
            }
            Self::Cosines => {
                let waves: Vec<cosines::Wave> = waves().into_iter().map(exact).collect();
                let flat = |[x, y, _]: [f64; 3]| [x, y];
                cosines::surface(&waves, [x, y], flat(*across), flat(*along)).mean
            }
            // Those have truths of their own.
            Self::Moments | Self::FourMoments | Self::SlopeMoments => f64::NAN,
        }
    }
}

fn duty(case: Case) -> f32 {
    DUTIES[usize::from(case == Case::Stripes)]
}

fn waves() -> Vec<Wave> {
    let wave = |frequency, amplitude, phase| Wave { frequency, amplitude, phase };
    vec![wave([0.8, 0.1], 0.2, 0.3), wave([-1.7, 2.3], 0.1, 0.7), wave([0.3, -0.6], 0.15, 0.05)]
}

/// How far the mean of a wave may be off, as `cosines_wave` says.
fn rounded(wave: Wave, footprint: &Footprint) -> f64 {
    let cosines::Wave { frequency: [x, y], amplitude, phase } = exact(wave);
    let [across, along, _] = footprint.position;
    amplitude * (1e-6 + 1.2e-6 * ((x * across).abs() + (y * along).abs() + phase.abs()))
}

fn exact(wave: Wave) -> cosines::Wave {
    let Wave { frequency, amplitude, phase } = wave;
    cosines::Wave { frequency: frequency.map(f64::from), amplitude: amplitude.into(), phase: phase.into() }
}

/// Measures a driver in every case that has a meaning for it, each over so many footprints.
///
/// # Errors
/// A message where a scene or an image cannot be made, or the device refuses it.
pub fn outcomes(device: &Device, source: Source, count: usize) -> Result<Vec<Outcome>, String> {
    let cases = Case::ALL.into_iter().filter(|case| source.meets(*case));
    cases
        .map(|case| {
            if source.reads() {
                pyramids::read(device, source, case, count)
            } else {
                driven(device, source, case, count)
            }
        })
        .collect()
}

/// A driver by its statistics.
fn driven(device: &Device, source: Source, case: Case, count: usize) -> Result<Outcome, String> {
    let failed = |error: prefilter::Error| format!("{}: {error}", source.name());
    let driver = source.driver(case).ok_or("no driver")?;
    let map = ColorMap::gradient([(0.0, [0.0; 3]), (1.0, [1.0; 3])]).map_err(failed)?;
    let module = Scene::new("hard").texture(map).driver(driver).module().map_err(failed)?;
    let export = module.exports().iter().find(|export| export.name.ends_with("_statistics")).ok_or("no statistics")?;
    let edge = (source == Source::Pattern).then(|| f64::from(duty(case)));
    let footprints = Footprint::all(case, edge, count);
    let dimensions = if source == Source::Gabor { 3 } else { 2 };
    let numbers: Vec<f32> = footprints.iter().flat_map(|footprint| footprint.numbers(dimensions)).collect();
    let found = ExportKernel::new(device, &module, export).and_then(|kernel| kernel.run(&numbers)).map_err(failed)?;
    let mut outcome = Outcome::new(source.name(), case);
    let ([low, high], contract) = (source.hull(), source.contract()?);
    for (footprint, [mean, variance, ..]) in footprints.iter().zip(found) {
        let mean = f64::from(mean);
        let sound = (low..=high).contains(&mean) && mean.is_finite() && variance.is_finite() && variance >= 0.0;
        outcome.count(footprint, sound);
        if case != Case::NoNumbers {
            let (truth, promised) = ([source.truth(case, footprint)], contract + source.besides(case, footprint));
            outcome.judge(footprint, &[mean], &truth, Some((&truth, promised)));
        }
    }
    Ok(outcome)
}
