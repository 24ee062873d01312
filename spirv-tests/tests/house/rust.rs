//! Rust files as tokens: paths into the crate, functions and their lengths, macros, without comments and strings.

use proc_macro2::{Delimiter, TokenStream, TokenTree};

/// One token that is no group; a group gives its opening and closing marks.
#[derive(Clone, Debug, PartialEq)]
pub struct Token {
    /// Identifier, one punctuation character, bracket, or literal as written.
    pub text: String,
    /// Line from 1.
    pub line: usize,
}

/// The tokens of a file in order, without its unit tests (items under `#[cfg(test)]`).
///
/// # Panics
/// The file is not Rust.
pub fn tokens(path: &str, text: &str) -> Vec<Token> {
    let stream: TokenStream = text.parse().unwrap_or_else(|error| panic!("{path}: {error}"));
    let mut flat = Vec::new();
    flatten(stream, &mut flat);
    without_tests(flat)
}

fn flatten(stream: TokenStream, flat: &mut Vec<Token>) {
    for tree in stream {
        let line = tree.span().start().line;
        match tree {
            TokenTree::Group(group) => {
                let (open, close) = match group.delimiter() {
                    Delimiter::Parenthesis => ("(", ")"),
                    Delimiter::Brace => ("{", "}"),
                    Delimiter::Bracket => ("[", "]"),
                    Delimiter::None => ("", ""),
                };
                flat.push(Token { text: open.to_owned(), line });
                flatten(group.stream(), flat);
                flat.push(Token { text: close.to_owned(), line: group.span_close().start().line });
            }
            other => flat.push(Token { text: other.to_string(), line }),
        }
    }
}

/// Drops `#[cfg(test)]` with the item behind it: up to its semicolon or its closing brace.
fn without_tests(tokens: Vec<Token>) -> Vec<Token> {
    const MARK: [&str; 7] = ["#", "[", "cfg", "(", "test", ")", "]"];
    let mut kept = Vec::with_capacity(tokens.len());
    let mut at = 0;
    while at < tokens.len() {
        let marked =
            tokens[at..].len() >= MARK.len() && tokens[at..].iter().zip(MARK).all(|(token, mark)| token.text == mark);
        if marked {
            at += MARK.len();
            at += item_length(&tokens[at..]);
        } else {
            kept.push(tokens[at].clone());
            at += 1;
        }
    }
    kept
}

fn item_length(tokens: &[Token]) -> usize {
    let mut depth = 0usize;
    for (index, token) in tokens.iter().enumerate() {
        match token.text.as_str() {
            "(" | "[" | "{" => depth += 1,
            ")" | "]" | "}" => depth = depth.saturating_sub(1),
            _ => {}
        }
        if depth == 0 && matches!(token.text.as_str(), "}" | ";") {
            return index + 1;
        }
    }
    tokens.len()
}

/// Every `crate::NAME` with its line, the names of `crate::{…}` one by one.
pub fn crate_paths(tokens: &[Token]) -> Vec<Token> {
    let mut found = Vec::new();
    for (index, window) in tokens.windows(4).enumerate() {
        let [word, first, second, next] = window else { continue };
        if word.text != "crate" || first.text != ":" || second.text != ":" {
            continue;
        }
        if next.text == "{" {
            found.extend(heads(&tokens[index + 3..]));
        } else {
            found.push(next.clone());
        }
    }
    found
}

/// The first word of every entry of a use tree's list, which begins at `{`.
fn heads(tokens: &[Token]) -> Vec<Token> {
    let mut found = Vec::new();
    let mut depth = 0usize;
    for (index, token) in tokens.iter().enumerate() {
        let begins = index > 0 && depth == 1 && matches!(tokens[index - 1].text.as_str(), "{" | ",");
        match token.text.as_str() {
            "{" => depth += 1,
            "}" => depth -= 1,
            _ if begins => found.push(token.clone()),
            _ => {}
        }
        if depth == 0 {
            break;
        }
    }
    found
}

/// A function: its name and where it begins, and how many lines it takes.
#[derive(Clone, Debug, PartialEq)]
pub struct Function {
    /// Its name.
    pub name: String,
    /// The line of its name.
    pub line: usize,
    /// Lines from its name to its closing brace; 0 without a body.
    pub lines: usize,
}

/// Every function, nested ones included.
pub fn functions(tokens: &[Token]) -> Vec<Function> {
    let is_word = |text: &str| text.starts_with(|first: char| first.is_alphabetic() || first == '_');
    let pairs = tokens.windows(2).enumerate();
    let named = pairs.filter(|(_, pair)| pair[0].text == "fn" && is_word(&pair[1].text));
    let function = |(index, pair): (usize, &[Token])| {
        let rest = &tokens[index + 2..];
        let last = &rest[..item_length(rest)].last();
        let lines = last.filter(|last| last.text == "}").map_or(0, |last| last.line - pair[1].line + 1);
        Function { name: pair[1].text.clone(), line: pair[1].line, lines }
    };
    named.map(function).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const FILE: &str = "
use crate::{error::Error, table::{Table, Level}, Scene};
/// Not crate::comment.
fn long(a: [u8; 2]) -> u32 {
    let text = \"crate::string\";
    crate::filter::texture(text)
}
trait Short { fn declared(&self); }
#[cfg(test)]
mod tests {
    use crate::gpu;
}
fn after() {}
";

    #[test]
    fn paths_are_those_of_code() {
        let paths = crate_paths(&tokens("planted.rs", FILE));
        let names: Vec<_> = paths.iter().map(|token| (token.text.as_str(), token.line)).collect();
        assert_eq!(names, [("error", 2), ("table", 2), ("Scene", 2), ("filter", 6)]);
    }

    #[test]
    fn functions_have_lengths() {
        let functions = functions(&tokens("planted.rs", FILE));
        let found: Vec<_> = functions.iter().map(|function| (function.name.as_str(), function.lines)).collect();
        assert_eq!(found, [("long", 4), ("declared", 0), ("after", 1)]);
    }
}
