//! What a command needs of the machine: looked for, installed where that is ours to do, else asked for in one line.

use std::process::{Command, Stdio};

use crate::platform::Platform;
use crate::step::run;

/// Something that must be on the machine.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Demand {
    /// Vulkan's loader with at least one driver.
    Vulkan,
    /// `spirv-val`.
    SpirvTools,
    /// `glslangValidator`.
    Glslang,
    /// Node.js 18 or later, for Dawn's Tint.
    Node,
    /// npm, which fetches Dawn.
    Npm,
}

impl Demand {
    fn is_met(self) -> bool {
        match self {
            Self::Vulkan => Platform::has_vulkan(),
            Self::SpirvTools => answers("spirv-val"),
            Self::Glslang => answers("glslangValidator"),
            Self::Node => node_version().is_some_and(|major| major >= 18),
            Self::Npm => answers(npm()),
        }
    }

    fn name(self) -> &'static str {
        match self {
            Self::Vulkan => "a Vulkan driver",
            Self::SpirvTools => "spirv-val",
            Self::Glslang => "glslangValidator",
            Self::Node => "Node.js 18",
            Self::Npm => "npm",
        }
    }
}

/// npm is a script on Windows, which only its full name starts.
pub fn npm() -> &'static str {
    if cfg!(windows) {
        "npm.cmd"
    } else {
        "npm"
    }
}

/// Makes sure that every demand is met: installs what is missing on Debian and Ubuntu as root.
///
/// # Errors
/// What is missing, with the one command that installs it on this platform.
pub fn meet(demands: &[Demand]) -> Result<(), String> {
    let missing: Vec<Demand> = demands.iter().copied().filter(|demand| !demand.is_met()).collect();
    if missing.is_empty() {
        return Ok(());
    }
    let platform = Platform::current();
    if !platform.installs_by_itself() {
        return Err(advice(platform, &missing));
    }
    update()?;
    for demand in &missing {
        // Some distributors' Node.js brings npm and conflicts with the package of that name.
        if !demand.is_met() {
            println!("installing {}", demand.name());
            install(&platform.packages(&[*demand]))?;
        }
    }
    let still: Vec<Demand> = missing.into_iter().filter(|demand| !demand.is_met()).collect();
    if still.is_empty() {
        Ok(())
    } else {
        Err(format!("{} is still missing after its installation; the log is above", names(&still)))
    }
}

/// Asks a device for its name, and installs a driver where that is ours to do and none answers.
///
/// A driver's file on disk says little: in a container it may belong to a card that is not there.
///
/// # Errors
/// No device answers, with the one command that installs a driver on this platform.
pub fn device(ask: impl Fn() -> Result<(), String>) -> Result<(), String> {
    let Err(message) = ask() else { return Ok(()) };
    let platform = Platform::current();
    let vulkan = [Demand::Vulkan];
    if !platform.installs_by_itself() {
        return Err(format!("{message}. {}", platform.instruction(&vulkan)));
    }
    println!("installing {}", names(&vulkan));
    update()?;
    install(&platform.packages(&vulkan))?;
    ask()
}

/// One sentence: what is missing and the command for it.
pub fn advice(platform: Platform, missing: &[Demand]) -> String {
    format!("missing: {}. {}", names(missing), platform.instruction(missing))
}

fn names(demands: &[Demand]) -> String {
    demands.iter().map(|demand| demand.name()).collect::<Vec<_>>().join(", ")
}

/// Fetches the lists of packages, once more when the first attempt fails: mirrors do, now and then.
fn update() -> Result<(), String> {
    run(&mut apt(&["update"])).or_else(|_| run(&mut apt(&["update"])))
}

fn install(packages: &[&str]) -> Result<(), String> {
    run(apt(&["install", "-y", "--no-install-recommends"]).args(packages))
}

fn apt(arguments: &[&str]) -> Command {
    let mut command = Command::new("apt-get");
    command.args(arguments).args(["-q", "-o", "Acquire::Retries=3"]).env("DEBIAN_FRONTEND", "noninteractive");
    command
}

/// Whether a program starts and answers.
fn answers(program: &str) -> bool {
    let mut command = Command::new(program);
    command.arg("--version").stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    command.status().is_ok_and(|status| status.success())
}

fn node_version() -> Option<u32> {
    let output = Command::new("node").arg("--version").stdin(Stdio::null()).output().ok()?;
    major(&String::from_utf8_lossy(&output.stdout))
}

/// The 20 of `v20.20.2`.
fn major(version: &str) -> Option<u32> {
    version.trim().trim_start_matches('v').split('.').next()?.parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn versions_are_read() {
        assert_eq!(major("v20.20.2\n"), Some(20));
        assert_eq!(major("not found"), None);
    }

    #[test]
    fn a_missing_program_does_not_answer() {
        assert!(!answers("prefilter-no-such-program"));
    }
}
