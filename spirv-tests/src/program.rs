//! What programs of the report have alike: how they end, and how they show progress.

use std::process::ExitCode;

use indicatif::{ProgressBar, ProgressStyle};

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
