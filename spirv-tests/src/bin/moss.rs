//! Colors and lights moss and a sponge on the device, judges every method against rays to all heights, and writes a
//! picture and tables.
#![deny(missing_docs)]

use clap::Parser;
use prefilter::gpu::Device;
use spirv_tests::imaging::files::{listed, write};
use spirv_tests::moss::judge::{judge, Extent};
use spirv_tests::moss::{sheet, table, zoom, Error};
use spirv_tests::program::{bar, end, Asked};
use std::process::ExitCode;

/// Colors and lights moss and a sponge, near and far, from overhead to a silhouette, prints how far each method is from
/// the truth, still and in a zoom, and writes a picture and tables.
#[derive(Parser)]
struct Arguments {
    #[command(flatten)]
    asked: Asked,
}

const FULL: Extent = Extent {
    size: [204, 108],
    strata: [8, 16, 32],
    seeds: 2,
    zoom: zoom::Extent { size: [16, 12], strata: 16, count: 61 },
};
const QUICK: Extent = Extent {
    size: [102, 108],
    strata: [8, 16, 32],
    seeds: 1,
    zoom: zoom::Extent { size: [8, 6], strata: 16, count: 21 },
};

fn main() -> ExitCode {
    end(moss(&Arguments::parse().asked))
}

fn moss(asked: &Asked) -> Result<(), Error> {
    let extent = if asked.quick { QUICK } else { FULL };
    let device = Device::new()?;
    let bar = bar(extent.rays(), "moss");
    let judged = judge(&device, extent, &|rays| bar.inc(rays))?;
    bar.finish_and_clear();
    println!("{}", table::legend(device.label(), extent.size, extent.seeds));
    println!("{}\n{}", table::text(&judged), table::zoom_text(&judged));
    let texts = [("moss.csv", table::csv(&judged)), ("moss_zoom.csv", table::zoom_csv(&judged))];
    let written = write(&asked.out, ("moss.png", &sheet::sheet(&judged)), &texts)?;
    println!("written: {}", listed(&written));
    Ok(())
}
