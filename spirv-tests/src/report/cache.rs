//! Ground truths that are kept between runs under the hash of all that they are made of.

use sha2::{Digest, Sha256};
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// The hash of all files that truths of several parts are made of: references, transfers, imaging and images.
const SOURCES: &str = env!("SOURCES_OF_TRUTHS");

/// A folder of lists of numbers.
#[derive(Clone, Debug)]
pub struct Cache {
    folder: Option<PathBuf>,
}

impl Cache {
    /// The numbers kept in a folder, which is made when there are some.
    pub fn new(folder: &Path) -> Self {
        Self { folder: Some(folder.to_path_buf()) }
    }

    /// None are kept: all are made.
    pub fn none() -> Self {
        Self { folder: None }
    }

    /// `count` numbers of these inputs: those kept, or else those that are made now, which are kept. `inputs` says all
    /// that the numbers depend on but for references, transfers, imaging and images: the text of the program that makes
    /// them included.
    ///
    /// A file that cannot be read or has another length counts as none; one that cannot be written is left out.
    ///
    /// # Errors
    /// Those of what makes the numbers.
    pub fn numbers<E>(
        &self,
        inputs: &[&str],
        count: usize,
        make: impl FnOnce() -> Result<Vec<f32>, E>,
    ) -> Result<Vec<f32>, E> {
        let Some(folder) = &self.folder else { return make() };
        let path = folder.join(name(&[&[SOURCES], inputs].concat()));
        if let Some(kept) = std::fs::read(&path).ok().filter(|kept| kept.len() == 4 * count) {
            return Ok(bytemuck::pod_collect_to_vec(&kept));
        }
        let made = make()?;
        // Whatever happens to the file, the numbers are there.
        let _ = std::fs::create_dir_all(folder);
        let partial = path.with_extension("partial");
        let written = std::fs::write(&partial, bytemuck::cast_slice(&made));
        let _ = written.and_then(|()| std::fs::rename(&partial, &path));
        Ok(made)
    }
}

/// A file name for inputs: each with its length in front, so that no two lists make one text.
pub fn name(inputs: &[&str]) -> String {
    let mut hash = Sha256::new();
    for input in inputs {
        hash.update((input.len() as u64).to_le_bytes());
        hash.update(input.as_bytes());
    }
    hash.finalize().iter().take(16).fold(String::new(), |mut name, byte| {
        let _ = write!(name, "{byte:02x}");
        name
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::convert::Infallible;

    #[test]
    fn numbers_are_made_once_for_each_inputs() {
        let folder = std::env::temp_dir().join(format!("prefilter-cache-{}", std::process::id()));
        let cache = Cache::new(&folder);
        let mut made = 0;
        let mut numbers = |inputs: &[&str], count: usize| {
            let make = || {
                made += 1;
                Ok::<_, Infallible>(vec![made as f32; count])
            };
            let Ok(numbers) = cache.numbers(inputs, count, make);
            numbers
        };
        assert_eq!(numbers(&["a", "b"], 3), [1.0; 3]);
        assert_eq!(numbers(&["a", "b"], 3), [1.0; 3]);
        assert_eq!(numbers(&["ab", ""], 3), [2.0; 3]);
        assert_eq!(numbers(&["a", "b"], 2), [3.0; 2]);
        assert_eq!(numbers(&["ab", ""], 3), [2.0; 3]);
        assert!(std::fs::remove_dir_all(&folder).is_ok());
    }
}
