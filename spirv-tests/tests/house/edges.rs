//! Dependencies between the modules of the crate: `error ← reference ← transfer ← table ← driver, filter ← scene`.

use std::collections::BTreeMap;

use crate::rust::{crate_paths, tokens};
use crate::tree::Tree;

/// The layers from the ground up. A module may name modules of lower layers and itself, no others.
const LAYERS: &[&[&str]] = &[
    &["error", "join", "linkage", "reserved"],
    &["reference"],
    &["name"],
    &["transfer"],
    // `table` holds the baker too, which evaluates the reference over a map.
    &["table"],
    &["cost"],
    &["accuracy"],
    &["driver", "filter"],
    // A scene writes the text and returns it as a module: the module does not know scenes.
    &["module", "probe", "shader"],
    &["scene"],
    // The device binds tables and runs shaders; nothing but tests and examples needs it.
    &["gpu"],
];

/// Layers whose modules may name each other, with the reason.
const TOGETHER: &[(&str, &str)] = &[("module", "a module links to a shader, and linking takes several modules")];

/// Modules that must not name others although they lie below, with the reason.
const APART: &[(&str, &str, &str)] = &[
    ("reference", "error", "the reference imports nothing of the crate"),
    ("reference", "join", "the reference imports nothing of the crate"),
    ("reference", "linkage", "the reference imports nothing of the crate"),
    ("reference", "reserved", "the reference imports nothing of the crate"),
];

/// Paths of the crate that run against the layers, and code outside `gpu` that names wgpu.
pub fn findings(tree: &Tree) -> Vec<String> {
    let reexports = reexports(tree.files.get("src/lib.rs").map_or("", String::as_str));
    let mut findings = Vec::new();
    for (path, text) in tree.below("src/", ".rs").filter(|(path, _)| *path != "src/lib.rs") {
        let own = module_of(path);
        let tokens = tokens(path, text);
        for to in crate_paths(&tokens) {
            let target = reexports.get(&to.text).unwrap_or(&to.text);
            if let Some(reason) = refusal(own, target) {
                findings.push(format!("{path}:{}: `{own}` names `crate::{}`: {reason}", to.line, to.text));
            }
        }
        if own != "gpu" {
            let named = tokens.iter().filter(|token| token.text == "wgpu");
            findings.extend(named.map(|token| format!("{path}:{}: only src/gpu names wgpu", token.line)));
        }
    }
    findings
}

/// `src/table/grid.rs` and `src/table.rs` belong to `table`.
fn module_of(path: &str) -> &str {
    let below = path.trim_start_matches("src/");
    below.split(['/', '.']).next().unwrap_or(below)
}

fn refusal(from: &str, to: &str) -> Option<String> {
    if from == to {
        return None;
    }
    let layer = |name: &str| LAYERS.iter().position(|layer| layer.contains(&name));
    match (layer(from), layer(to)) {
        (None, _) => Some(format!("`{from}` has no place in the layers of the house test")),
        (_, None) => Some(format!("`{to}` has no place in the layers of the house test")),
        (Some(low), Some(high)) if low == high && TOGETHER.iter().any(|(name, _)| LAYERS[low].contains(name)) => None,
        (Some(low), Some(high)) if high >= low => Some(format!("dependencies run the other way, `{from}` lies below")),
        _ => APART.iter().find(|apart| (apart.0, apart.1) == (from, to)).map(|apart| apart.2.to_owned()),
    }
}

/// The module behind every name that `lib.rs` exports again: `pub use table::{Format, Table}`.
fn reexports(lib: &str) -> BTreeMap<String, String> {
    let tokens = tokens("src/lib.rs", lib);
    let mut found = BTreeMap::new();
    for (index, _) in tokens.iter().enumerate().filter(|(_, token)| token.text == "use") {
        let statement: Vec<&str> =
            tokens[index + 1..].iter().map(|token| token.text.as_str()).take_while(|text| *text != ";").collect();
        let Some((module, names)) = statement.split_first() else { continue };
        let names = names.iter().filter(|name| name.starts_with(char::is_alphabetic));
        found.extend(names.map(|name| ((*name).to_owned(), (*module).to_owned())));
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    fn planted(path: &str, text: &str) -> Vec<String> {
        let lib = "mod scene; pub use scene::{Ranges, Scene}; pub use error::Error;";
        findings(&Tree::planted([("src/lib.rs", lib), (path, text)]))
    }

    #[test]
    fn edges_with_the_stream_pass() {
        assert_eq!(planted("src/filter/texture.rs", "use crate::{table::Table, Error};"), [""; 0]);
        assert_eq!(planted("src/filter/texture.rs", "use crate::filter::Filter;"), [""; 0]);
        assert_eq!(planted("src/gpu/device.rs", "use wgpu::Device; use crate::table::Table;"), [""; 0]);
    }

    #[test]
    fn edges_that_run_back_fail() {
        for (path, text) in [
            ("src/table/mod.rs", "fn f() {\n crate::scene::f() }"),
            ("src/table/mod.rs", "\nuse crate::Ranges;"),
            ("src/filter/texture.rs", "\nuse crate::driver::Driver;"),
            ("src/reference/normal.rs", "\nuse crate::Error;"),
            ("src/scene.rs", "\nuse crate::gpu::Device;"),
            ("src/scene.rs", "\nfn f(device: &wgpu::Device) {}"),
            ("src/attic.rs", "\nuse crate::Error;"),
        ] {
            let found = planted(path, text);
            assert!(found.len() == 1 && found[0].starts_with(&format!("{path}:2:")), "{text}: {found:?}");
        }
    }
}
