//! WGSL as words and marks with their lines, without comments.

/// A word (identifier, keyword or number) or a single mark.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Word<'a> {
    /// As written.
    pub text: &'a str,
    /// Line from 1.
    pub line: usize,
}

/// Words and marks in order. The shelf has no block comments (the lint sees to that).
pub fn words(text: &str) -> Vec<Word<'_>> {
    let mut found = Vec::new();
    for (index, line) in text.lines().enumerate() {
        let code = &line[..line.find("//").unwrap_or(line.len())];
        let mut rest = code;
        while let Some(first) = rest.chars().next() {
            let belongs = |letter: char| letter.is_alphanumeric() || letter == '_';
            let number = first.is_ascii_digit();
            let length = if belongs(first) {
                rest.find(|letter: char| !(belongs(letter) || number && letter == '.')).unwrap_or(rest.len())
            } else {
                first.len_utf8()
            };
            let (text, tail) = rest.split_at(length);
            if !first.is_whitespace() {
                found.push(Word { text, line: index + 1 });
            }
            rest = tail;
        }
    }
    found
}

/// Whether a word is an identifier or keyword.
pub fn is_name(text: &str) -> bool {
    text.starts_with(|first: char| first.is_alphabetic() || first == '_')
}

#[test]
fn words_know_their_lines() {
    let found = words("let a = 1.5e3; // let b\nf(a.x)");
    let texts: Vec<_> = found.iter().map(|word| (word.text, word.line)).collect();
    assert_eq!(
        texts,
        [
            ("let", 1),
            ("a", 1),
            ("=", 1),
            ("1.5e3", 1),
            (";", 1),
            ("f", 2),
            ("(", 2),
            ("a", 2),
            (".", 2),
            ("x", 2),
            (")", 2)
        ]
    );
}
