//! Runs a function of a shader on the device and judges it by its contract.
//!
//! Comparisons are written so that NaN fails, an output starts as NaN, no case at all is a failure, and so is a promise
//! that is much wider than what the pinned driver does.

use std::fmt;
use std::panic::resume_unwind;

use prefilter::gpu::{Device, Texture};

use crate::contract::{Contract, Promise};
use crate::fill;
use crate::kernel::Function;
use crate::rows::Row;

/// Points of the fill for each row, special points aside.
pub const FILL: usize = 100_000;

/// A promise may be this many times wider than what is measured on the pinned driver.
pub const SLACK: f64 = 4.0;

/// Below so many times the least normal number, steps on the way to a result may have been flushed.
const FLUSHED: f64 = 64.0;

/// One point with what the device and the reference say.
#[derive(Clone, Debug, PartialEq)]
pub struct Case {
    /// The numbers that the function took.
    pub point: Vec<f64>,
    /// What the device returned.
    pub got: Vec<f64>,
    /// What the reference returns.
    pub expected: Vec<f64>,
    /// How far apart they are in the promise's measure; infinite for NaN.
    pub error: f64,
}

/// What was measured of one function.
#[derive(Clone, Debug, PartialEq)]
pub struct Judgement {
    /// The function.
    pub name: String,
    /// The names of the numbers that it takes.
    pub inputs: Vec<String>,
    /// Its promise.
    pub promise: Promise,
    /// Judged points.
    pub cases: usize,
    /// Points where only a finite result was asked for.
    pub outside: usize,
    /// The judged point with the largest error.
    pub worst: Case,
}

/// Why a function does not keep its contract, or cannot be judged.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Failure {
    /// A clause is missing or not understood.
    #[error("{0}")]
    Contract(String),
    /// The function has no row.
    #[error("`{0}` has no row in spirv-tests/src/rows")]
    NoRow(String),
    /// The device refused the function.
    #[error("{0}")]
    Device(String),
    /// Nothing, or too little, was compared.
    #[error("`{name}`: {cases} of {points} points were judged, which is less than a quarter")]
    NoCases {
        /// The function.
        name: String,
        /// Judged points.
        cases: usize,
        /// All points.
        points: usize,
    },
    /// The promise does not hold.
    #[error("the promise is broken: {0}")]
    Broken(Box<Judgement>),
    /// The promise is too wide.
    #[error("the promise is more than {SLACK} times too wide: {0}")]
    Slack(Box<Judgement>),
    /// A result outside the domain is not finite.
    #[error("`{name}` is not finite outside its domain: {case}")]
    NotFinite {
        /// The function.
        name: String,
        /// The numbers in and out.
        case: String,
    },
}

impl fmt::Display for Judgement {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { name, inputs, promise, cases, outside, worst } = self;
        let promise = match promise {
            Promise::Absolute(bound) => format!("{bound:e} absolute"),
            Promise::Relative(bound) => format!("{bound:e} relative"),
            Promise::Mixed(bound) => format!("{bound:e} of 1 + the result"),
            Promise::Exact => "exact".to_owned(),
        };
        write!(formatter, "{name:<28} {:.1e} of {promise:<18} in {cases} + {outside} points, ", worst.error)?;
        let Case { point, got, expected, .. } = worst;
        write!(formatter, "worst at {}: got {got:?}, expected {expected:?}", named(inputs, point))
    }
}

/// The numbers of a point with their names.
fn named(inputs: &[String], point: &[f64]) -> String {
    let numbers = inputs.iter().zip(point).map(|(name, value)| format!("{name} = {value:e}"));
    numbers.collect::<Vec<_>>().join(", ")
}

/// Judges a function by all its rows, each with a fill of `count` points.
///
/// # Errors
/// The first [`Failure`].
pub fn judge(device: &Device, function: &Function, rows: &[&Row], count: usize) -> Result<Judgement, Failure> {
    let contract = Contract::of(function).map_err(Failure::Contract)?;
    let points = fill::points(&contract.ranges, count);
    let mut judgement: Option<Judgement> = None;
    for row in rows {
        let mut inside = points.inside.clone();
        inside.extend(row.breakpoints(&contract.ranges).map_err(Failure::Contract)?);
        let textures = row.tables.iter().map(|(table, address)| device.upload(table, *address));
        let textures = textures.collect::<Result<Vec<Texture>, _>>();
        let textures = textures.map_err(|error| Failure::Device(error.to_string()))?;
        let textures: Vec<&Texture> = textures.iter().collect();
        let run = |points: &[Vec<f64>]| function.results(device, &textures, points).map_err(Failure::Device);
        finite(function, &points.outside, &run(&points.outside)?)?;
        let mut next = compare(function, contract.promise, row, &inside, &run(&inside)?)?;
        next.outside = points.outside.len();
        judgement = Some(match judgement {
            None => next,
            Some(before) => merged(before, next),
        });
    }
    let judgement = judgement.ok_or_else(|| Failure::NoRow(function.name.clone()))?;
    if is_pinned(device) && is_slack(&judgement) {
        Err(Failure::Slack(Box::new(judgement)))
    } else {
        Ok(judgement)
    }
}

