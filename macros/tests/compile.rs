//! What `include_wgsl!` accepts and what it says where it does not.

use std::path::{Path, PathBuf};
use std::process::Command;

/// The build folder that cargo tells trybuild, too: it need not be the one of this test (`--target-dir`).
fn target() -> PathBuf {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let output = Command::new(cargo).args(["metadata", "--no-deps", "--offline", "--format-version=1"]).output();
    let metadata = String::from_utf8(output.expect("cargo runs").stdout).expect("cargo writes UTF-8");
    let (_, behind) = metadata.split_once("\"target_directory\":\"").expect("cargo names the build folder");
    PathBuf::from(behind.split('"').next().expect("a string ends").replace("\\\\", "\\"))
}

/// trybuild compiles the cases in a crate of its own, and that crate's folder is what paths are relative to.
fn place_shaders() {
    let shaders = target().join("tests/trybuild/prefilter-macros/shaders");
    std::fs::create_dir_all(&shaders).expect("the build folder can be written");
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/shaders");
    for file in std::fs::read_dir(source).expect("the shaders are there").flatten() {
        std::fs::copy(file.path(), shaders.join(file.file_name())).expect("the build folder can be written");
    }
}

#[test]
fn messages_name_the_place() {
    place_shaders();
    let cases = trybuild::TestCases::new();
    cases.pass("tests/cases/good.rs");

    for case in ["syntax_error", "type_error", "unknown_name", "open_brace", "missing_file", "argument"] {
        cases.compile_fail(format!("tests/cases/{case}.rs"));
    }
}
