//! Colors and lights a mountainous ground on the device, judges every method against rays to all of it, and writes a
//! picture and tables.
#![deny(missing_docs)]

use clap::Parser;
use prefilter::gpu::Device;
use spirv_tests::cliffs::judge::{judge, Extent};
use spirv_tests::cliffs::{sheet, table, Error};
use spirv_tests::imaging::files::{listed, write};
use spirv_tests::program::{bar, end, Asked};
use std::process::ExitCode;

/// Colors a mountainous ground by height and steepness in the light of a sky, prints how far each method is from the
/// truth, and writes a picture and tables.
#[derive(Parser)]
struct Arguments {
    #[command(flatten)]
    asked: Asked,
}

const FULL: Extent = Extent { size: [224, 112], strata: 16, places: 4, modeled: 211 };
const QUICK: Extent = Extent { size: [112, 56], strata: 16, places: 1, modeled: 211 };

fn main() -> ExitCode {
    end(cliffs(&Arguments::parse().asked))
}

fn cliffs(asked: &Asked) -> Result<(), Error> {
    let extent = if asked.quick { QUICK } else { FULL };
    let device = Device::new()?;
    let bar = bar(extent.rows(), "cliffs");
    let judged = judge(&device, extent, &|| bar.inc(1))?;
    bar.finish_and_clear();
    println!("{}", table::legend(device.label(), extent.size, extent.places));
    println!("{}", table::text(&judged));
    println!("{}\n{}", table::MODEL_LEGEND, table::model_text(&judged));
    let texts = [("cliffs.csv", table::csv(&judged)), ("cliffs_model.csv", table::model_csv(&judged))];
    let written = write(&asked.out, ("cliffs.png", &sheet::sheet(&judged)), &texts)?;
    println!("written: {}", listed(&written));
    Ok(())
}