/// Whether a device is the pinned driver: that of which promises may not be slack, and its faults are known.
pub fn is_pinned(device: &Device) -> bool {
    device.label().contains("llvmpipe")
}

fn merged(before: Judgement, next: Judgement) -> Judgement {
    let (cases, outside) = (before.cases + next.cases, before.outside + next.outside);
    let worse = if next.worst.error > before.worst.error { next } else { before };
    Judgement { cases, outside, ..worse }
}

/// Whether the promise is much wider than what was measured.
fn is_slack(judgement: &Judgement) -> bool {
    match judgement.promise {
        Promise::Absolute(bound) | Promise::Relative(bound) | Promise::Mixed(bound) => {
            bound > SLACK * judgement.worst.error
        }
        Promise::Exact => false,
    }
}

/// Compares results with a row's reference, on all processors.
///
/// # Errors
/// [`Failure::NoCases`] where less than a quarter of the points are judged, [`Failure::Broken`] where a result is too
/// far from the reference.
pub fn compare(
    function: &Function,
    promise: Promise,
    row: &Row,
    points: &[Vec<f64>],
    results: &[Vec<f64>],
) -> Result<Judgement, Failure> {
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    let share = points.len().div_ceil(threads).max(1);
    let parts = points.chunks(share).zip(results.chunks(share));
    let parts: Vec<(usize, Option<Case>)> = std::thread::scope(|scope| {
        let threads: Vec<_> =
            parts.map(|(points, results)| scope.spawn(move || worst(promise, row, points, results))).collect();
        let joined = threads.into_iter().map(|thread| thread.join().unwrap_or_else(|panic| resume_unwind(panic)));
        joined.collect()
    });
    let cases: usize = parts.iter().map(|part| part.0).sum();
    let worst = parts.into_iter().filter_map(|part| part.1).max_by(|a, b| a.error.total_cmp(&b.error));
    let enough = points.len() == results.len() && 4 * cases >= points.len();
    let (Some(worst), true) = (worst, enough) else {
        return Err(Failure::NoCases { name: function.name.clone(), cases, points: points.len() });
    };
    let inputs = function.signature.inputs().into_iter().map(|leaf| leaf.path).collect();
    let judgement = Judgement { name: function.name.clone(), inputs, promise, cases, outside: 0, worst };
    let kept = match promise {
        Promise::Absolute(bound) | Promise::Relative(bound) | Promise::Mixed(bound) => judgement.worst.error <= bound,
        Promise::Exact => judgement.worst.error == 0.0,
    };
    if kept {
        Ok(judgement)
    } else {
        Err(Failure::Broken(Box::new(judgement)))
    }
}

/// The number of judged points and the worst of them.
fn worst(promise: Promise, row: &Row, points: &[Vec<f64>], results: &[Vec<f64>]) -> (usize, Option<Case>) {
    let mut cases = 0;
    let mut worst: Option<Case> = None;
    for (point, got) in points.iter().zip(results).filter(|(point, _)| row.judges(point)) {
        cases += 1;
        let expected = row.expected(point, got);
        let error = error(promise, got, &expected);
        if worst.as_ref().is_none_or(|worst| error > worst.error) {
            worst = Some(Case { point: point.clone(), got: got.clone(), expected, error });
        }
    }
    (cases, worst)
}

/// The largest distance of two results in the promise's measure; infinite where one is NaN or a component is missing.
///
/// WGSL lets a device flush subnormal results of every step: near the least normal number a zero is no error.
pub(crate) fn error(promise: Promise, got: &[f64], expected: &[f64]) -> f64 {
    if got.len() != expected.len() {
        return f64::INFINITY;
    }
    let normal = FLUSHED * f64::from(f32::MIN_POSITIVE);
    let largest = expected.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
    let scale = match promise {
        Promise::Relative(_) => largest.max(normal),
        Promise::Mixed(_) => 1.0 + largest,
        Promise::Absolute(_) | Promise::Exact => 1.0,
    };
    got.iter().zip(expected).fold(0.0, |most: f64, (got, expected)| {
        let flushed = *got == 0.0 && expected.abs() < normal;
        let distance = if flushed { 0.0 } else { (got - expected).abs() / scale };
        if distance.is_nan() {
            f64::INFINITY
        } else {
            most.max(distance)
        }
    })
}

/// Asks for finite results.
///
/// # Errors
/// [`Failure::NotFinite`] with the first point whose result is not, [`Failure::NoCases`] where results are missing.
pub fn finite(function: &Function, points: &[Vec<f64>], results: &[Vec<f64>]) -> Result<(), Failure> {
    if points.len() != results.len() {
        return Err(Failure::NoCases { name: function.name.clone(), cases: results.len(), points: points.len() });
    }
    let wrong = points.iter().zip(results).find(|(_, got)| !got.iter().all(|value| value.is_finite()));
    let Some((point, got)) = wrong else { return Ok(()) };
    let inputs: Vec<String> = function.signature.inputs().into_iter().map(|leaf| leaf.path).collect();
    let case = format!("{} gives {got:?}", named(&inputs, point));
    Err(Failure::NotFinite { name: function.name.clone(), case })
}
