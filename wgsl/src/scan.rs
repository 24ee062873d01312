//! Where the declarations of a WGSL text begin and end, and which names they mention.
//!
//! A scanner, not a parser: it knows comments, identifiers and brackets. Whether a text is WGSL at all is naga's
//! affair.

use std::collections::BTreeSet;
use std::ops::Range;

use crate::token::{tokens, Token, TokenKind};

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
    /// The bytes of the scanned text from the body, the initializer or the semicolon to the declaration's end.
    pub body: Range<usize>,
    /// Line of the name in the scanned text, from 1.
    pub line: usize,
    /// Column of the name in that line in characters, from 1.
    pub column: usize,
    /// The text from the keyword to the body, the initializer or the semicolon, its white space folded.
    pub signature: String,
}

impl<'a> Declaration<'a> {
    /// The `///` lines above the declaration without their slashes.
    pub fn documentation(&self) -> String {
        let lines = self.text.lines().map_while(|line| line.trim_start().strip_prefix("///"));
        lines.map(|line| line.strip_prefix(' ').unwrap_or(line)).collect::<Vec<_>>().join("\n")
    }

    /// The names that the declaration mentions, its own included, in order and with repetitions.
    pub fn mentions(&self) -> impl Iterator<Item = &str> {
        mentions(self.text)
    }

    /// The names that the declaration mentions and does not declare for itself: its own, those of other declarations,
    /// built-ins and keywords.
    pub fn free(&self) -> BTreeSet<&'a str> {
        let scan = Scan::new(self.text);
        &scan.mentions().collect::<BTreeSet<_>>() - &scan.locals()
    }
}

/// The declarations at module scope of a WGSL text, in order.
pub fn declarations(text: &str) -> Vec<Declaration<'_>> {
    Scan::new(text).declarations()
}

/// The names that a text mentions outside comments, members and attributes aside.
pub fn mentions(text: &str) -> impl Iterator<Item = &str> {
    words(text, tokens(text).into_iter())
}

/// A text with its tokens, for those who ask it several questions.
pub struct Scan<'a> {
    text: &'a str,
    tokens: Vec<Token>,
}

impl<'a> Scan<'a> {
    /// The text's tokens.
    pub fn new(text: &'a str) -> Self {
        Self { text, tokens: tokens(text) }
    }

    /// As [`mentions`].
    pub fn mentions(&self) -> impl Iterator<Item = &'a str> + '_ {
        words(self.text, self.tokens.iter().cloned())
    }

    /// The names that a declaration declares for itself: parameters, members, and `let`, `var` and `const` in a body.
    pub fn locals(&self) -> BTreeSet<&'a str> {
        let text = self.text;
        let tokens: Vec<&Token> = self.tokens.iter().filter(|token| token.kind != TokenKind::Comment).collect();
        let mut locals = BTreeSet::new();
        for pair in tokens.windows(2) {
            let [first, second] = [&text[pair[0].range.clone()], &text[pair[1].range.clone()]];
            if pair[0].kind == TokenKind::Word && second == ":" {
                locals.insert(first);
            }
            if pair[1].kind == TokenKind::Word && matches!(first, "let" | "var" | "const") {
                locals.insert(second);
            }
        }
        locals
    }

    /// As [`declarations`].
    pub fn declarations(&self) -> Vec<Declaration<'a>> {
        let Self { text, tokens } = self;
        let mut found = Vec::new();
        let mut next = 0;
        let mut start = None; // of the comments and attributes that belong to the next declaration
        let mut attributed = false; // whether an attribute is among them: only comments are cut off by an empty line
        let mut end = 0; // of the last token
        let mut place = (1, 0); // a line and where it is known to be
        while let Some(token) = tokens.get(next) {
            let gap = &text[end..token.range.start];
            if gap.matches('\n').count() > 1 && !attributed {
                start = None;
            }
            let trailing = token.kind == TokenKind::Comment && end > 0 && !gap.contains('\n') && start.is_none();
            if !trailing {
                start.get_or_insert(token.range.start);
            }
            let mut last = next;
            match (keyword(&text[token.range.clone()]), token.kind) {
                (Some(kind), TokenKind::Word) => {
                    let extent = extent(tokens, next, kind);
                    last = extent.last;
                    let start = start.take().unwrap_or(token.range.start);
                    found.extend(declaration(text, tokens, start, &extent, kind, &mut place));
                    attributed = false;
                }
                (_, TokenKind::Mark(b';')) => (start, attributed) = (None, false),
                (_, TokenKind::Comment) => {}
                _ => attributed = true,
            }
            end = tokens[last].range.end;
            next = last + 1;
        }
        found
    }
}

