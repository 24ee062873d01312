//! Sizes of files, functions and lines.

use crate::rust::{functions, tokens};
use crate::tree::Tree;

const WGSL_LINES: usize = 150;
const RUST_LINES: usize = 300;
const EXAMPLE_LINES: usize = 79;
const FUNCTION_LINES: usize = 60;
const COLUMNS: usize = 120;

/// Files that may be longer, with the reason.
const LONG: &[(&str, &str)] = &[];

/// What is too long.
pub fn findings(tree: &Tree) -> Vec<String> {
    let mut findings = Vec::new();
    for (path, text) in tree.below("", ".wgsl").chain(tree.below("", ".rs")) {
        let limit = match path {
            _ if path.ends_with(".wgsl") => WGSL_LINES,
            _ if path.starts_with("examples/") => EXAMPLE_LINES,
            _ => RUST_LINES,
        };
        let lines = text.lines().count();
        if lines > limit && !LONG.iter().any(|long| long.0 == path) {
            findings.push(format!("{path}:{lines}: the file has {lines} lines, {limit} are the limit"));
        }
        for (index, line) in text.lines().enumerate() {
            let columns = line.chars().count();
            if columns > COLUMNS {
                findings.push(format!("{path}:{}: {columns} columns, {COLUMNS} are the limit", index + 1));
            }
        }
    }
    for (path, text) in tree.below("", ".rs") {
        let functions = functions(&tokens(path, text)).into_iter();
        findings.extend(functions.filter(|function| function.lines > FUNCTION_LINES).map(|function| {
            let (name, line, lines) = (function.name, function.line, function.lines);
            format!("{path}:{line}: `{name}` has {lines} lines, {FUNCTION_LINES} are the limit")
        }));
    }
    findings
}

#[test]
fn long_things_are_found() {
    let lines = |count: usize| "\n".repeat(count);
    let body = format!("fn long() {{{}}}", lines(60));
    for (path, text) in [
        ("wgsl/math/a.wgsl", lines(151)),
        ("src/a.rs", lines(301)),
        ("examples/a.rs", lines(80)),
        ("src/a.rs", body),
        ("src/a.rs", format!("// {}", "é".repeat(118))),
    ] {
        assert_eq!(findings(&Tree::planted([(path, &text)])).len(), 1, "{path}");
    }
    let good = format!("fn short() {{{}}}\n// {}\n", lines(59), "é".repeat(117));
    assert!(findings(&Tree::planted([("src/a.rs", &good)])).is_empty());
}
