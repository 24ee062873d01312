//! Filters on the device at the points of a case, against the truth.

use std::panic::resume_unwind;

use prefilter::gpu::Device;
use prefilter::{Export, Module};

use super::cases::Case;
use super::filters::{Filter, Map};
use super::outcome::Outcome;
use super::points::Point;
use super::promise::Promised;
use super::subject::Subject;
use crate::exports::ExportKernel;
use crate::report::cache::Cache;

/// What makes truths and promises besides what all parts share.
const PROGRAM: [&str; 6] = [
    include_str!("covers.rs"),
    include_str!("filters.rs"),
    include_str!("points.rs"),
    include_str!("promise.rs"),
    include_str!("subject.rs"),
    include_str!("truth.rs"),
];

/// The numbers of a point: its truth, what a bound is from, and the bound; NaN where there is none.
const NUMBERS: usize = 9;

/// A filter with a map, compiled.
struct Compiled {
    map: Map,
    subject: Subject,
    module: Module,
    promised: Promised,
    kernel: ExportKernel,
}

impl Compiled {
    fn new(device: &Device, filter: Filter, map: Map) -> Result<Self, String> {
        let failed = |error: &dyn std::fmt::Display| format!("{} of {map:?}: {error}", filter.name());
        let subject = Subject::new(filter, map).map_err(|error| failed(&error))?;
        let module = subject.scene.module().map_err(|error| failed(&error))?;
        let kernel = ExportKernel::new(device, &module, export(&module, filter)).map_err(|error| failed(&error))?;
        let promised = Promised::new(&subject, &module)?;
        Ok(Self { map, subject, module, promised, kernel })
    }

    fn outcome(&self, cache: &Cache, case: Case, count: usize) -> Result<Outcome, String> {
        let filter = self.subject.filter;
        let export = export(&self.module, filter);
        let points = Point::all(case, &self.subject.place(), count);
        let numbers: Vec<f32> = points.iter().flat_map(|point| point.numbers(&export.parameters())).collect();
        if case != Case::NoNumbers && numbers.iter().any(|number| number.is_nan()) {
            return Err(format!("{} in the case {case:?}: an input is no number", filter.name()));
        }
        let results = self.kernel.run(&numbers).map_err(|error| error.to_string())?;
        let channels = if export.result() == "f32" { 1 } else { 3 };
        let (low, high, slack) = self.subject.hull();
        let mut outcome = Outcome::new(filter.name(), case);
        let truths = self.truths(cache, &points)?;
        for ((point, result), judged) in points.iter().zip(&results).zip(truths.chunks(NUMBERS)) {
            let result = result.map(f64::from);
            let inside = |channel: usize| {
                (low[channel] - slack..=high[channel] + slack).contains(&result[channel]) && result[channel].is_finite()
            };
            outcome.count(point, (0..channels).all(inside));
            let judged: Vec<f64> = judged.iter().copied().map(f64::from).collect();
            let (truth, counted, bound) = (&judged[..channels], &judged[4..4 + channels], judged[NUMBERS - 1]);
            if !truth[0].is_nan() {
                outcome.judge(point, &result[..channels], truth, (!bound.is_nan()).then_some((counted, bound)));
            }
        }
        Ok(outcome)
    }

    /// The truths and promises of points, those kept or else made on all processors.
    fn truths(&self, cache: &Cache, points: &[Point]) -> Result<Vec<f32>, String> {
        // What is promised to its last bit: it is kept beside the truths.
        let said = format!("{} {:?} {:?} {points:?}", self.subject.filter.name(), self.map, self.promised);
        let inputs = [&PROGRAM[..], &[self.module.explain(), &said]].concat();
        let threads = std::thread::available_parallelism().map_or(1, usize::from);
        let share = points.len().div_ceil(threads).max(1);
        cache.numbers(&inputs, NUMBERS * points.len(), || {
            std::thread::scope(|scope| {
                let part = |points: &'_ [Point]| points.iter().map(|point| self.judged(point)).collect::<Vec<_>>();
                let threads: Vec<_> = points.chunks(share).map(|points| scope.spawn(move || part(points))).collect();
                let joined =
                    threads.into_iter().map(|thread| thread.join().unwrap_or_else(|panic| resume_unwind(panic)));
                joined.flatten().collect::<Result<Vec<_>, _>>().map(|numbers| numbers.concat())
            })
        })
    }

    /// The numbers of a point.
    fn judged(&self, point: &Point) -> Result<[f32; NUMBERS], String> {
        let mut numbers = [f64::NAN; NUMBERS];
        let Some((near, truth)) = point.nearest().and_then(|near| Some((near, self.subject.truth(&near)?))) else {
            return Ok(numbers.map(|number| number as f32));
        };
        if !truth.iter().all(|channel| channel.is_finite()) {
            return Err(format!("{} has no truth at {point:?}: {truth:?}", self.subject.filter.name()));
        }
        numbers[..4].copy_from_slice(&truth);
        if let Some((counted, bound)) = self.promised.at(&self.subject, &near, truth) {
            numbers[4..8].copy_from_slice(&counted);
            numbers[NUMBERS - 1] = bound;
        }
        Ok(numbers.map(|number| number as f32))
    }
}

/// The export of a filter: shares that are lit come second.
fn export(module: &Module, filter: Filter) -> &Export {
    &module.exports()[usize::from(filter == Filter::Visibility)]
}

/// Measures a filter in every case that has a meaning for it, each at so many points.
///
/// # Errors
/// A message where a scene cannot be made, the device refuses it or the reference has no value.
pub fn outcomes(device: &Device, cache: &Cache, filter: Filter, count: usize) -> Result<Vec<Outcome>, String> {
    let mut compiled: Vec<Compiled> = Vec::new();
    let mut outcomes = Vec::new();
    for case in Case::ALL {
        let Some(map) = filter.map(case) else { continue };
        if !compiled.iter().any(|made| made.map == map) {
            compiled.push(Compiled::new(device, filter, map)?);
        }
        for made in compiled.iter().filter(|made| made.map == map) {
            outcomes.push(made.outcome(cache, case, count)?);
        }
    }
    Ok(outcomes)
}
