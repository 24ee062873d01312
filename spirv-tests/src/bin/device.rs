//! Prints the device that the tests and the demo run on; fails, and says how to get one, where there is none.
#![deny(missing_docs)]

use std::process::ExitCode;

fn main() -> ExitCode {
    match prefilter::gpu::Device::new() {
        Ok(device) => {
            println!("{}", device.label());
            ExitCode::SUCCESS
        }
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}