/// The names among tokens, members and attributes aside.
fn words(text: &str, tokens: impl Iterator<Item = Token>) -> impl Iterator<Item = &str> {
    let mut before = b' ';
    tokens.filter_map(move |token| match token.kind {
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

/// Where a declaration lies among the tokens of its text.
struct Extent {
    /// The keyword.
    first: usize,
    /// The declared name, if there is one.
    name: Option<usize>,
    /// The first token behind the signature.
    head_end: usize,
    /// The closing brace or semicolon, or the last token of a text that lacks it.
    last: usize,
}

/// The extent of the declaration whose keyword is the token `first`.
fn extent(tokens: &[Token], first: usize, kind: Kind) -> Extent {
    let closing = if matches!(kind, Kind::Function | Kind::Structure) { b'}' } else { b';' };
    let mut depth = 0usize;
    let mut name = None;
    let mut head_end = None;
    for (index, token) in tokens.iter().enumerate().skip(first + 1) {
        let mark = match token.kind {
            TokenKind::Mark(mark) => mark,
            TokenKind::Word if name.is_none() && depth == 0 => {
                name = Some(index);
                continue;
            }
            _ => continue,
        };
        if depth == 0 && matches!(mark, b'{' | b'=' | b';') {
            head_end.get_or_insert(index);
        }
        match mark {
            b'(' | b'[' | b'{' => depth += 1,
            b')' | b']' | b'}' => depth = depth.saturating_sub(1),
            // The template list of `var<storage, read>` stands before the name.
            b'<' if name.is_none() => depth += 1,
            b'>' if name.is_none() => depth = depth.saturating_sub(1),
            _ => {}
        }
        if depth == 0 && mark == closing {
            return Extent { first, name, head_end: head_end.unwrap_or(index), last: index };
        }
    }
    Extent { first, name, head_end: head_end.unwrap_or(tokens.len()), last: tokens.len() - 1 }
}

/// The declaration of an extent, if it has a name; `start` is where its comments and attributes begin, and `place` the
/// number of a line and a place on it, before the declaration and then in it.
fn declaration<'a>(
    text: &'a str,
    tokens: &[Token],
    start: usize,
    extent: &Extent,
    kind: Kind,
    place: &mut (usize, usize),
) -> Option<Declaration<'a>> {
    let name = tokens[extent.name?].range.clone();
    let end = tokens[extent.last].range.end;
    let line_start = text[..name.start].rfind('\n').map_or(0, |at| at + 1);
    *place = (place.0 + text[place.1..name.start].matches('\n').count(), name.start);
    Some(Declaration {
        name: &text[name.clone()],
        kind,
        text: &text[start..end],
        body: tokens.get(extent.head_end).map_or(end, |token| token.range.start)..end,
        line: place.0,
        column: text[line_start..name.start].chars().count() + 1,
        signature: signature(text, &tokens[extent.first..extent.head_end]),
    })
}

/// The tokens without comments, with one space wherever anything stood between two of them.
fn signature(text: &str, tokens: &[Token]) -> String {
    let mut signature = String::new();
    let mut end = 0;
    for token in tokens.iter().filter(|token| token.kind != TokenKind::Comment) {
        if !signature.is_empty() && token.range.start > end {
            signature.push(' ');
        }
        signature.push_str(&text[token.range.clone()]);
        end = token.range.end;
    }
    signature
}
