//! A hash of the files that ground truths are made of, whichever they are: one that changes makes all of them anew.

use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::{Path, PathBuf};

/// The references and what makes them of maps, what samples pictures, and the images.
const FOLDERS: [&str; 4] = ["../src/reference", "../src/transfer", "src/imaging", "../examples/data"];

/// The hash; every folder is watched.
pub fn hash() -> std::io::Result<u64> {
    let mut hasher = DefaultHasher::new();
    for folder in FOLDERS {
        println!("cargo::rerun-if-changed={folder}");
        for path in files(Path::new(folder))? {
            path.hash(&mut hasher);
            std::fs::read(&path)?.hash(&mut hasher);
        }
    }
    Ok(hasher.finish())
}

/// All files below a folder, by their names.
fn files(folder: &Path) -> std::io::Result<Vec<PathBuf>> {
    let mut found = Vec::new();
    for entry in std::fs::read_dir(folder)? {
        let path = entry?.path();
        if path.is_dir() {
            found.extend(files(&path)?);
        } else {
            found.push(path);
        }
    }
    found.sort();
    Ok(found)
}
