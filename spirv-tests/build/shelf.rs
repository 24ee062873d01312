//! What naga has against the files of the shelf, in terms of the files.

use std::collections::BTreeMap;

use prefilter_wgsl::{declarations, mentioned, File};

use super::fault::check;

/// A message for every broken file and for every name that is declared twice: `wgsl/` and the file's path, line,
/// column, what is wrong, and naga's excerpt.
pub fn faults(files: &[File]) -> Vec<String> {
    let broken = files.iter().filter_map(broken);
    broken.chain(twice(files)).collect()
}

/// The fault of one file, behind which stands what it needs of the others: its lines are the lines of the whole.
fn broken(file: &File) -> Option<String> {
    let mut text = file.text.to_owned();
    for (path, declaration) in mentioned(file.text) {
        if path != file.path {
            text.push_str("\n\n");
            text.push_str(declaration.text);
        }
    }
    let path = format!("wgsl/{}", file.path);
    let fault = check(&path, &text).err()?;
    // A fault behind the file is another file's, unless an open brace of this one causes it.
    let elsewhere = fault.range.as_ref().is_some_and(|range| range.start >= file.text.len());
    match check(&path, file.text) {
        Err(alone) if elsewhere && !alone.message.contains("no definition in scope") => {
            Some(alone.report(&path, file.text))
        }
        _ if elsewhere => None,
        _ => Some(fault.report(&path, &text)),
    }
}

/// Names that two files declare.
fn twice(files: &[File]) -> Vec<String> {
    let mut places = BTreeMap::new();
    let mut messages = Vec::new();
    for file in files {
        for declaration in declarations(file.text) {
            let place = format!("wgsl/{}:{}:{}", file.path, declaration.line, declaration.column);
            if let Some(first) = places.insert(declaration.name, place.clone()) {
                messages.push(format!("{place}: `{}` is declared by {first} too", declaration.name));
            }
        }
    }
    messages
}
