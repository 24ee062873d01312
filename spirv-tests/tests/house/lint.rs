//! The shelf's rules: names, contracts, purity, guarded arguments.

use prefilter_wgsl::{declarations, Declaration, Kind};

use crate::reserved;
use crate::shelf_edges::room;
use crate::tree::{stem, Tree};
use crate::wgsl::{is_name, words, Word};

/// Calls that need a fragment stage, an implicit level of detail, or more than WebGL2.
const IMPURE: &[&str] = &[
    "dpdx",
    "dpdxCoarse",
    "dpdxFine",
    "dpdy",
    "dpdyCoarse",
    "dpdyFine",
    "fwidth",
    "fwidthCoarse",
    "fwidthFine",
    "textureSample",
    "textureSampleBias",
    "textureSampleCompare",
    "textureGather",
    "textureGatherCompare",
    "textureStore",
    "workgroupBarrier",
    "storageBarrier",
];

/// Functions that return NaN or worse for arguments that devices disagree on.
const GUARDED: &[&str] = &["tanh", "pow", "log", "log2"];

/// Beginnings of the types that a contract's box bounds; structures, textures and samplers it describes in words.
const NUMBERS: &[&str] = &["f32", "i32", "u32", "bool", "vec", "mat", "array"];

/// Every breach of the rules, in all files of the shelf.
pub fn findings(tree: &Tree) -> Vec<String> {
    let stems: Vec<&str> = tree.below("wgsl/", ".wgsl").map(|(path, _)| stem(path)).collect();
    let mut findings = Vec::new();
    for (path, text) in tree.below("wgsl/", ".wgsl") {
        let mut report = |line: usize, message: String| findings.push(format!("{path}:{line}: {message}"));
        let pass = room(path) == "pass";
        for declaration in declarations(text) {
            top_level(&declaration, stem(path), &stems, &mut report);
            if declaration.kind == Kind::Function && !pass {
                contract(&declaration, &mut report);
            }
        }
        let words = words(text);
        declared(&words, &mut report);
        guarded(&words, &mut report);
        if !pass {
            pure(&words, &mut report);
        }
        for (index, line) in text.lines().enumerate().filter(|(_, line)| line.contains("/*")) {
            report(index + 1, format!("block comment; the shelf's comments are lines: {}", line.trim()));
        }
    }
    findings
}

/// The file's stem prefixes the name, and no longer stem does; everything is documented.
fn top_level(declaration: &Declaration<'_>, stem: &str, stems: &[&str], report: &mut impl FnMut(usize, String)) {
    let Declaration { name, line, .. } = declaration;
    let prefixes = |stem: &str| name.strip_prefix(stem).is_some_and(|rest| rest.is_empty() || rest.starts_with('_'));
    if !prefixes(stem) {
        report(*line, format!("`{name}` does not begin with its file's stem `{stem}`"));
    }
    if let Some(other) = stems.iter().find(|other| other.len() > stem.len() && prefixes(other)) {
        report(*line, format!("`{name}` begins with the stem `{other}` of another file"));
    }
    if let Some(language) = reserved::language(name) {
        report(*line, format!("`{name}` is reserved in {language}"));
    }
    if declaration.documentation().trim().is_empty() {
        report(*line, format!("`{name}` has no documentation"));
    }
}

/// `Source:`, `Domain:` and `Error:`, and every number among the parameters named in the domain.
fn contract(declaration: &Declaration<'_>, report: &mut impl FnMut(usize, String)) {
    let documentation = declaration.documentation();
    let section = |title: &str| documentation.lines().position(|line| line.starts_with(title));
    for title in ["Source:", "Domain:", "Error:"] {
        if section(title).is_none() {
            report(declaration.line, format!("`{}` has no `{title}` in its contract", declaration.name));
        }
    }
    let start = section("Domain:").unwrap_or(usize::MAX);
    let domain: Vec<&str> = documentation
        .lines()
        .skip(start)
        .enumerate()
        .take_while(|(index, line)| *index == 0 || !(line.is_empty() || line.starts_with("Error:")))
        .flat_map(|(_, line)| line.split(|letter: char| !(letter.is_alphanumeric() || letter == '_')))
        .collect();
    for (name, kind) in parameters(&declaration.signature) {
        let number = NUMBERS.iter().any(|number| kind.starts_with(number));
        if start != usize::MAX && number && !domain.contains(&name) {
            report(declaration.line, format!("the domain of `{}` does not name `{name}`", declaration.name));
        }
    }
}

