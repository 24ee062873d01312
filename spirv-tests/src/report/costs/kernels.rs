//! Times of modules over random pixels, beside each other.

use crate::random::Random;
use crate::report::filters::case::{Role, Row};
use crate::report::filters::height;
use crate::report::filters::pixel::{Drawn, Pixel};
use crate::report::timing::{fastest, filling, repeated, SHORT};
use crate::report::{Bench, Error};
use prefilter::Module;

/// Random pixels.
const PIXELS: usize = 1 << 10;

/// At least so many of them, over and over, are timed.
const TIMED: usize = 1 << 14;

/// Milliseconds a megapixel of the first export of each module.
///
/// # Errors
/// What the device refuses.
pub fn times(bench: &Bench<'_>, modules: &[Module]) -> Result<Vec<f64>, Error> {
    let drawn = Drawn { slope: 0.3, slope_deviation: [0.05, 0.5], ..height::DRAWN };
    let mut random = Random::new(0xc057);
    let pixels: Vec<Pixel> = (0..PIXELS).map(|_| drawn.pixel(&mut random)).collect();
    let (mut dispatches, mut counts) = (Vec::new(), Vec::new());
    for module in modules {
        let row = Row::of(Role::Tier, module.name(), module.clone());
        let kernel = row.kernel(bench.timed)?;
        let numbers = row.points(&kernel, &pixels);
        let (dispatch, count) = filling(TIMED, SHORT, |count| kernel.prepare(&repeated(&numbers, PIXELS, count)))?;
        dispatches.push(dispatch);
        counts.push(count);
    }
    (bench.done)(1);
    let seconds = fastest(&dispatches, bench.extent)?;
    (bench.done)(1);
    Ok(seconds.into_iter().zip(counts).map(|(seconds, count)| 1e9 * seconds / count as f64).collect())
}
