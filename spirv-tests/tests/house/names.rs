//! Names that say nothing: of files, folders, modules and functions, in Rust and in WGSL.

use crate::rust::{functions, tokens};
use crate::tree::Tree;

/// Words that no name holds between its underscores.
const EMPTY: &[&str] = &["util", "utils", "common", "helper", "helpers", "misc", "stuff"];

/// Prefixes that no function bears.
const PREFIXES: &[&str] = &["get_", "compute_"];

/// Every name that says nothing.
pub fn findings(tree: &Tree) -> Vec<String> {
    let mut findings = Vec::new();
    for path in tree.files.keys() {
        let mut parts = path.split(['/', '.', '-']).flat_map(|part| part.split('_'));
        if let Some(part) = parts.find(|part| EMPTY.contains(part)) {
            findings.push(format!("{path}:1: a file or folder named `{part}`"));
        }
    }
    for (path, text) in tree.below("", ".rs") {
        let named = functions(&tokens(path, text)).into_iter().map(|function| (function.line, function.name));
        findings.extend(named.filter(|(_, name)| is_empty(name)).map(|(line, name)| message(path, line, &name)));
    }
    for (path, text) in tree.below("", ".wgsl") {
        let named = prefilter_wgsl::declarations(text).into_iter();
        let empty = named.filter(|declaration| is_empty(declaration.name));
        findings.extend(empty.map(|declaration| message(path, declaration.line, declaration.name)));
    }
    findings
}

fn is_empty(name: &str) -> bool {
    PREFIXES.iter().any(|prefix| name.starts_with(prefix)) || name.split('_').any(|part| EMPTY.contains(&part))
}

fn message(path: &str, line: usize, name: &str) -> String {
    format!("{path}:{line}: the name `{name}`; nouns for values, verbs for effects")
}

#[test]
fn empty_names_are_found() {
    for (path, text) in [
        ("src/util.rs", ""),
        ("src/filter/map_helpers.rs", ""),
        ("src/common/mod.rs", ""),
        ("src/a.rs", "fn get_mean() {}"),
        ("src/a.rs", "fn mean_helper() {}"),
        ("wgsl/math/a.wgsl", "fn compute_mean() {}"),
    ] {
        assert_eq!(findings(&Tree::planted([(path, text)])).len(), 1, "{path} {text}");
    }
    assert!(findings(&Tree::planted([("src/a.rs", "fn budget_of() { together(); }")])).is_empty());
}
