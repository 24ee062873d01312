//! Refuses to build while a file of the shelf is broken, and tells the report what its ground truths are made of.

#[path = "../macros/src/fault.rs"]
mod fault;
#[path = "build/shelf.rs"]
mod shelf;
#[path = "build/sources.rs"]
mod sources;

use std::process::ExitCode;

fn main() -> ExitCode {
    // The shelf is compiled into this script: cargo runs it again when one of its files changes.
    println!("cargo::rerun-if-changed=build.rs");
    let mut faults = shelf::faults(prefilter_wgsl::FILES);
    match sources::hash() {
        Ok(hash) => println!("cargo::rustc-env=SOURCES_OF_TRUTHS={hash:016x}"),
        Err(error) => faults.push(format!("the files that ground truths are made of: {error}")),
    }
    for fault in &faults {
        println!("cargo::error={}", fault.replace('\n', "\ncargo::error="));
    }
    if faults.is_empty() {
        ExitCode::SUCCESS
    } else {
        ExitCode::FAILURE
    }
}
