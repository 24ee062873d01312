//! The README names every command of `cargo xtask` and the examples that exist; the changelog has a place to write.

use crate::rust::tokens;
use crate::tree::{stem, Tree};

/// What the pages leave out or name in vain.
pub fn findings(tree: &Tree) -> Vec<String> {
    let page = |path: &str| tree.files.get(path).map_or("", String::as_str);
    let readme = page("README.md");
    let mut findings = Vec::new();
    let commands = commands(page("xtask/src/main.rs"));
    if commands.is_empty() {
        findings.push("xtask/src/main.rs:1: no command found".to_owned());
    }
    let unnamed = commands.iter().filter(|command| !readme.contains(&format!("cargo xtask {command}")));
    findings.extend(unnamed.map(|command| format!("README.md:1: `cargo xtask {command}` is not named")));
    let unnamed = tree.below("examples/", ".rs").map(|(path, _)| stem(path)).filter(|stem| !readme.contains(*stem));
    findings.extend(unnamed.map(|stem| format!("README.md:1: the example `{stem}` is not named")));
    for (index, line) in readme.lines().enumerate() {
        for name in named_examples(line).filter(|name| !tree.has_module(&format!("examples/{name}"))) {
            findings.push(format!("README.md:{}: there is no example `{name}`", index + 1));
        }
    }
    let changelog = page("CHANGELOG.md");
    if !changelog.lines().any(|line| line.starts_with("## [")) {
        findings.push("CHANGELOG.md:1: neither `## [Unreleased]` nor a version".to_owned());
    }
    findings
}

/// The variants of xtask's `enum Command`, as the command line spells them.
fn commands(main: &str) -> Vec<String> {
    let tokens = tokens("xtask/src/main.rs", main);
    let start = tokens.windows(2).position(|pair| pair[0].text == "enum" && pair[1].text == "Command");
    let mut found = Vec::new();
    let mut depth = 0usize;
    for token in tokens.iter().skip(start.map_or(tokens.len(), |start| start + 2)) {
        match token.text.as_str() {
            "{" | "(" | "[" => depth += 1,
            "}" | ")" | "]" => depth -= 1,
            name if depth == 1 && name.starts_with(char::is_uppercase) => found.push(name.to_lowercase()),
            _ => {}
        }
        if depth == 0 {
            break;
        }
    }
    found
}

/// The names behind `--example ` and `examples/` (Rust files only) of a line.
fn named_examples(line: &str) -> impl Iterator<Item = &str> {
    let is_part = |letter: char| letter.is_ascii_alphanumeric() || letter == '_';
    let word = move |text: &'static str| {
        line.match_indices(text).map(move |(at, _)| {
            let rest = &line[at + text.len()..];
            let end = rest.find(|letter| !is_part(letter)).unwrap_or(rest.len());
            (&rest[..end], &rest[end..])
        })
    };
    let options = word("--example ").map(|(name, _)| name);
    options.chain(word("examples/").filter(|(_, rest)| rest.starts_with(".rs")).map(|(name, _)| name))
}

#[cfg(test)]
mod tests {
    use super::*;

    const MAIN: &str = "enum Command { /// Show.\n Demo { #[arg(last)] arguments: Vec<String> }, Ci }";
    const README: &str =
        "`cargo xtask demo`, `cargo xtask ci`, `cargo run --example print_module`, examples/data/a.png";
    const CHANGELOG: &str = "## [Unreleased]\n";

    fn planted(readme: &str, changelog: &str) -> Vec<String> {
        findings(&Tree::planted([
            ("README.md", readme),
            ("CHANGELOG.md", changelog),
            ("xtask/src/main.rs", MAIN),
            ("examples/print_module.rs", ""),
        ]))
    }

    #[test]
    fn good_pages_pass() {
        assert_eq!(planted(README, CHANGELOG), [""; 0]);
    }

    #[test]
    fn each_fault_is_found() {
        for (readme, changelog, message) in [
            (README.replace("xtask ci", "ci"), CHANGELOG, "`cargo xtask ci` is not named"),
            (format!("{README}\nexamples/gone.rs"), CHANGELOG, "README.md:2: there is no example `gone`"),
            (format!("{README}\n--example gone"), CHANGELOG, "README.md:2: there is no example `gone`"),
            (README.replace("--example print_module", ""), CHANGELOG, "the example `print_module` is not named"),
            (README.to_owned(), "# Changelog", "neither"),
        ] {
            let found = planted(&readme, changelog);
            assert!(found.len() == 1 && found[0].contains(message), "{message}: {found:?}");
        }
    }
}
