//! How long does a scene take to become a validated module? Fails above 5 ms.
//!
//! Tables are left out: baking one takes longer, and `Scene::module` says so.
#![deny(missing_docs)]

use std::time::Instant;

use prefilter::{Kernel, Scene, Tier};
use spirv_tests::maps::named;

const LIMIT: f64 = 5e-3;
const RUNS: usize = 101;

fn main() -> Result<(), Box<dyn std::error::Error + Send + Sync>> {
    let entry = "@fragment fn main() -> @location(0) vec4f { return vec4f(judged_texture(0.5, 0.1), 1.0); }";
    for name in ["terrain", "steps6", "gist_earth"] {
        for kernel in [Kernel::Fast, Kernel::Exact] {
            let scene = Scene::new("judged").texture(named(name)?).tier(Tier::ClosedForm(kernel));
            let module = median(|| scene.module().map(|_| ()))?;
            let made = scene.module()?;
            let link = median(|| made.link(entry).map(|_| ()))?;
            println!("{name}, {kernel:?}: module {:.2} ms, link {:.2} ms", 1e3 * module, 1e3 * link);
            if module.max(link) > LIMIT {
                return Err(format!("{name} takes more than {LIMIT} s").into());
            }
        }
    }
    Ok(())
}

/// Seconds of the median run.
fn median(mut run: impl FnMut() -> Result<(), prefilter::Error>) -> Result<f64, prefilter::Error> {
    let mut seconds = Vec::new();
    for _ in 0..RUNS {
        let start = Instant::now();
        run()?;
        seconds.push(start.elapsed().as_secs_f64());
    }
    seconds.sort_by(f64::total_cmp);
    Ok(seconds[RUNS / 2])
}
