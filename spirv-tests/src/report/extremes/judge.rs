//! Filters on the device at the points of a case, against the truth.

use std::panic::resume_unwind;

use prefilter::gpu::Device;
use prefilter::{Export, Module};

use super::cases::Case;
use super::filters::{Filter, Map};
use super::outcome::Outcome;
use super::points::Point;
use super::subject::Subject;
use crate::exports::ExportKernel;

/// A filter with a map, compiled.
struct Compiled {
    map: Map,
    subject: Subject,
    module: Module,
    kernel: ExportKernel,
}

impl Compiled {
    fn new(device: &Device, filter: Filter, map: Map) -> Result<Self, String> {
        let failed = |error: &dyn std::fmt::Display| format!("{} of {map:?}: {error}", filter.name());
        let subject = Subject::new(filter, map).map_err(|error| failed(&error))?;
        let module = subject.scene.module().map_err(|error| failed(&error))?;
        let kernel = ExportKernel::new(device, &module, export(&module, filter)).map_err(|error| failed(&error))?;
        Ok(Self { map, subject, module, kernel })
    }

    fn outcome(&self, case: Case, count: usize) -> Result<Outcome, String> {
        let filter = self.subject.filter;
        let export = export(&self.module, filter);
        let points = Point::all(case, &self.subject.place(), count);
        let numbers: Vec<f32> = points.iter().flat_map(|point| point.numbers(&export.parameters())).collect();
        if numbers.iter().any(|number| number.is_nan()) {
            return Err(format!("{} in the case {case:?}: an input is no number", filter.name()));
        }
        let results = self.kernel.run(&numbers).map_err(|error| error.to_string())?;
        let channels = if export.result() == "f32" { 1 } else { 3 };
        let (low, high, slack) = self.subject.hull();
        let bound = (filter != Filter::Visibility).then(|| f64::from(self.module.bound().value()));
        let mut outcome = Outcome::new(filter.name(), case, bound);
        for ((point, result), truth) in points.iter().zip(&results).zip(&self.truths(&points)) {
            let result = result.map(f64::from);
            let inside = |channel: usize| {
                (low[channel] - slack..=high[channel] + slack).contains(&result[channel]) && result[channel].is_finite()
            };
            outcome.count(point, (0..channels).all(inside));
            let Some(truth) = truth else { continue };
            if !truth[..channels].iter().all(|channel| channel.is_finite()) {
                return Err(format!("{} has no truth at {point:?}: {truth:?}", filter.name()));
            }
            outcome.judge(point, &result[..channels], &truth[..channels], self.subject.promises(point));
        }
        Ok(outcome)
    }

    /// The truths, on all processors.
    fn truths(&self, points: &[Point]) -> Vec<Option<[f64; 4]>> {
        let threads = std::thread::available_parallelism().map_or(1, usize::from);
        let share = points.len().div_ceil(threads).max(1);
        std::thread::scope(|scope| {
            let part = |points: &'_ [Point]| points.iter().map(|point| self.subject.truth(point)).collect::<Vec<_>>();
            let threads: Vec<_> = points.chunks(share).map(|points| scope.spawn(move || part(points))).collect();
            let joined = threads.into_iter().map(|thread| thread.join().unwrap_or_else(|panic| resume_unwind(panic)));
            joined.flatten().collect()
        })
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
pub fn outcomes(device: &Device, filter: Filter, count: usize) -> Result<Vec<Outcome>, String> {
    let mut compiled: Vec<Compiled> = Vec::new();
    let mut outcomes = Vec::new();
    for case in Case::ALL {
        let Some(map) = filter.map(case) else { continue };
        if !compiled.iter().any(|made| made.map == map) {
            compiled.push(Compiled::new(device, filter, map)?);
        }
        for made in compiled.iter().filter(|made| made.map == map) {
            outcomes.push(made.outcome(case, count)?);
        }
    }
    Ok(outcomes)
}
