//! The report as files.

use super::judge::Judged;
use super::sheet::{self, Shown};
use super::{table, Error};
use std::path::{Path, PathBuf};

/// Writes the picture and the table into a folder, which is made if need be, and returns their paths.
///
/// # Errors
/// Those of the file system and of the PNG encoder.
pub fn write(folder: &Path, judged: &[Judged], shown: &[Shown]) -> Result<[PathBuf; 2], Error> {
    let failed = |path: &Path| {
        let path = path.to_path_buf();
        move |error| Error::File { path, error }
    };
    std::fs::create_dir_all(folder).map_err(failed(folder))?;
    let [picture, numbers] = ["noise.png", "noise.csv"].map(|name| folder.join(name));
    sheet::sheet(shown).save_indexed(&picture)?;
    std::fs::write(&numbers, table::csv(judged)).map_err(failed(&numbers))?;
    Ok([picture, numbers])
}
