//! A hash of the files that ground truths are made of, whichever they are: one that changes makes all of them anew.

use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::{Path, PathBuf};

/// The references and what makes them of maps, what samples pictures, maps, random numbers, and images.
const PLACES: [&str; 6] =
    ["../src/reference", "../src/transfer", "src/imaging", "src/maps.rs", "src/random.rs", "../examples/data"];

/// The hash; every place is watched.
pub fn hash() -> std::io::Result<u64> {
    let mut hasher = DefaultHasher::new();
    for place in PLACES {
        println!("cargo::rerun-if-changed={place}");
        for path in files(Path::new(place))? {
            path.hash(&mut hasher);
            std::fs::read(&path)?.hash(&mut hasher);
        }
    }
    Ok(hasher.finish())
}

/// A file, or all below a folder by their names.
fn files(place: &Path) -> std::io::Result<Vec<PathBuf>> {
    if place.is_file() {
        return Ok(vec![place.to_path_buf()]);
    }
    let mut found = Vec::new();
    for entry in std::fs::read_dir(place)? {
        found.extend(files(&entry?.path())?);
    }
    found.sort();
    Ok(found)
}
