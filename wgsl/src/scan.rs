//! Where the declarations of a WGSL text begin and end, and which names they mention.
//!
//! A scanner, not a parser: it knows comments, identifiers and brackets. Whether a text is WGSL at all is naga's affair.

use std::ops::Range;

/// What a declaration declares.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// `fn`
    Function,
    /// `struct`
    Structure,
    /// `const`
    Constant,
    /// `alias`
    Alias,
    /// `var`, with or without an address space
    Variable,
    /// `override`
    Override,
}

/// A declaration at module scope.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Declaration<'a> {
    /// The declared name.
    pub name: &'a str,
    /// What it declares.
    pub kind: Kind,
    /// The whole declaration, with the comments right above it and its attributes.
    pub text: &'a str,
    /// Line of the name in the scanned text, from 1.
    pub line: usize,
    /// Column of the name in that line in characters, from 1.
    pub column: usize,
    /// The text from the keyword to the body, the initializer or the semicolon, its white space folded.
    pub signature: String,
}

impl Declaration<'_> {
    /// The `///` lines above the declaration without their slashes.
    pub fn documentation(&self) -> String {
        let lines = self.text.lines().map_while(|line| line.trim_start().strip_prefix("///"));
        lines.map(|line| line.strip_prefix(' ').unwrap_or(line)).collect::<Vec<_>>().join("\n")
    }

    /// The names that the declaration mentions, its own included, in order and with repetitions.
    pub fn mentions(&self) -> impl Iterator<Item = &str> {
        mentions(self.text)
    }
}

/// The declarations at module scope of a WGSL text, in order.
pub fn declarations(text: &str) -> Vec<Declaration<'_>> {
    let tokens = tokens(text);
    let mut found = Vec::new();
    let mut next = 0;
    let mut start = None; // of the comments and attributes that belong to the next declaration
    let mut end = 0; // of the last token
    while let Some(token) = tokens.get(next) {
        let gap = &text[end..token.range.start];
        if gap.matches('\n').count() > 1 {
            start = None;
        }
        let trailing = token.kind == TokenKind::Comment && !gap.contains('\n') && start.is_none();
        if !trailing {
            start.get_or_insert(token.range.start);
        }
        end = token.range.end;
        match (keyword(&text[token.range.clone()]), token.kind) {
            (Some(kind), TokenKind::Word) => {
                let (last, declaration) = declaration(text, &tokens, start.unwrap_or(token.range.start), next, kind);
                found.extend(declaration);
                next = last + 1;
                end = tokens[last].range.end;
                start = None;
            }
            (_, TokenKind::Mark(b';')) => {
                start = None;
                next += 1;
            }
            _ => next += 1,
        }
    }
    found
}

/// The names that a text mentions outside comments, members and attributes aside.
pub fn mentions(text: &str) -> impl Iterator<Item = &str> {
    let mut before = b' ';
    tokens(text).into_iter().filter_map(move |token| match token.kind {
        TokenKind::Comment => None,
        TokenKind::Mark(mark) => {
            before = mark;
            None
        }
        TokenKind::Word => {
            let free = before != b'.' && before != b'@';
            before = b' ';
            free.then(|| &text[token.range])
        }
    })
}

fn keyword(word: &str) -> Option<Kind> {
    Some(match word {
        "fn" => Kind::Function,
        "struct" => Kind::Structure,
        "const" => Kind::Constant,
        "alias" => Kind::Alias,
        "var" => Kind::Variable,
        "override" => Kind::Override,
        _ => return None,
    })
}

/// The declaration whose keyword is the token `first`, and the index of its last token.
fn declaration<'a>(
    text: &'a str,
    tokens: &[Token],
    start: usize,
    first: usize,
    kind: Kind,
) -> (usize, Option<Declaration<'a>>) {
    let braced = matches!(kind, Kind::Function | Kind::Structure);
    let mut depth = 0usize;
    let mut name = None;
    let mut signature_end = None;
    let mut last = tokens.len() - 1;
    for (index, token) in tokens.iter().enumerate().skip(first + 1) {
        match token.kind {
            TokenKind::Comment => {}
            TokenKind::Word if name.is_none() && depth == 0 => name = Some(token.range.clone()),
            TokenKind::Word => {}
            TokenKind::Mark(mark) => {
                if depth == 0 && matches!(mark, b'{' | b'=' | b';') {
                    signature_end.get_or_insert(token.range.start);
                }
                match mark {
                    b'(' | b'[' | b'{' => depth += 1,
                    // The template list of `var<storage, read>` stands before the name.
                    b'<' if name.is_none() => depth += 1,
                    b'>' if name.is_none() => depth = depth.saturating_sub(1),
                    b')' | b']' | b'}' => depth = depth.saturating_sub(1),
                    _ => {}
                }
                if depth == 0 && mark == if braced { b'}' } else { b';' } {
                    last = index;
                    break;
                }
            }
        }
    }
    let declaration = name.map(|name| {
        let end = tokens[last].range.end;
        let head = &text[tokens[first].range.start..signature_end.unwrap_or(end)];
        let line_start = text[..name.start].rfind('\n').map_or(0, |at| at + 1);
        Declaration {
            name: &text[name.clone()],
            kind,
            text: &text[start..end],
            line: text[..name.start].matches('\n').count() + 1,
            column: text[line_start..name.start].chars().count() + 1,
            signature: head.split_whitespace().collect::<Vec<_>>().join(" "),
        }
    });
    (last, declaration)
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum TokenKind {
    Comment,
    Word,
    Mark(u8),
}

#[derive(Clone, Debug)]
struct Token {
    kind: TokenKind,
    range: Range<usize>,
}

/// Comments, words (identifiers, keywords, numbers) and single marks; white space is left out.
fn tokens(text: &str) -> Vec<Token> {
    let bytes = text.as_bytes();
    let mut tokens = Vec::new();
    let mut at = 0;
    while at < bytes.len() {
        let (kind, length) = match bytes[at] {
            byte if byte.is_ascii_whitespace() => {
                at += 1;
                continue;
            }
            b'/' if bytes.get(at + 1) == Some(&b'/') => (TokenKind::Comment, line_comment(&bytes[at..])),
            b'/' if bytes.get(at + 1) == Some(&b'*') => (TokenKind::Comment, block_comment(&bytes[at..])),
            byte if is_word(byte) => (TokenKind::Word, word(&bytes[at..])),
            mark => (TokenKind::Mark(mark), 1),
        };
        tokens.push(Token { kind, range: at..at + length });
        at += length;
    }
    tokens
}

fn is_word(byte: u8) -> bool {
    byte.is_ascii_alphanumeric() || byte == b'_' || byte >= 0x80
}

/// A number keeps its point (`1.0`, `2.`, `.5e3`), so that a suffix or exponent is not taken for a member.
fn word(bytes: &[u8]) -> usize {
    let number = bytes[0].is_ascii_digit();
    let belongs = |&byte: &u8| is_word(byte) || (number && byte == b'.');
    bytes.iter().take_while(|byte| belongs(byte)).count()
}

fn line_comment(bytes: &[u8]) -> usize {
    bytes.iter().take_while(|&&byte| byte != b'\n').count()
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
