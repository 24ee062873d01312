//! Figures that carry their standard error, and the work of many seeds.

use std::fmt;
use std::panic::resume_unwind;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

/// Where chance makes no difference, bins of heights and five printed digits do.
const RESOLUTION: f64 = 5e-6;

/// A figure and its standard error over seeds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Figure {
    /// The figure of all seeds together.
    pub value: f64,
    /// Its standard error.
    pub error: f64,
}

impl Figure {
    /// Figures of pooled samples, with errors by the jackknife: each is figured again without one seed after another.
    pub fn jackknife<T, const N: usize>(seeds: &[T], figures: impl Fn(&[&T]) -> [f64; N]) -> [Self; N] {
        let values = figures(&seeds.iter().collect::<Vec<_>>());
        let without = |left_out: usize| -> [f64; N] {
            let rest = seeds.iter().enumerate().filter(|(index, _)| *index != left_out);
            figures(&rest.map(|(_, seed)| seed).collect::<Vec<_>>())
        };
        let partial: Vec<[f64; N]> = (0..seeds.len()).map(without).collect();
        let count = seeds.len() as f64;
        std::array::from_fn(|index| {
            let mean = partial.iter().map(|values| values[index]).sum::<f64>() / count;
            let squares: f64 = partial.iter().map(|values| (values[index] - mean).powi(2)).sum();
            Self { value: values[index], error: (squares * (count - 1.0) / count).sqrt() }
        })
    }

    /// Whether the error is below a third of the figure: others are not stated.
    pub fn stands(self) -> bool {
        3.0 * self.error.max(RESOLUTION) < self.value.abs()
    }

    /// The figure less a number.
    pub fn minus(self, known: f64) -> Self {
        Self { value: self.value - known, ..self }
    }
}

/// Digits to the precision, and nothing where the error is too large to state the figure.
impl fmt::Display for Figure {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let digits = formatter.precision().unwrap_or(5);
        if self.stands() {
            write!(formatter, "{:.digits$}", self.value)?;
        }
        Ok(())
    }
}

/// What a function gives for every seed, in order, by as many threads as there are processors.
pub fn over_seeds<T: Send>(seeds: usize, work: impl Fn(u64) -> T + Sync) -> Vec<T> {
    let next = AtomicUsize::new(0);
    let threads = thread::available_parallelism().map_or(1, usize::from).min(seeds);
    let worker = || {
        let mut done = Vec::new();
        loop {
            let seed = next.fetch_add(1, Ordering::Relaxed);
            if seed >= seeds {
                return done;
            }
            done.push((seed, work(seed as u64)));
        }
    };
    let mut done: Vec<(usize, T)> = thread::scope(|scope| {
        let workers: Vec<_> = (0..threads).map(|_| scope.spawn(worker)).collect();
        let joined = workers.into_iter().map(|worker| worker.join().unwrap_or_else(|panic| resume_unwind(panic)));
        joined.flatten().collect()
    });
    done.sort_by_key(|(seed, _)| *seed);
    done.into_iter().map(|(_, result)| result).collect()
}
