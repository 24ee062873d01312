//! What a dependent of `prefilter` builds: little more than naga, unless it asks for more.

use std::collections::BTreeSet;
use std::process::Command;

/// `name vVERSION` of every package in a tree that `cargo tree` prints.
fn tree(arguments: &[&str]) -> BTreeSet<String> {
    let mut command = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    command.args(["tree", "--offline", "--prefix=none", "--format={p}"]).args(arguments);
    let output = command.current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/..")).output().expect("cargo runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let text = String::from_utf8(output.stdout).expect("cargo writes UTF-8");
    let package = |line: &str| line.split_whitespace().take(2).collect::<Vec<_>>().join(" ");
    text.lines().map(package).filter(|package| !package.is_empty()).collect()
}

fn names(tree: &BTreeSet<String>) -> BTreeSet<&str> {
    tree.iter().filter_map(|package| package.split(' ').next()).collect()
}

/// The packages of `prefilter` as its dependents build it, without any feature.
fn bare(depth: &[&str]) -> BTreeSet<String> {
    tree(&[&["--package=prefilter", "--no-default-features", "--edges=normal,build"], depth].concat())
}

#[test]
fn without_features_there_are_five_direct_dependencies() {
    let direct = bare(&["--depth=1"]);
    assert_eq!(names(&direct), BTreeSet::from(["half", "libm", "naga", "prefilter", "prefilter-wgsl", "thiserror"]));
}

#[test]
fn without_features_nothing_but_naga_and_its_own_is_built() {
    let bare = bare(&[]);
    let bare = names(&bare);
    let naga = tree(&["--package=naga", "--edges=normal,build"]);
    let allowed = names(&naga);
    let own = BTreeSet::from(["prefilter", "prefilter-wgsl", "half", "libm"]);
    let more: Vec<&&str> = bare.iter().filter(|name| !allowed.contains(*name) && !own.contains(*name)).collect();
    assert!(more.is_empty(), "{more:?}");
    for forbidden in ["wgpu", "wgpu-core", "wgpu-hal", "prefilter-macros", "trybuild", "image", "colorgrad", "serde"] {
        assert!(!bare.contains(forbidden), "{forbidden}");
    }
}

#[test]
fn each_feature_brings_what_it_is_for() {
    for (feature, package) in
        [("macros", "prefilter-macros"), ("gpu", "wgpu"), ("image", "image"), ("colorgrad", "colorgrad")]
    {
        let arguments = ["--package=prefilter", "--no-default-features", "--edges=normal", "--features", feature];
        assert!(names(&tree(&arguments)).contains(package), "{feature}");
        assert!(!names(&bare(&[])).contains(package), "{package}");
    }
}

#[test]
fn the_shelf_crate_has_no_dependency() {
    assert_eq!(names(&tree(&["--package=prefilter-wgsl", "--edges=all"])), BTreeSet::from(["prefilter-wgsl"]));
}

#[test]
fn the_macro_crate_has_two() {
    let direct = tree(&["--package=prefilter-macros", "--edges=normal,build", "--depth=1"]);
    assert_eq!(names(&direct), BTreeSet::from(["naga", "prefilter-macros", "prefilter-wgsl"]));
}

#[test]
fn there_is_one_version_of_naga() {
    let all = tree(&["--workspace", "--all-features", "--edges=all"]);
    let versions: Vec<&String> = all.iter().filter(|package| package.starts_with("naga v")).collect();
    assert_eq!(versions.len(), 1, "{versions:?}");
}
