//! Times of modules over random pixels, beside each other.

use crate::random::Random;
use crate::report::filters::case::{Role, Row};
use crate::report::filters::height;
use crate::report::filters::pixel::{Drawn, Pixel};
use crate::report::timing::{fastest, TURNS};
use crate::report::{Bench, Error};
use prefilter::Module;

/// Pixels whose time is taken.
const PIXELS: usize = 1 << 14;

/// Milliseconds a megapixel of the first export of each module.
///
/// # Errors
/// What the device refuses.
pub fn times(bench: &Bench<'_>, modules: &[Module]) -> Result<Vec<f64>, Error> {
    let drawn = Drawn { slope: 0.3, slope_deviation: [0.05, 0.5], ..height::DRAWN };
    let mut random = Random::new(0xc057);
    let pixels: Vec<Pixel> = (0..1024).map(|_| drawn.pixel(&mut random)).collect();
    let pixels: Vec<Pixel> = pixels.into_iter().cycle().take(PIXELS).collect();
    let mut dispatches = Vec::new();
    for module in modules {
        let row = Row::of(Role::Tier, module.name(), module.clone());
        let kernel = row.kernel(bench.timed)?;
        dispatches.push(kernel.prepare(&row.points(&kernel, &pixels))?);
    }
    (bench.done)(1);
    let seconds = fastest(&dispatches, TURNS)?;
    (bench.done)(1);
    Ok(seconds.into_iter().map(|seconds| 1e9 * seconds / PIXELS as f64).collect())
}
