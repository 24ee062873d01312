//! The tokens of a WGSL text, as far as declarations and names need them.

use std::ops::Range;

/// What a token is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TokenKind {
    /// A line comment without its line break, or a block comment.
    Comment,
    /// An identifier, a keyword or a number.
    Word,
    /// Any other character, which is ASCII.
    Mark(u8),
}

/// A token and the bytes that it takes.
#[derive(Clone, Debug)]
pub struct Token {
    pub kind: TokenKind,
    pub range: Range<usize>,
}

/// Comments, words (identifiers, keywords, numbers) and single marks; white space is left out.
pub fn tokens(text: &str) -> Vec<Token> {
    let mut tokens = Vec::new();
    let mut at = 0;
    while let Some(first) = text[at..].chars().next() {
        let rest = &text[at..];
        let (kind, length) = match first {
            blank if is_blank(blank) => {
                at += blank.len_utf8();
                continue;
            }
            _ if rest.starts_with("//") => (TokenKind::Comment, rest.find(is_line_break).unwrap_or(rest.len())),
            _ if rest.starts_with("/*") => (TokenKind::Comment, block_comment(rest.as_bytes())),
            letter if is_word(letter) => (TokenKind::Word, word(rest)),
            // All that is left is ASCII: one byte.
            mark => (TokenKind::Mark(mark as u8), mark.len_utf8()),
        };
        tokens.push(Token { kind, range: at..at + length });
        at += length;
    }
    tokens
}

/// WGSL's blankspace.
fn is_blank(character: char) -> bool {
    is_line_break(character) || matches!(character, ' ' | '\t' | '\u{200e}' | '\u{200f}')
}

/// What ends a line comment: line feed, vertical tab, form feed, carriage return and Unicode's line breaks.
fn is_line_break(character: char) -> bool {
    matches!(character, '\n'..='\r' | '\u{85}' | '\u{2028}' | '\u{2029}')
}

fn is_word(character: char) -> bool {
    character.is_ascii_alphanumeric() || character == '_' || (!character.is_ascii() && !is_blank(character))
}

/// A number keeps its point (`1.0`, `2.`), so that its exponent or suffix is not taken for a member.
fn word(text: &str) -> usize {
    let number = text.starts_with(|first: char| first.is_ascii_digit());
    let belongs = |character: char| is_word(character) || (number && character == '.');
    text.find(|character| !belongs(character)).unwrap_or(text.len())
}

/// Block comments nest in WGSL; an unclosed one ends with the text.
fn block_comment(bytes: &[u8]) -> usize {
    let mut depth = 0usize;
    let mut at = 0;
    while at < bytes.len() {
        match (bytes[at], bytes.get(at + 1)) {
            (b'/', Some(b'*')) => {
                depth += 1;
                at += 2;
            }
            (b'*', Some(b'/')) => {
                depth -= 1;
                at += 2;
                if depth == 0 {
                    break;
                }
            }
            _ => at += 1,
        }
    }
    at
}
