//! Everything that a change must keep.

use std::path::{Path, PathBuf};

use crate::demand::{self, Demand};
use crate::every_test;
use crate::shaders;
use crate::step::{cargo, root, run, test_binary, Summary};

/// Every check, one after the other: a failure does not hide the next one.
pub fn ci() -> Result<(), String> {
    demand::meet(&[Demand::Vulkan, Demand::SpirvTools, Demand::Glslang, Demand::Node, Demand::Npm])?;
    let mut summary = Summary::default();
    summary.step("format", || run(&mut cargo(["fmt", "--all", "--check"])));
    summary.step("lints, all features", || {
        run(&mut cargo(["clippy", "--workspace", "--all-targets", "--all-features", "--", "-D", "warnings"]))
    });
    summary.step("lints, default features", || {
        run(&mut cargo(["clippy", "-p", "prefilter", "-p", "prefilter-wgsl", "--all-targets", "--", "-D", "warnings"]))
    });
    summary.step("documentation", || {
        let mut doc = cargo(["doc", "--workspace", "--all-features", "--no-deps"]);
        run(doc.env("RUSTDOCFLAGS", "-D warnings"))
    });
    summary.step("device", || demand::device(|| run(&mut test_binary("device")?)));
    summary.step("tests", || run(every_test().env("INSTA_UPDATE", "no")));
    summary.step("snapshots", snapshots);
    summary.step("shaders", shaders::validate);
    // The tests' build takes half a minute where the optimized one, which people run, would first compile for two.
    summary.step("demo --quick", || run(test_binary("demo")?.arg("--quick")));
    summary.step("noise --quick", || run(test_binary("noise")?.arg("--quick")));
    summary.step("rough --quick", || run(test_binary("rough")?.arg("--quick")));
    summary.step("snake --quick", || run(test_binary("snake")?.arg("--quick")));
    summary.step("cliffs --quick", || run(test_binary("cliffs")?.arg("--quick")));
    summary.step("moss --quick", || run(test_binary("moss")?.arg("--quick")));
    summary.step("report --quick", || run(test_binary("report")?.arg("--quick")));
    summary.step("benchmark of links", || run(&mut cargo(["bench", "-p", "prefilter", "--bench", "link"])));
    summary.finish()
}

/// Snapshots that wait for a review are changes that nobody has looked at.
fn snapshots() -> Result<(), String> {
    let pending = pending(&root().join("spirv-tests"));
    if pending.is_empty() {
        return Ok(());
    }
    let names: Vec<_> = pending.iter().map(|path| path.display().to_string()).collect();
    Err(format!("{} pending, review with `cargo insta review`: {}", names.len(), names.join(", ")))
}

fn pending(folder: &Path) -> Vec<PathBuf> {
    let Ok(entries) = std::fs::read_dir(folder) else { return Vec::new() };
    let mut found = Vec::new();
    for path in entries.flatten().map(|entry| entry.path()) {
        let name = path.to_string_lossy();
        if name.ends_with(".snap.new") || name.ends_with(".pending-snap") {
            found.push(path);
        } else if path.is_dir() && !path.ends_with("target") {
            found.extend(self::pending(&path));
        }
    }
    found.sort();
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pending_snapshots_are_found() {
        let folder = root().join("target/xtask-pending");
        let inner = folder.join("tests/snapshots");
        std::fs::create_dir_all(&inner).unwrap();
        let planted = inner.join("module.snap.new");
        std::fs::write(&planted, "").unwrap();
        std::fs::write(inner.join("module.snap"), "").unwrap();
        assert_eq!(pending(&folder), [planted]);
        std::fs::remove_dir_all(&folder).unwrap();
        assert!(pending(&folder).is_empty());
    }
}
