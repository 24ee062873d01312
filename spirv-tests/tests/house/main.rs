//! The rules of the house, read from the files themselves: rooms, dependencies, the shelf's lint, names, sizes, words,
//! pages.
//!
//! Every check takes a tree of files and returns its findings, one line each that begins with the file; its own tests
//! plant the fault that it must find.

mod edges;
mod lint;
mod names;
mod pages;
#[path = "../../../src/reserved.rs"]
mod reserved;
mod rooms;
mod rust;
mod shelf_edges;
mod sizes;
mod tree;
mod vocabulary;
mod wgsl;
mod words;

use tree::Tree;

/// Fails with every finding.
fn clean(check: fn(&Tree) -> Vec<String>) {
    let tree = Tree::workspace();
    assert!(tree.files.len() > 20, "the tree holds {} files: not the workspace", tree.files.len());
    let findings = check(&tree);
    assert!(findings.is_empty(), "{} findings:\n{}", findings.len(), findings.join("\n"));
}

#[test]
fn every_concept_has_its_rooms() {
    clean(rooms::findings);
}

#[test]
fn rust_modules_depend_one_way() {
    clean(edges::findings);
}

#[test]
fn shelf_rooms_depend_one_way() {
    clean(shelf_edges::findings);
}

#[test]
fn the_shelf_keeps_its_rules() {
    clean(lint::findings);
}

#[test]
fn names_say_what_they_are() {
    clean(names::findings);
}

#[test]
fn files_and_functions_stay_small() {
    clean(sizes::findings);
}

#[test]
fn committed_text_is_finished_and_portable() {
    clean(words::findings);
}

#[test]
fn pages_name_what_exists() {
    clean(pages::findings);
}
