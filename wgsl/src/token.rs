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
    let bytes = text.as_bytes();
    let mut tokens = Vec::with_capacity(text.len() / 4);
    let mut at = 0;
    while let Some(&first) = bytes.get(at) {
        let (kind, length) = match first {
            b' ' | b'\t'..=b'\r' => {
                at += 1;
                continue;
            }
            b'/' if bytes.get(at + 1) == Some(&b'/') => (TokenKind::Comment, line_comment(&text[at..])),
            b'/' if bytes.get(at + 1) == Some(&b'*') => (TokenKind::Comment, block_comment(&bytes[at..])),
            _ if is_plain(first) => (TokenKind::Word, word(&text[at..])),
            _ if first.is_ascii() => (TokenKind::Mark(first), 1),
            _ => match text[at..].chars().next().filter(|&character| is_blank(character)) {
                Some(blank) => {
                    at += blank.len_utf8();
                    continue;
                }
                None => (TokenKind::Word, word(&text[at..])),
            },
        };
        tokens.push(Token { kind, range: at..at + length });
        at += length;
    }
    tokens
}

/// Up to the line's end, which is mostly a byte of its own.
fn line_comment(text: &str) -> usize {
    let may_end = |byte: &u8| matches!(byte, b'\n'..=b'\r' | 0xc2 | 0xe2);
    let mut at = 0;
    while let Some(next) = text.as_bytes()[at..].iter().position(may_end) {
        at += next;
        match text[at..].chars().next() {
            Some(other) if !is_line_break(other) => at += other.len_utf8(),
            _ => return at,
        }
    }
    text.len()
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

/// Whether a byte is an ASCII letter, a digit or a low line.
fn is_plain(byte: u8) -> bool {
    byte.is_ascii_alphanumeric() || byte == b'_'
}

/// A number keeps its point (`1.0`, `2.`), so that its exponent or suffix is not taken for a member.
fn word(text: &str) -> usize {
    let bytes = text.as_bytes();
    let number = bytes.first().is_some_and(u8::is_ascii_digit);
    let plain = bytes.iter().position(|&byte| !(is_plain(byte) || number && byte == b'.')).unwrap_or(bytes.len());
    if bytes.get(plain).is_none_or(u8::is_ascii) {
        return plain;
    }
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
