//! Filters a plane and blocks of noise on the device, judges every method against brute force, and writes a picture and
//! a table.
#![deny(missing_docs)]

use clap::Parser;
use prefilter::gpu::Device;
use spirv_tests::imaging::files::{listed, write};
use spirv_tests::noise::input::{Ground, Input};
use spirv_tests::noise::judge::{judge, Extent};
use spirv_tests::noise::sheet::{self, Shown};
use spirv_tests::noise::{table, Error};
use spirv_tests::program::{bar, end, Asked};
use spirv_tests::report::cache::Cache;
use std::process::ExitCode;

/// Filters a plane of noise to the horizon and blocks of solid noise, prints how far each method is from the truth,
/// still and in motion, and writes a picture and a table.
#[derive(Parser)]
struct Arguments {
    #[command(flatten)]
    asked: Asked,
}

const FULL: Extent = Extent {
    still: [[48, 36], [108, 46]],
    moving: [[48, 36], [72, 30]],
    frames: 12,
    strata: [32, 16],
    seeds: 4,
    moved: 0,
};
const QUICK: Extent = Extent {
    still: [[48, 36], [72, 30]],
    moving: [[48, 36], [72, 30]],
    frames: 6,
    strata: [16, 8],
    seeds: 2,
    moved: 0,
};

fn main() -> ExitCode {
    end(noise(&Arguments::parse().asked))
}

/// Size of the pictures of the contact sheet.
fn size(input: &Input) -> [usize; 2] {
    match input.ground {
        Ground::Plane => [216, 108],
        Ground::Blocks => [216, 92],
    }
}

fn noise(asked: &Asked) -> Result<(), Error> {
    let extent = if asked.quick { QUICK } else { FULL };
    let device = Device::new()?;
    let (inputs, cache) = (Input::all()?, Cache::none());
    let on_sheet = |input: &&Input| input.name != "steps6";
    let shown: u64 = inputs.iter().filter(on_sheet).map(|input| Shown::samples(size(input))).sum();
    let total = shown + inputs.iter().map(|input| extent.samples(input)).sum::<u64>();
    let bar = bar(total, "noise");
    let done = |taken| bar.inc(taken);
    let all =
        inputs.iter().map(|input| judge(&device, input, extent, &cache, &done)).collect::<Result<Vec<_>, Error>>()?;
    let shown = inputs.iter().filter(on_sheet).map(|input| Shown::new(&device, input, size(input), &cache, &done));
    let shown = shown.collect::<Result<Vec<_>, Error>>()?;
    bar.finish_and_clear();
    println!("{}", table::legend(device.label(), extent.seeds));
    for judged in &all {
        println!("{}", table::text(judged));
    }
    let texts = [("noise.csv", table::csv(&all))];
    let written = write(&asked.out, ("noise.png", &sheet::sheet(&shown)), &texts)?;
    println!("written: {}", listed(&written));
    Ok(())
}
