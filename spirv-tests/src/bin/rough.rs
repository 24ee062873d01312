//! Colors a rough surface by height on the device, judges every method against rays through all heights, and writes a
//! picture and a table.
#![deny(missing_docs)]

use clap::Parser;
use prefilter::gpu::Device;
use spirv_tests::imaging::files::{listed, write};
use spirv_tests::program::{bar, end, Asked};
use spirv_tests::rough::judge::{judge, Extent};
use spirv_tests::rough::{sheet, table, Error};
use std::process::ExitCode;

/// Colors a rough surface by height, near and far, from overhead to grazing, prints how far each method is from the
/// truth, and writes a picture and a table.
#[derive(Parser)]
struct Arguments {
    #[command(flatten)]
    asked: Asked,
}

const FULL: Extent = Extent { size: [246, 112], strata: 16, seeds: 4 };
const QUICK: Extent = Extent { size: [123, 56], strata: 16, seeds: 1 };

fn main() -> ExitCode {
    end(rough(&Arguments::parse().asked))
}

fn rough(asked: &Asked) -> Result<(), Error> {
    let extent = if asked.quick { QUICK } else { FULL };
    let device = Device::new()?;
    let bar = bar(extent.rows(), "rough");
    let judged = judge(&device, extent, &|| bar.inc(1))?;
    bar.finish_and_clear();
    println!("{}", table::legend(device.label(), extent.size, extent.seeds));
    println!("{}", table::text(&judged));
    let texts = [("rough.csv", table::csv(&judged))];
    let written = write(&asked.out, ("rough.png", &sheet::sheet(&judged)), &texts)?;
    println!("written: {}", listed(&written));
    Ok(())
}
