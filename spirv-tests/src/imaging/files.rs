//! Reports as files.

use super::canvas::Canvas;
use super::Error;
use std::path::{Path, PathBuf};

/// Writes a picture and texts under their names into a folder, which is made if need be, and returns their paths.
///
/// # Errors
/// Those of the file system and of the PNG encoder.
pub fn write(folder: &Path, picture: (&str, &Canvas), texts: &[(&str, String)]) -> Result<Vec<PathBuf>, Error> {
    let failed = |path: &Path| {
        let path = path.to_path_buf();
        move |error| Error::File { path, error }
    };
    std::fs::create_dir_all(folder).map_err(failed(folder))?;
    let mut written = vec![folder.join(picture.0)];
    picture.1.save_indexed(&written[0])?;
    for (name, text) in texts {
        let path = folder.join(name);
        std::fs::write(&path, text).map_err(failed(&path))?;
        written.push(path);
    }
    Ok(written)
}

/// The paths as a line of text.
pub fn listed(paths: &[PathBuf]) -> String {
    paths.iter().map(|path| path.display().to_string()).collect::<Vec<_>>().join(", ")
}
