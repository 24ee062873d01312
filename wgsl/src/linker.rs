//! From the names that a text mentions to the declarations that it needs.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt;
use std::sync::OnceLock;

use crate::scan::{self, Declaration};
use crate::{File, FILES};

/// A name of the shelf that a text declares too.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Collision {
    /// The name.
    pub name: String,
    /// Line of the text's declaration, from 1.
    pub line: usize,
    /// Column of the text's declaration, from 1.
    pub column: usize,
    /// The shelf file that declares the name.
    pub shelf_path: &'static str,
    /// The line of the shelf's declaration, from 1.
    pub shelf_line: usize,
}

impl fmt::Display for Collision {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { name, line, column, shelf_path, shelf_line } = self;
        write!(
            formatter,
            "{line}:{column}: `{name}` is declared here and by the shelf at {shelf_path}:{shelf_line}; rename yours"
        )
    }
}

impl std::error::Error for Collision {}

struct Entry {
    file: &'static File,
    declaration: Declaration<'static>,
    needs: Vec<usize>,
}

/// The shelf, scanned once a process: its declarations in order, and the order number of every name.
struct Shelf {
    entries: Vec<Entry>,
    index: BTreeMap<&'static str, usize>,
}

fn shelf() -> &'static Shelf {
    static SHELF: OnceLock<Shelf> = OnceLock::new();
    SHELF.get_or_init(|| {
        let mut entries: Vec<Entry> = FILES
            .iter()
            .flat_map(|file| scan::declarations(file.text).into_iter().map(move |declaration| (file, declaration)))
            .map(|(file, declaration)| Entry { file, declaration, needs: Vec::new() })
            .collect();
        let index: BTreeMap<_, _> =
            entries.iter().enumerate().map(|(number, entry)| (entry.declaration.name, number)).collect();
        for entry in &mut entries {
            let needs: BTreeSet<usize> =
                scan::mentions(entry.declaration.text).filter_map(|name| index.get(name).copied()).collect();
            entry.needs = needs.into_iter().collect();
        }
        Shelf { entries, index }
    })
}

/// The text with every shelf declaration behind it that it needs, and no other.
///
/// The text itself is kept byte for byte and comes first, so that line numbers in messages stay its own. The shelf's
/// comments are kept. The same text gives the same bytes on every machine.
///
/// # Errors
/// The first [`Collision`], where the text declares a name of the shelf.
pub fn link(text: &str) -> Result<String, Collision> {
    if let Some(collision) = collisions(text).into_iter().next() {
        return Err(collision);
    }
    let mut linked = text.to_owned();
    for (_, declaration) in mentioned(text) {
        if !linked.is_empty() && !linked.ends_with('\n') {
            linked.push('\n');
        }
        linked.push('\n');
        linked.push_str(declaration.text);
        linked.push('\n');
    }
    Ok(linked)
}

/// Every shelf declaration that a text needs, with the path of its file, in shelf order.
pub fn mentioned(text: &str) -> Vec<(&'static str, &'static Declaration<'static>)> {
    let shelf = shelf();
    let mut open: Vec<usize> = scan::mentions(text).filter_map(|name| shelf.index.get(name).copied()).collect();
    let mut needed = BTreeSet::new();
    while let Some(number) = open.pop() {
        if needed.insert(number) {
            open.extend(&shelf.entries[number].needs);
        }
    }
    needed.iter().map(|&number| &shelf.entries[number]).map(|entry| (entry.file.path, &entry.declaration)).collect()
}

/// Every declaration of a text that bears a name of the shelf, in the text's order.
pub fn collisions(text: &str) -> Vec<Collision> {
    let shelf = shelf();
    let collision = |declaration: Declaration<'_>| {
        let entry = &shelf.entries[*shelf.index.get(declaration.name)?];
        Some(Collision {
            name: declaration.name.to_owned(),
            line: declaration.line,
            column: declaration.column,
            shelf_path: entry.file.path,
            shelf_line: entry.declaration.line,
        })
    };
    scan::declarations(text).into_iter().filter_map(collision).collect()
}

/// The shelf name that a misspelled name most resembles, if one is near: at most a third of its letters differ.
pub fn nearest(name: &str) -> Option<&'static str> {
    let distance = |candidate: &str| edits(name.as_bytes(), candidate.as_bytes());
    let near = shelf().index.keys().map(|&candidate| (distance(candidate), candidate)).min()?;
    (near.0 <= name.len() / 3).then_some(near.1)
}

/// Levenshtein's distance, one row at a time.
fn edits(a: &[u8], b: &[u8]) -> usize {
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, x) in a.iter().enumerate() {
        let mut diagonal = row[0];
        row[0] = i + 1;
        for (j, y) in b.iter().enumerate() {
            let replaced = diagonal + usize::from(x != y);
            diagonal = row[j + 1];
            row[j + 1] = replaced.min(diagonal + 1).min(row[j] + 1);
        }
    }
    row[b.len()]
}
