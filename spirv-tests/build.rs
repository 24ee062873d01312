//! Refuses to build while a file of the shelf is broken.

#[path = "../macros/src/fault.rs"]
mod fault;
#[path = "build/shelf.rs"]
mod shelf;

use std::process::ExitCode;

fn main() -> ExitCode {
    // The shelf is compiled into this script: cargo runs it again when one of its files changes.
    println!("cargo::rerun-if-changed=build.rs");
    let faults = shelf::faults(prefilter_wgsl::FILES);
    for fault in &faults {
        println!("cargo::error={}", fault.replace('\n', "\ncargo::error="));
    }
    if faults.is_empty() {
        ExitCode::SUCCESS
    } else {
        ExitCode::FAILURE
    }
}
