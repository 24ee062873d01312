//! What programs of the report have alike: what they are asked for, how they end, and how they show progress.

use indicatif::{ProgressBar, ProgressStyle};
use std::path::PathBuf;
use std::process::ExitCode;

/// What every demo is asked for.
#[derive(Debug, clap::Args)]
pub struct Asked {
    /// Small pictures and few cases: about a minute on two cores.
    #[arg(long)]
    pub quick: bool,
    /// The folder of the report; made if need be.
    #[arg(long, value_name = "DIR", default_value = "target/demo")]
    pub out: PathBuf,
}

/// Ends a program, an error being said.
pub fn end<E: std::fmt::Display>(result: Result<(), E>) -> ExitCode {
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

/// A bar of so many steps with what is at work and the time left.
pub fn bar(steps: u64, work: &'static str) -> ProgressBar {
    let template = "{msg:8} {bar:40} {percent:>3} %, {eta} left";
    let style = ProgressStyle::with_template(template).unwrap_or_else(|_| ProgressStyle::default_bar());
    ProgressBar::new(steps).with_style(style).with_message(work)
}
