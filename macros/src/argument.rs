//! The one string literal between the macro's parentheses.

use proc_macro::{Delimiter, Span, TokenStream, TokenTree};

const USAGE: &str = "include_wgsl! takes one string literal, the path of a WGSL file relative to CARGO_MANIFEST_DIR: \
                     include_wgsl!(\"shaders/terrain.wgsl\")";

/// The path that the macro was given, and where it stands.
///
/// # Errors
/// The place of the first wrong token and how to call the macro.
pub fn path(input: TokenStream) -> Result<(String, Span), (String, Span)> {
    let mut tokens = input.into_iter();
    let Some(first) = tokens.next() else {
        return Err((USAGE.to_owned(), Span::call_site()));
    };
    let span = first.span();
    let Some(path) = string(first) else {
        return Err((USAGE.to_owned(), span));
    };
    match (tokens.next(), tokens.next()) {
        (None, _) => Ok((path, span)),
        (Some(TokenTree::Punct(comma)), None) if comma.as_char() == ',' => Ok((path, span)),
        (Some(other), _) => Err((USAGE.to_owned(), other.span())),
    }
}

/// The value of a string literal, also of one that a `macro_rules!` fragment wraps in an invisible group.
fn string(token: TokenTree) -> Option<String> {
    match token {
        TokenTree::Literal(literal) => value(&literal.to_string()),
        TokenTree::Group(group) if group.delimiter() == Delimiter::None => {
            let mut inner = group.stream().into_iter();
            let value = string(inner.next()?);
            inner.next().is_none().then_some(value)?
        }
        _ => None,
    }
}

/// The value of a string literal's source: `"…"` with escaped quotes and backslashes only, or a raw string.
fn value(source: &str) -> Option<String> {
    if let Some(raw) = source.strip_prefix('r') {
        let hashes = raw.len() - raw.trim_start_matches('#').len();
        let quoted = raw.get(hashes..raw.len().checked_sub(hashes)?)?;
        return quoted.strip_prefix('"')?.strip_suffix('"').map(str::to_owned);
    }
    let mut value = String::new();
    let mut characters = source.strip_prefix('"')?.strip_suffix('"')?.chars();
    while let Some(character) = characters.next() {
        value.push(match character {
            '\\' => characters.next().filter(|&escaped| matches!(escaped, '\\' | '"' | '\''))?,
            plain => plain,
        });
    }
    Some(value)
}

#[cfg(test)]
mod tests {
    use super::value;

    #[test]
    fn strings_plain_and_raw() {
        for (source, expected) in [
            (r#""shaders/terrain.wgsl""#, Some("shaders/terrain.wgsl")),
            (r#""a\\b\"c""#, Some(r#"a\b"c"#)),
            (r#"r"a\b""#, Some(r"a\b")),
            (r###"r##"a"#b"##"###, Some(r##"a"#b"##)),
            (r#""""#, Some("")),
        ] {
            assert_eq!(value(source).as_deref(), expected, "{source}");
        }
    }

    #[test]
    fn everything_else_is_refused() {
        for source in [r#"b"a""#, r#"c"a""#, r#"br"a""#, "'a'", "1", r#""a"suffix"#, r#""\n""#, r#""\u{61}""#] {
            assert_eq!(value(source), None, "{source}");
        }
    }
}
