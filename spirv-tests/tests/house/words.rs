//! Text that is unfinished or belongs to one machine, and library code that may panic.

use crate::rust::{tokens, Token};
use crate::tree::Tree;

/// Written in two halves, so that this file does not hold what it forbids.
const UNFINISHED: &[&str] = &[
    concat!("TO", "DO"),
    concat!("FIX", "ME"),
    concat!("todo", "!("),
    concat!("unimplemented", "!("),
    concat!("#[ign", "ore"),
];

const MACHINE: &[&str] = &[
    concat!("/wo", "rk/"),
    concat!("/tmp", "/wt"),
    concat!(".lib", "rary"),
    concat!("/ro", "ot/"),
    concat!("$HO", "ME"),
    concat!("/ho", "me/"),
];

/// Library code: what users call must return errors.
const LIBRARY: &[&str] = &["src/", "macros/src/", "wgsl/src/"];

/// Every such place.
pub fn findings(tree: &Tree) -> Vec<String> {
    let mut findings = Vec::new();
    for (path, text) in &tree.files {
        for (index, line) in text.lines().enumerate() {
            for word in UNFINISHED.iter().filter(|word| line.contains(**word)) {
                findings.push(format!("{path}:{}: unfinished: `{word}`", index + 1));
            }
            for word in MACHINE.iter().filter(|word| line.contains(**word)) {
                findings.push(format!("{path}:{}: one machine's path: `{word}`", index + 1));
            }
        }
        if path.ends_with(".rs") && LIBRARY.iter().any(|folder| path.starts_with(folder)) {
            findings.extend(panics(&tokens(path, text)).map(|(line, what)| {
                format!(
                    "{path}:{line}: `{what}` in a library; return an error, or say in `unreachable!` why it cannot be"
                )
            }));
        }
    }
    findings
}

/// Calls that end the program; an `unreachable!` must say why.
fn panics(tokens: &[Token]) -> impl Iterator<Item = (usize, &str)> {
    tokens.windows(5).filter_map(|window| {
        let [before, word, next, _, argument] = window else { return None };
        let ends = match word.text.as_str() {
            "unwrap" | "expect" | "unwrap_err" | "expect_err" => before.text == "." && next.text == "(",
            "panic" | "dbg" | "println" | "print" => next.text == "!",
            "unreachable" => next.text == "!" && !argument.text.starts_with('"'),
            _ => false,
        };
        ends.then_some((word.line, word.text.as_str()))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn unfinished_and_local_text_is_found() {
        for word in UNFINISHED.iter().chain(MACHINE) {
            let found = findings(&Tree::planted([("docs/a.md", &format!("fine\nnot {word}x) fine"))]));
            assert!(found.len() == 1 && found[0].starts_with("docs/a.md:2:"), "{word}: {found:?}");
        }
        assert!(findings(&Tree::planted([("docs/a.md", "a framework/house")])).is_empty());
    }

    #[test]
    fn library_code_does_not_end_the_program() {
        let planted = |code: &str| findings(&Tree::planted([("src/a.rs", &format!("fn f() {{\n {code}; }}"))]));
        for code in ["x().unwrap()", "x().expect(\"here\")", "panic!(\"here\")", "unreachable!()", "println!(\"here\")"]
        {
            let found = planted(code);
            assert!(found.len() == 1 && found[0].starts_with("src/a.rs:2:"), "{code}: {found:?}");
        }
        for code in ["x().unwrap_or(1)", "unreachable!(\"the list is never empty\")", "// x.unwrap()\n"] {
            assert_eq!(planted(code), [""; 0]);
        }
        assert!(findings(&Tree::planted([("spirv-tests/src/a.rs", "fn f() { x().unwrap() }")])).is_empty());
    }
}
