//! Measures every filter, its speed against its error, and writes a page, a Markdown text and values for every table.
#![deny(missing_docs)]

use clap::Parser;
use indicatif::ProgressBar;
use prefilter::gpu::Device;
use spirv_tests::imaging::files::listed;
use spirv_tests::program::{bar, end};
use spirv_tests::report::cache::Cache;
use spirv_tests::report::document::Document;
use spirv_tests::report::{page, publish, Bench, Error, Extent, Part};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Instant;

/// Measures speed against error of every filter on the device that answers, and writes a page, pictures and tables.
#[derive(Parser)]
struct Arguments {
    /// Small pictures and few cases: within two minutes on two cores.
    #[arg(long)]
    quick: bool,
    /// Parts of the report by name, in the report's order; all of them if none is named.
    #[arg(long, value_name = "PART", value_parser = part)]
    only: Vec<Part>,
    /// Write the whole report to `docs` and the README's tables, too, where this is the workspace's folder.
    #[arg(long, conflicts_with = "only")]
    publish: bool,
    /// The folder of the report; made if need be.
    #[arg(long, value_name = "DIR", default_value = "target/report")]
    out: PathBuf,
    /// The folder of ground truths, which are kept between runs; made if need be.
    #[arg(long, value_name = "DIR", default_value = "target/truths")]
    truths: PathBuf,
}

fn part(name: &str) -> Result<Part, String> {
    let names: Vec<&str> = Part::ALL.iter().map(|part| part.name()).collect();
    let found = Part::ALL.into_iter().find(|part| part.name() == name);
    found.ok_or_else(|| format!("the parts are {}", names.join(", ")))
}

fn main() -> ExitCode {
    end(report(&Arguments::parse()))
}

fn report(arguments: &Arguments) -> Result<(), Error> {
    let start = Instant::now();
    let extent = if arguments.quick { Extent::Quick } else { Extent::Full };
    let (device, timed) = devices()?;
    let parts = Part::ALL.into_iter().filter(|part| arguments.only.is_empty() || arguments.only.contains(part));
    let parts: Vec<Part> = parts.collect();
    let progress = bar(parts.iter().map(|part| part.steps(extent)).sum(), "");
    let (cache, done) = (Cache::new(&arguments.truths), |steps| progress.inc(steps));
    let bench = Bench { device: &device, timed: &timed, extent, cache: &cache, done: &done };
    let mut document = Document { title: "prefilter: speed against error".into(), facts: vec![], sections: vec![] };
    let mut written = PathBuf::new();
    for part in parts {
        progress.set_message(part.name());
        let begun = Instant::now();
        document.sections.push(part.section(&bench)?);
        document.facts = facts(&device, extent, start);
        // What is there is kept, whatever comes of the next part.
        written = page::write(&arguments.out, &document)?;
        said(&progress, part.name(), begun);
    }
    progress.finish_and_clear();
    println!("written: {}", written.display());
    if arguments.publish {
        println!("written: {}", listed(&publish::publish(Path::new("."), device.label(), &document)?));
    }
    Ok(())
}

/// What the report is of.
fn facts(device: &Device, extent: Extent, start: Instant) -> Vec<(&'static str, String)> {
    vec![
        ("device", device.label().to_owned()),
        ("date", jiff::Zoned::now().strftime("%Y-%m-%d %H:%M %Z").to_string()),
        ("version", format!("prefilter {}", env!("CARGO_PKG_VERSION"))),
        ("extent", extent.pick("quick", "full").to_owned()),
        ("seconds", format!("{:.0}", start.elapsed().as_secs_f64())),
    ]
}

/// The device as it is, and one for timings.
///
/// Mesa's llvmpipe takes all processors, of which other work takes a changing share: timed, it has one thread.
fn devices() -> Result<(Device, Device), prefilter::Error> {
    const THREADS: &str = "LP_NUM_THREADS";
    let given = std::env::var_os(THREADS);
    std::env::set_var(THREADS, "1");
    let timed = Device::new();
    match given {
        Some(threads) => std::env::set_var(THREADS, threads),
        None => std::env::remove_var(THREADS),
    }
    Ok((Device::new()?, timed?))
}

fn said(progress: &ProgressBar, part: &str, begun: Instant) {
    progress.suspend(|| println!("{part}: {:.1} s", begun.elapsed().as_secs_f64()));
}
