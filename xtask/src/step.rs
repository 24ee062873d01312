//! Commands run one after the other, each under its own heading, with their times in a table at the end.

use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

/// The workspace's folder.
pub fn root() -> PathBuf {
    let package = Path::new(env!("CARGO_MANIFEST_DIR"));
    package.parent().unwrap_or(package).to_owned()
}

/// A cargo command.
pub fn cargo<const N: usize>(arguments: [&str; N]) -> Command {
    let mut command = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    command.args(arguments);
    prepare(&mut command);
    command
}

/// A binary of `spirv-tests`.
///
/// It is built as the tests build it, for one of them: a build of its own would resolve features without the tests'
/// dependencies and compile wgpu a second time.
pub fn test_binary(name: &str) -> Result<Command, String> {
    run(&mut cargo(["test", "--quiet", "--no-run", "--workspace", "--all-features", "--test", "house"]))?;
    let own = std::env::current_exe().map_err(|error| error.to_string())?;
    let mut command = Command::new(own.with_file_name(format!("{name}{}", std::env::consts::EXE_SUFFIX)));
    prepare(&mut command);
    Ok(command)
}

/// The workspace's folder, and the environment that Vulkan's drivers want.
fn prepare(command: &mut Command) {
    command.current_dir(root());
    if cfg!(unix) && std::env::var_os("XDG_RUNTIME_DIR").is_none() {
        // Mesa looks for a display there, and says so on every start when it is unset.
        command.env("XDG_RUNTIME_DIR", std::env::temp_dir());
    }
}

/// Runs a command that talks to the terminal and fails as it fails.
pub fn run(command: &mut Command) -> Result<(), String> {
    let status = command.stdin(Stdio::null()).status().map_err(|error| format!("{}: {error}", line(command)))?;
    if status.success() {
        Ok(())
    } else {
        Err(format!("`{}` failed ({status})", line(command)))
    }
}

/// What a command would look like on a command line, without its environment.
pub fn line(command: &Command) -> String {
    let program = Path::new(command.get_program()).file_name().unwrap_or(command.get_program());
    let words = std::iter::once(program).chain(command.get_args());
    words.map(OsStr::to_string_lossy).collect::<Vec<_>>().join(" ")
}

/// What became of every step so far.
#[derive(Default)]
pub struct Summary {
    rows: Vec<(&'static str, Duration, Result<(), String>)>,
}

impl Summary {
    /// Runs a step, prints its time, and keeps its outcome.
    pub fn step(&mut self, name: &'static str, work: impl FnOnce() -> Result<(), String>) {
        println!("\n=== {name}");
        let start = Instant::now();
        let outcome = work();
        let time = start.elapsed();
        match &outcome {
            Ok(()) => println!("=== {name}: ok, {:.1} s", time.as_secs_f64()),
            Err(message) => println!("=== {name}: FAILED, {:.1} s: {message}", time.as_secs_f64()),
        }
        self.rows.push((name, time, outcome));
    }

    /// Prints the table; an error when a step failed.
    pub fn finish(self) -> Result<(), String> {
        println!("\n{}", self.table());
        let failed: Vec<_> = self.rows.iter().filter(|row| row.2.is_err()).map(|row| row.0).collect();
        if failed.is_empty() {
            Ok(())
        } else {
            Err(format!("{} of {} steps failed: {}", failed.len(), self.rows.len(), failed.join(", ")))
        }
    }

    fn table(&self) -> String {
        let mut table = String::new();
        for (name, time, outcome) in &self.rows {
            let verdict = outcome.as_ref().map_or_else(|message| format!("FAILED  {message}"), |()| "ok".to_owned());
            table += &format!("{name:<24} {:>7.1} s  {verdict}\n", time.as_secs_f64());
        }
        let total: Duration = self.rows.iter().map(|row| row.1).sum();
        table + &format!("{:<24} {:>7.1} s", "total", total.as_secs_f64())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_failed_step_fails_the_whole() {
        let mut summary = Summary::default();
        summary.step("good", || Ok(()));
        summary.step("bad", || Err("planted".to_owned()));
        assert!(summary.table().contains("FAILED  planted"));
        assert_eq!(summary.finish(), Err("1 of 2 steps failed: bad".to_owned()));
    }

    #[test]
    fn a_command_that_fails_is_named() {
        let error = run(cargo(["no-such-command"]).stderr(Stdio::null())).unwrap_err();
        assert!(error.contains("no-such-command"), "{error}");
    }
}
