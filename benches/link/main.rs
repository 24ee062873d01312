//! How long does a scene take to become a validated module, and modules to be linked and written as SPIR-V? Asked are
//! 5 ms, and 100 ms for all tables of a scene with all filters. Fails where a machine takes one and a half times as
//! long.
//!
//! What is measured is the time of one core, on which all threads take turns where the system lets them. It is stated
//! for the median run and for the fastest, which is judged: nothing disturbed it.
#![deny(missing_docs)]

mod filters;
mod one_core;

use one_core::{on_one_core, processor};
use prefilter::{ColorMap, Error, Kernel, Module, Scene, Tier};

/// Seconds of a link that are asked.
const LINKED: f64 = 5e-3;
/// Those of all tables.
const BAKED: f64 = 0.1;
/// How many times as long a slow machine may take: of two of a kind one took 1.7 times as long as the other.
const SLOWER: f64 = 1.5;
const RUNS: usize = 101;
const BAKED_RUNS: usize = 7;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    on_one_core(|| closed_forms().and_then(|()| all_filters()))?
}

/// Scenes of values, without tables.
fn closed_forms() -> Result<(), Box<dyn std::error::Error>> {
    let entry = "@fragment fn main() -> @location(0) vec4f { return vec4f(judged_texture(0.5, 0.1), 1.0); }";
    for stops in [4, 6, 32] {
        for kernel in [Kernel::Fast, Kernel::Exact] {
            let scene = Scene::new("judged").texture(gradient(stops)?).tier(Tier::ClosedForm(kernel));
            let module = Time::of(RUNS, || scene.module().map(|_| ()))?;
            let made = scene.module()?;
            let link = Time::of(RUNS, || made.link(entry).map(|_| ()))?;
            println!("{stops} stops, {kernel:?}: module {module}, link {link}");
            if module.fastest.max(link.fastest) > SLOWER * LINKED {
                return Err(format!("{stops} stops take more than {SLOWER} times {LINKED} s").into());
            }
        }
    }
    Ok(())
}

/// A scene with all filters: from modules to SPIR-V, and from scenes to modules with their tables.
fn all_filters() -> Result<(), Box<dyn std::error::Error>> {
    let (mut modules, mut all) = (Vec::new(), Time::default());
    for (name, scene) in filters::scenes()? {
        let time = Time::of(BAKED_RUNS, || scene.module().map(|_| ()))?;
        println!("{name}: module and tables {time}");
        all = all.plus(time);
        modules.push(scene.module()?);
    }
    println!("all filters: modules and tables {all}, asked {} ms", 1e3 * BAKED);
    if all.fastest > SLOWER * BAKED {
        return Err(format!("all filters take more than {SLOWER} times {BAKED} s to become modules with tables").into());
    }
    let (list, entry): (Vec<&Module>, String) = (modules.iter().collect(), filters::entry(&modules));
    let link = Time::of(RUNS, || prefilter::link(&list, &entry).map(|_| ()))?;
    let shader = prefilter::link(&list, &entry)?;
    let spirv = Time::of(RUNS, || shader.spirv().map(|_| ()))?;
    println!("all filters: link and validate {link}, SPIR-V {spirv}, asked {} ms of both", 1e3 * LINKED);
    if link.plus(spirv).fastest > SLOWER * LINKED {
        return Err(format!("all filters take more than {SLOWER} times {LINKED} s to link and to write").into());
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

/// Seconds of the median run and of the fastest.
#[derive(Clone, Copy, Default)]
struct Time {
    median: f64,
    fastest: f64,
}

impl Time {
    fn of(runs: usize, mut run: impl FnMut() -> Result<(), Error>) -> Result<Self, Error> {
        let mut seconds = Vec::new();
        for _ in 0..runs {
            let start = processor();
            run()?;
            seconds.push(processor() - start);
        }
        seconds.sort_by(f64::total_cmp);
        Ok(Self { median: seconds[runs / 2], fastest: seconds[0] })
    }

    fn plus(self, other: Self) -> Self {
        Self { median: self.median + other.median, fastest: self.fastest + other.fastest }
    }
}

impl std::fmt::Display for Time {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(formatter, "{:.2} ms (fastest {:.2})", 1e3 * self.median, 1e3 * self.fastest)
    }
}
