//! The report as files.

use super::judge::Judged;
use super::{sheet, table, Error};
use std::path::{Path, PathBuf};

/// Writes the picture and both tables into a folder, which is made if need be, and returns their paths.
///
/// # Errors
/// Those of the file system and of the PNG encoder.
pub fn write(folder: &Path, judged: &Judged) -> Result<[PathBuf; 3], Error> {
    let failed = |path: &Path| {
        let path = path.to_path_buf();
        move |error| Error::File { path, error }
    };
    std::fs::create_dir_all(folder).map_err(failed(folder))?;
    let [picture, numbers, model] = ["cliffs.png", "cliffs.csv", "cliffs_model.csv"].map(|name| folder.join(name));
    sheet::sheet(judged).save_indexed(&picture)?;
    for (path, text) in [(&numbers, table::csv(judged)), (&model, table::model_csv(judged))] {
        std::fs::write(path, text).map_err(failed(path))?;
    }
    Ok([picture, numbers, model])
}
