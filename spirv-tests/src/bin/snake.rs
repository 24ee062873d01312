//! Colors a snake by its scales' slopes on the device, judges every method against rays to all of its scales, and
//! writes a picture and a table.
#![deny(missing_docs)]

use clap::Parser;
use prefilter::gpu::Device;
use spirv_tests::imaging::files::{listed, write};
use spirv_tests::program::{bar, end, Asked};
use spirv_tests::snake::judge::{judge, Extent};
use spirv_tests::snake::{sheet, table, Error};
use std::process::ExitCode;

/// Colors a snake by a pattern and by the slopes of its scales, near and far, prints how far each method is from the
/// truth, and writes a picture and a table.
#[derive(Parser)]
struct Arguments {
    #[command(flatten)]
    asked: Asked,
}

const FULL: Extent = Extent { size: [246, 168], strata: [8, 16, 32], seeds: 4 };
const QUICK: Extent = Extent { size: [126, 84], strata: [8, 16, 32], seeds: 1 };

fn main() -> ExitCode {
    end(snake(&Arguments::parse().asked))
}

fn snake(asked: &Asked) -> Result<(), Error> {
    let extent = if asked.quick { QUICK } else { FULL };
    let device = Device::new()?;
    let bar = bar(extent.rays(), "snake");
    let judged = judge(&device, extent, &|rays| bar.inc(rays))?;
    bar.finish_and_clear();
    println!("{}", table::legend(device.label(), extent.size, extent.seeds));
    println!("{}", table::text(&judged));
    let texts = [("snake.csv", table::csv(&judged))];
    let written = write(&asked.out, ("snake.png", &sheet::sheet(&judged)), &texts)?;
    println!("written: {}", listed(&written));
    Ok(())
}
