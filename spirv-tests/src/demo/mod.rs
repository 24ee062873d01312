//! The demo: a real terrain and a real gravel, filtered on the device and judged against brute force.

pub mod canvas;
pub mod heights;
pub mod input;
pub mod judge;
pub mod measure;
pub mod method;
pub mod motion;
pub mod page;
pub mod picture;
pub mod plane;
pub mod pyramid;
pub mod sheet;
pub mod table;
pub mod truth;

/// Why the demo stopped.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// A scene or the device.
    #[error(transparent)]
    Prefilter(#[from] prefilter::Error),
    /// A picture.
    #[error("a picture: {0}")]
    Image(#[from] image::ImageError),
    /// The contact sheet.
    #[error("the contact sheet: {0}")]
    Sheet(#[from] png::EncodingError),
    /// The color maps' file.
    #[error("the color maps: {0}")]
    Map(String),
    /// A file of the report.
    #[error("writing {path}: {error}")]
    File {
        /// Which file.
        path: std::path::PathBuf,
        /// What happened.
        error: std::io::Error,
    },
}
