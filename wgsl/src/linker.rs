//! From the names that a text mentions to the declarations that it needs.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt;
use std::sync::OnceLock;

use crate::scan::{self, Declaration, Scan};
use crate::{File, FILES};

/// A declaration of a text that would change what the shelf means.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Collision {
    /// The name.
    pub name: String,
    /// Line of the text's declaration, from 1.
    pub line: usize,
    /// Column of the text's declaration, from 1.
    pub column: usize,
    /// The shelf file that declares the name, or that uses a built-in of this name.
    pub shelf_path: &'static str,
    /// The line of the shelf's declaration, from 1.
    pub shelf_line: usize,
    /// The shelf declaration whose built-in the text would replace; none where the shelf declares the name itself.
    pub replaced_in: Option<&'static str>,
}

impl fmt::Display for Collision {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { name, line, column, shelf_path, shelf_line, replaced_in } = self;
        write!(formatter, "{line}:{column}: `{name}` is declared here and ")?;
        match replaced_in {
            None => write!(formatter, "by the shelf at {shelf_path}:{shelf_line}")?,
            Some(user) => {
                write!(formatter, "hides the built-in that `{user}` of the shelf uses at {shelf_path}:{shelf_line}")?
            }
        }
        write!(formatter, "; rename yours")
    }
}

impl std::error::Error for Collision {}

struct Entry {
    file: &'static File,
    declaration: Declaration<'static>,
    /// The shelf declarations that it mentions, by order number.
    needs: Vec<usize>,
    /// What else it mentions and does not declare for itself: built-ins and keywords.
    built_ins: BTreeSet<&'static str>,
}

/// The shelf, scanned once a process: its declarations in order, and the order number of every name.
struct Shelf {
    entries: Vec<Entry>,
    index: BTreeMap<&'static str, usize>,
    /// The lengths of the names, a bit each, by their first bytes: most words of a text are no name of the shelf.
    lengths: [u64; 256],
    /// What any of the declarations mentions of built-ins and keywords.
    built_ins: BTreeSet<&'static str>,
}

impl Shelf {
    /// The order number of a name.
    fn number(&self, name: &str) -> Option<usize> {
        let may_be = name.bytes().next().is_some_and(|first| self.lengths[usize::from(first)] & length(name) != 0);
        if may_be {
            self.index.get(name).copied()
        } else {
            None
        }
    }
}

/// The bit of a name's length, one for all long names.
fn length(name: &str) -> u64 {
    1 << name.len().min(63)
}

fn shelf() -> &'static Shelf {
    static SHELF: OnceLock<Shelf> = OnceLock::new();
    SHELF.get_or_init(|| {
        let mut entries: Vec<Entry> = FILES
            .iter()
            .flat_map(|file| scan::declarations(file.text).into_iter().map(move |declaration| (file, declaration)))
            .map(|(file, declaration)| Entry { file, declaration, needs: Vec::new(), built_ins: BTreeSet::new() })
            .collect();
        let index: BTreeMap<_, _> =
            entries.iter().enumerate().map(|(number, entry)| (entry.declaration.name, number)).collect();
        for entry in &mut entries {
            let scan = Scan::new(entry.declaration.text);
            let mentions: BTreeSet<&str> = scan.mentions().collect();
            entry.needs = mentions.iter().filter_map(|name| index.get(name).copied()).collect();
            entry.built_ins = &mentions - &scan.locals();
        }
        let mut lengths = [0; 256];
        for name in index.keys() {
            name.bytes().take(1).for_each(|first| lengths[usize::from(first)] |= length(name));
        }
        let built_ins = entries.iter().flat_map(|entry| entry.built_ins.iter().copied()).collect();
        Shelf { entries, index, lengths, built_ins }
    })
}

/// The text with every shelf declaration behind it that it needs, and no other.
///
/// The text itself is kept byte for byte and comes first, so that line numbers in messages stay its own. The shelf's
/// comments are kept. The same text gives the same bytes on every machine.
///
/// # Errors
/// The first [`Collision`], where the text declares a name of the shelf, or a name that hides a built-in function or
/// type from the shelf declarations that it needs.
pub fn link(text: &str) -> Result<String, Collision> {
    let scan = Scan::new(text);
    let needed = needed(&scan);
    if let Some(collision) = collisions_with(&scan, &needed).into_iter().next() {
        return Err(collision);
    }
    let mut linked = text.to_owned();
    for Entry { declaration, .. } in needed {
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
    needed(&Scan::new(text)).into_iter().map(|entry| (entry.file.path, &entry.declaration)).collect()
}

/// The shelf declarations that a text mentions, directly or through one another, in shelf order.
fn needed(text: &Scan<'_>) -> Vec<&'static Entry> {
    let shelf = shelf();
    let mut open: Vec<usize> = text.mentions().filter_map(|name| shelf.number(name)).collect();
    let mut needed = BTreeSet::new();
    while let Some(number) = open.pop() {
        if needed.insert(number) {
            open.extend(&shelf.entries[number].needs);
        }
    }
    needed.into_iter().map(|number| &shelf.entries[number]).collect()
}

/// Every declaration of a text that bears a name of the shelf or hides a built-in from what the text needs of it, in
/// the text's order.
pub fn collisions(text: &str) -> Vec<Collision> {
    let scan = Scan::new(text);
    collisions_with(&scan, &needed(&scan))
}

fn collisions_with(text: &Scan<'_>, needed: &[&'static Entry]) -> Vec<Collision> {
    let shelf = shelf();
    let collision = |declaration: Declaration<'_>| {
        let declared = shelf.number(declaration.name).map(|number| &shelf.entries[number]);
        let any = shelf.built_ins.contains(declaration.name);
        let hidden = || needed.iter().copied().find(|entry| any && entry.built_ins.contains(declaration.name));
        let entry = declared.or_else(hidden)?;
        Some(Collision {
            name: declaration.name.to_owned(),
            line: declaration.line,
            column: declaration.column,
            shelf_path: entry.file.path,
            shelf_line: entry.declaration.line,
            replaced_in: declared.is_none().then_some(entry.declaration.name),
        })
    };
    text.declarations().into_iter().filter_map(collision).collect()
}

/// The name of the shelf or of a declaration of the text that a misspelled name most resembles, if one is near: at most
/// a third of its letters differ.
pub fn nearest<'a>(name: &str, text: &'a str) -> Option<&'a str> {
    let distance = |candidate: &str| edits(name.as_bytes(), candidate.as_bytes());
    let declared = scan::declarations(text).into_iter().map(|declaration| declaration.name);
    let known = shelf().index.keys().copied().chain(declared);
    let near = known.map(|candidate| (distance(candidate), candidate)).min()?;
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
