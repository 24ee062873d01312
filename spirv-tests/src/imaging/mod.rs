//! Pictures and what reports do with them: lenses, reliefs and their rays, supersampling, how far one picture is from
//! another, drawing, lettering, PNG files.

pub mod camera;
pub mod canvas;
pub mod files;
pub mod look;
pub mod measure;
pub mod picture;
pub mod pixel;
pub mod region;
pub mod relief;
pub mod sheet;
pub mod shimmer;
pub mod tally;
pub mod taps;
pub mod vector;
pub mod view;
pub mod waves;

/// Why a report of pictures stopped.
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
    /// What is measured.
    #[error("a measurement: {0}")]
    Measured(String),
    /// A plot.
    #[error("a plot: {0}")]
    Plot(String),
    /// A file of the report.
    #[error("writing {path}: {error}")]
    File {
        /// Which file.
        path: std::path::PathBuf,
        /// What happened.
        error: std::io::Error,
    },
}
