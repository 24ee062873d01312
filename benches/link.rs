//! How long does a scene take to become a validated module, and a module to be linked? Fails above 5 ms.
//!
//! Tables are left out: baking one takes longer, and `Scene::module` says so.
#![deny(missing_docs)]

use std::time::Instant;

use prefilter::{ColorMap, Error, Kernel, Scene, Tier};

const LIMIT: f64 = 5e-3;
const RUNS: usize = 101;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let entry = "@fragment fn main() -> @location(0) vec4f { return vec4f(judged_texture(0.5, 0.1), 1.0); }";
    for stops in [4, 6, 32] {
        for kernel in [Kernel::Fast, Kernel::Exact] {
            let scene = Scene::new("judged").texture(gradient(stops)?).tier(Tier::ClosedForm(kernel));
            let module = median(|| scene.module().map(|_| ()))?;
            let made = scene.module()?;
            let link = median(|| made.link(entry).map(|_| ()))?;
            println!("{stops} stops, {kernel:?}: module {:.2} ms, link {:.2} ms", 1e3 * module, 1e3 * link);
            if module.max(link) > LIMIT {
                return Err(format!("{stops} stops take more than {LIMIT} s").into());
            }
        }
    }
    Ok(())
}

/// A gradient of uneven stops and colors, every fourth a hard edge.
fn gradient(stops: usize) -> Result<ColorMap, Error> {
    let part = |index: usize, step: f32| (index as f32 * step).fract();
    ColorMap::gradient((0..stops).map(|index| {
        let position = (index - usize::from(index % 4 == 3)) as f32 / stops as f32;
        (position, [part(index, 0.618_034), part(index, 0.754_878), part(index, 0.569_84)])
    }))
}

/// Seconds of the median run.
fn median(mut run: impl FnMut() -> Result<(), Error>) -> Result<f64, Error> {
    let mut seconds = Vec::new();
    for _ in 0..RUNS {
        let start = Instant::now();
        run()?;
        seconds.push(start.elapsed().as_secs_f64());
    }
    seconds.sort_by(f64::total_cmp);
    Ok(seconds[RUNS / 2])
}
