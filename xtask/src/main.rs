//! The one entry for people and for CI: `cargo xtask demo`, `cargo xtask report`, `cargo xtask test`, `cargo xtask ci`.
#![deny(missing_docs)]

mod ci;
mod demand;
mod platform;
mod shaders;
mod step;

use std::process::ExitCode;

use clap::{Parser, Subcommand};
use demand::Demand;
use step::{cargo, run, test_binary};

/// The one entry for people and for CI.
#[derive(Parser)]
#[command(bin_name = "cargo xtask")]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Filter a terrain and a gravel, then noise, a rough surface, a snake, mountains and moss; print how far each
    /// method is from the truth, and write pictures and a page.
    Demo {
        /// Passed on to every demo, `--help` and `--quick` among them.
        #[arg(trailing_var_arg = true, allow_hyphen_values = true)]
        arguments: Vec<String>,
    },
    /// Measure speed against error of every filter side by side, and write a page, plots and tables.
    Report {
        /// Passed on, `--help`, `--quick` and `--only PART` among them.
        #[arg(trailing_var_arg = true, allow_hyphen_values = true)]
        arguments: Vec<String>,
    },
    /// Run every test of the workspace on a real Vulkan device.
    Test {
        /// Try ten million random inputs where the usual run tries a million or less: some minutes more.
        #[arg(long)]
        full: bool,
        /// Passed on to `cargo test`.
        #[arg(trailing_var_arg = true, allow_hyphen_values = true)]
        arguments: Vec<String>,
    },
    /// Check everything that a change must keep: format, lints, documentation, tests, snapshots, shaders, the demo.
    Ci,
}

fn main() -> ExitCode {
    let result = match Arguments::parse().command {
        Command::Demo { arguments } => demo(&arguments),
        Command::Report { arguments } => report(&arguments),
        Command::Test { full, arguments } => test(full, &arguments),
        Command::Ci => ci::ci(),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("error: {message}");
            ExitCode::FAILURE
        }
    }
}

fn demo(arguments: &[String]) -> Result<(), String> {
    demand::meet(&[Demand::Vulkan])?;
    demand::device(|| run(&mut cargo(["run", "--quiet", "--release", "-p", "spirv-tests", "--bin", "device"])))?;
    for binary in ["demo", "noise", "rough", "snake", "cliffs", "moss"] {
        run(cargo(["run", "--release", "-p", "spirv-tests", "--bin", binary, "--"]).args(arguments))?;
    }
    Ok(())
}

fn report(arguments: &[String]) -> Result<(), String> {
    demand::meet(&[Demand::Vulkan])?;
    demand::device(|| run(&mut cargo(["run", "--quiet", "--release", "-p", "spirv-tests", "--bin", "device"])))?;
    run(cargo(["run", "--release", "-p", "spirv-tests", "--bin", "report", "--"]).args(arguments))
}

fn test(full: bool, arguments: &[String]) -> Result<(), String> {
    demand::meet(&[Demand::Vulkan, Demand::SpirvTools, Demand::Glslang])?;
    demand::device(|| run(&mut test_binary("device")?))?;
    let mut tests = every_test();
    if full {
        tests.env("PREFILTER_FULL", "1");
    }
    run(tests.args(arguments))
}

/// What `cargo xtask test` runs, alone and as a step of `cargo xtask ci`.
fn every_test() -> std::process::Command {
    cargo(["test", "--workspace", "--all-features"])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_full_run_is_a_flag_in_front() {
        for (words, asked, passed) in [
            (&["xtask", "test", "--full", "--test", "height"][..], true, &["--test", "height"][..]),
            (&["xtask", "test", "-p", "prefilter"], false, &["-p", "prefilter"]),
        ] {
            let Command::Test { full, arguments } = Arguments::try_parse_from(words).unwrap().command else {
                panic!("{words:?}");
            };
            assert!(full == asked && arguments == passed, "{words:?}: {full} {arguments:?}");
        }
    }
}