/// Names and types of a signature's parameters.
fn parameters(signature: &str) -> Vec<(&str, &str)> {
    let inside = signature.split_once('(').map_or("", |(_, rest)| rest);
    let inside = &inside[..inside.rfind(')').unwrap_or(inside.len())];
    inside.split(',').filter_map(|parameter| parameter.split_once(':')).map(|(a, b)| (a.trim(), b.trim())).collect()
}

/// Names of declarations, parameters, members and locals: snake case, and no language's word.
fn declared(words: &[Word<'_>], report: &mut impl FnMut(usize, String)) {
    for (index, word) in words.iter().enumerate().filter(|(_, word)| is_name(word.text)) {
        let before = index.checked_sub(1).map_or("", |before| words[before].text);
        let after = words.get(index + 1).map_or("", |after| after.text);
        let template = before == ">" && words[..index].iter().rev().take(6).any(|earlier| earlier.text == "var");
        let declares =
            matches!(before, "fn" | "struct" | "let" | "var" | "const" | "alias") || template || after == ":";
        let label = before == "case" || word.text == "default";
        if !declares || label {
            continue;
        }
        let snake = word.text.bytes().all(|byte| byte.is_ascii_lowercase() || byte.is_ascii_digit() || byte == b'_');
        if !snake || word.text.contains("__") || word.text.ends_with(|last: char| last.is_ascii_digit() || last == '_')
        {
            let rule = "is not snake case with single underscores and a letter last";
            report(word.line, format!("`{}` {rule}", word.text));
        }
        let keeps = |list: &str| list.split_ascii_whitespace().any(|kept| kept == word.text);
        if let Some(found) = reserved::LANGUAGES.iter().find(|found| keeps(found.words)) {
            report(word.line, format!("`{}` is a word of {}", word.text, found.language));
        }
    }
}

/// No derivative, implicit level of detail, entry point, binding, global or override; NaN is not tested by `x != x`.
fn pure(words: &[Word<'_>], report: &mut impl FnMut(usize, String)) {
    let mut depth = 0usize;
    for (index, word) in words.iter().enumerate() {
        let after = |offset: usize| words.get(index + offset).map_or("", |after| after.text);
        match word.text {
            "{" => depth += 1,
            "}" => depth = depth.saturating_sub(1),
            "@" if after(1) != "must_use" => {
                report(word.line, format!("attribute `@{}`: bindings and entry points live in pass/", after(1)))
            }
            "var" | "override" if depth == 0 => report(word.line, format!("`{}` at module scope", word.text)),
            name if IMPURE.contains(&name) && after(1) == "(" => report(word.line, format!("call of `{name}`")),
            name if is_name(name) && (after(1), after(2), after(3)) == ("!", "=", name) && after(4) != "." => {
                report(word.line, format!("`{name} != {name}` is false for NaN; test its bits"));
            }
            _ => {}
        }
    }
}

/// Arguments of `tanh`, `pow` and logarithms are clamped where they stand or where their local is declared.
fn guarded(words: &[Word<'_>], report: &mut impl FnMut(usize, String)) {
    let clamps = |words: &[Word<'_>]| words.iter().any(|word| matches!(word.text, "clamp" | "min" | "max"));
    let mut safe: Vec<&str> = Vec::new();
    for (index, word) in words.iter().enumerate() {
        let rest = &words[index + 1..];
        match word.text {
            "fn" => safe.clear(),
            "let" | "var" => {
                let statement = &rest[..rest.iter().position(|word| word.text == ";").unwrap_or(rest.len())];
                if clamps(statement) {
                    safe.extend(statement.first().map(|name| name.text));
                }
            }
            name if GUARDED.contains(&name) && rest.first().is_some_and(|next| next.text == "(") => {
                let argument = first_argument(&rest[1..]);
                if !clamps(argument) && !argument.iter().any(|word| safe.contains(&word.text)) {
                    report(word.line, format!("the argument of `{name}` is not clamped"));
                }
            }
            _ => {}
        }
    }
}

/// The words up to the comma or the parenthesis that ends the first argument.
fn first_argument<'a>(words: &'a [Word<'a>]) -> &'a [Word<'a>] {
    let mut depth = 0usize;
    for (index, word) in words.iter().enumerate() {
        match word.text {
            "," | ")" if depth == 0 => return &words[..index],
            "(" => depth += 1,
            ")" => depth -= 1,
            _ => {}
        }
    }
    words
}

#[cfg(test)]
mod tests {
    use super::*;

    const CONTRACT: &str = "/// Mean.
///
/// Source: a.
/// Domain: mean in [0, 1],
///   deviation log in [1e-3, 1].
/// Error: 1e-6 absolute; rounding.
";

    fn planted(code: &str) -> Vec<String> {
        findings(&Tree::planted([("wgsl/math/normal.wgsl", code), ("wgsl/math/normal_tail.wgsl", "")]))
    }

    #[test]
    fn a_good_file_passes() {
        let good = "fn normal_mean(mean: f32, deviation: f32, map: texture_2d<f32>) -> f32 {
            let x = max(mean, 0.1);
            switch i32(mean) { case 1: { return x; } default: {} }
            return log(x) + tanh(clamp(mean, -9.0, 9.0)) * deviation;
        }";
        assert_eq!(planted(&format!("{CONTRACT}{good}")), [""; 0]);
    }

    #[test]
    fn each_fault_is_found() {
        for (code, message) in [
            ("fn tail_mean(mean: f32, deviation: f32) {}", "does not begin with"),
            ("fn normal_tail_mean(mean: f32, deviation: f32) {}", "another file"),
            ("fn normal_mean(mean: f32, width: f32) {}", "does not name `width`"),
            ("fn normal_mean(mean: f32, deviation: f32) { let half = 1.0; }", "`half` is a word of"),
            ("fn normal_mean(mean: f32, deviation: f32) { let meanOf = 1.0; }", "snake case"),
            ("fn normal_mean(mean: f32, deviation: f32) { let mean_2 = 1.0; }", "snake case"),
            ("fn normal__mean(mean: f32, deviation: f32) {}", "snake case"),
            ("fn normal_mean(mean: f32, deviation: f32) { let a = dpdx(mean); }", "call of `dpdx`"),
            ("fn normal_mean(mean: f32, deviation: f32) { if mean != mean { return; } }", "is false for NaN"),
            (
                "fn normal_mean(mean: f32, deviation: f32) { let a = pow(mean, max(0.0, mean)); }",
                "`pow` is not clamped",
            ),
            ("fn normal_mean(mean: f32, deviation: f32) { let a = tanh((mean)); }", "`tanh` is not clamped"),
            ("@fragment fn normal_mean(mean: f32, deviation: f32) {}", "attribute `@fragment`"),
            ("var<private> normal_state: f32;", "at module scope"),
            ("/* Mean. */ const normal_mean = 1.0;", "block comment"),
        ] {
            let found = planted(&format!("{CONTRACT}{code}"));
            assert!(found.len() == 1 && found[0].contains(message), "{code}: {found:?}");
        }
    }

    #[test]
    fn a_contract_is_whole() {
        for title in ["Source", "Domain", "Error"] {
            let contract = CONTRACT.replace(title, "Note");
            let found = planted(&format!("{contract}fn normal_mean(mean: f32, deviation: f32) {{}}"));
            assert!(found.len() == 1 && found[0].contains(&format!("no `{title}:`")), "{found:?}");
        }
        assert!(planted("const normal_reach = 8.0;")[0].contains("no documentation"));
    }
}
