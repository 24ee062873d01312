//! Every module of the corpus through validators that share nothing with naga: spirv-val, and Tint by way of Dawn.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::demand::npm;
use crate::step::{root, run, test_binary};

/// Dawn for Node.js, whose null backend needs no driver.
const DAWN: &str = "webgpu@0.6.2";

/// Writes the corpus anew and validates every file of it.
pub fn validate() -> Result<(), String> {
    let corpus = root().join("target/corpus");
    if corpus.exists() {
        std::fs::remove_dir_all(&corpus).map_err(|error| format!("{}: {error}", corpus.display()))?;
    }
    run(test_binary("corpus")?.arg(&corpus))?;
    spirv(&corpus)?;
    tint(&corpus)
}

/// `NAME.spv` are Vulkan shaders; `NAME.module.spv` are modules without an entry point, for a linker.
fn spirv(corpus: &Path) -> Result<(), String> {
    let files = with_extension(corpus, "spv")?;
    let mut refused = Vec::new();
    for file in &files {
        let library = file.to_string_lossy().ends_with(".module.spv");
        let target = if library { "spv1.3" } else { "vulkan1.1" };
        if let Err(message) = run(Command::new("spirv-val").args(["--target-env", target]).arg(file)) {
            refused.push(message);
        }
    }
    println!("spirv-val: {} of {} modules valid", files.len() - refused.len(), files.len());
    if refused.is_empty() {
        Ok(())
    } else {
        Err(refused.join("; "))
    }
}

fn tint(corpus: &Path) -> Result<(), String> {
    let home = root().join("target/tint");
    if !home.join("node_modules/webgpu/package.json").exists() {
        let mut install = Command::new(npm());
        install.args(["install", "--no-save", "--no-package-lock", "--no-audit", "--no-fund", "--prefix"]);
        run(install.arg(&home).arg(DAWN))?;
    }
    run(Command::new("node").arg(root().join("xtask/tint.mjs")).arg(&home).arg(corpus))
}

/// The files of a folder with an extension, by name. None at all is an error: nothing would be checked.
fn with_extension(folder: &Path, extension: &str) -> Result<Vec<PathBuf>, String> {
    let entries = std::fs::read_dir(folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    let mut files: Vec<PathBuf> = entries.flatten().map(|entry| entry.path()).collect();
    files.retain(|path| path.extension().is_some_and(|found| found == extension));
    files.sort();
    if files.is_empty() {
        return Err(format!("{} holds no .{extension} file", folder.display()));
    }
    Ok(files)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_empty_corpus_is_an_error() {
        let error = with_extension(&root().join("xtask"), "spv").unwrap_err();
        assert!(error.contains("holds no .spv file"), "{error}");
    }
}
