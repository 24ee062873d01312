//! The files of the workspace, or planted ones.

use std::collections::BTreeMap;
use std::path::Path;

/// Texts by path from the workspace's root, with forward slashes.
#[derive(Default)]
pub struct Tree {
    /// The text of every text file; pictures and other binary files have an empty one.
    pub files: BTreeMap<String, String>,
}

impl Tree {
    /// What is on disk, without what `.gitignore` names, hidden folders and `shared`.
    pub fn workspace() -> Self {
        let root = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/.."));
        let ignored = std::fs::read_to_string(root.join(".gitignore")).unwrap_or_default();
        let mut ignored: Vec<&str> = ignored.lines().map(|line| line.trim_matches('/')).collect();
        ignored.extend([".git", "shared", "target"]);
        let mut tree = Self::default();
        tree.add(root, "", &ignored);
        tree
    }

    /// Planted files.
    #[cfg(test)]
    pub fn planted<const N: usize>(files: [(&str, &str); N]) -> Self {
        Self { files: files.map(|(path, text)| (path.to_owned(), text.to_owned())).into() }
    }

    fn add(&mut self, folder: &Path, prefix: &str, ignored: &[&str]) {
        let entries = std::fs::read_dir(folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
        for entry in entries.flatten() {
            let path = format!("{prefix}{}", entry.file_name().to_string_lossy());
            if ignored.contains(&path.as_str()) {
                continue;
            }
            if entry.path().is_dir() {
                self.add(&entry.path(), &format!("{path}/"), ignored);
            } else {
                let text = std::fs::read_to_string(entry.path()).unwrap_or_default();
                self.files.insert(path, text);
            }
        }
    }

    /// The files below a folder with an extension, by path.
    pub fn below<'a>(&'a self, folder: &'a str, extension: &'a str) -> impl Iterator<Item = (&'a str, &'a str)> {
        let files = self.files.iter().map(|(path, text)| (path.as_str(), text.as_str()));
        files.filter(move |(path, _)| path.starts_with(folder) && path.ends_with(extension))
    }

    /// Whether a Rust module has its file: `PATH.rs` or `PATH/mod.rs`.
    pub fn has_module(&self, path: &str) -> bool {
        self.files.contains_key(&format!("{path}.rs")) || self.files.contains_key(&format!("{path}/mod.rs"))
    }
}

/// The file's name without folders and extension.
pub fn stem(path: &str) -> &str {
    let name = path.rsplit('/').next().unwrap_or(path);
    name.split('.').next().unwrap_or(name)
}

#[test]
fn stems_and_modules() {
    assert_eq!(stem("wgsl/math/normal.wgsl"), "normal");
    let tree = Tree::planted([("src/table/mod.rs", ""), ("src/error.rs", "")]);
    assert!(tree.has_module("src/table") && tree.has_module("src/error") && !tree.has_module("src/scene"));
}
