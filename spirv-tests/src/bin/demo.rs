//! Filters a terrain and a gravel on the device, judges every method against brute force, and writes a report.
#![deny(missing_docs)]

use clap::Parser;
use prefilter::gpu::Device;
use spirv_tests::demo::input::Input;
use spirv_tests::demo::judge::{judge, samples, Judged, Sizes};
use spirv_tests::demo::{page, table, Error};
use spirv_tests::program::{bar, end, Asked};
use std::path::Path;
use std::process::ExitCode;

/// Filters a terrain and a gravel seen to the horizon, prints how far each method is from the truth, and writes
/// pictures, a page and a table.
#[derive(Parser)]
struct Arguments {
    #[command(flatten)]
    asked: Asked,
}

/// Size of the pictures of the contact sheet.
const SHEET: Sizes = Sizes { still: [160, 124], moving: [0, 0], frames: 0 };
const FULL: Sizes = Sizes { still: [512, 384], moving: [192, 144], frames: 12 };
const QUICK: Sizes = Sizes { still: [128, 128], moving: [64, 64], frames: 8 };

fn main() -> ExitCode {
    end(demo(&Arguments::parse().asked))
}

fn demo(asked: &Asked) -> Result<(), Error> {
    let sizes = if asked.quick { QUICK } else { FULL };
    let device = Device::new()?;
    let inputs = Input::all()?;
    let total = inputs.len() as u64 * (samples(sizes) + samples(SHEET));
    let bar = bar(total, "");
    let (mut all, mut sheet): (Vec<Judged>, Vec<Judged>) = (Vec::new(), Vec::new());
    for input in &inputs {
        bar.set_message(input.name);
        all.push(judge(&device, input, sizes, &|taken| bar.inc(taken))?);
        sheet.push(judge(&device, input, SHEET, &|taken| bar.inc(taken))?);
    }
    bar.finish_and_clear();
    println!("{}", table::legend(device.label(), sizes.still));
    for judged in &all {
        println!("{}", table::text(judged));
    }
    page::write(&asked.out, device.label(), sizes, &all, &sheet)?;
    println!("written: {}", shown(&asked.out));
    Ok(())
}

/// The files to look at.
fn shown(folder: &Path) -> String {
    ["index.html", "demo.png", "demo.csv"].map(|name| folder.join(name).display().to_string()).join(", ")
}
