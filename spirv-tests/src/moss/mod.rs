//! The demo of moss and of a sponge: heights h = g(f) of a curve over noise, colored by a map and lit by a sun, near
//! and far, from overhead to a silhouette, judged against rays to all of them. `cargo run --release -p spirv-tests
//! --bin moss` makes it.
//!
//! After Heitz et al. 2014, figures 11 and 12. The surface grows on a thick log that lies across the view: the bottom
//! row of a picture looks straight down on it, the top row past its silhouette. Waves are of about one length, which
//! pixels of the near view resolve, those of the middle view partly, and those of the far view not at all.
//!
//! The truth shoots rays from the eye to a relief of all heights around the log, and from there toward the sun. What
//! filters know is the log displaced by the mean heights over a pixel's footprint, of the module's own
//! `NAME_transferred`, and the statistics of f there. Displaced geometry, its silhouettes and its shadows are the same
//! for every method. Around the log lengths are taken at its radius, which heights exceed by up to 0.5 %.
//!
//! A zoom moves away from pixels that resolve all waves to pixels that resolve none: over the hand-over from displaced
//! geometry to the filter, what changes of a method's error from frame to frame is its shimmer and its jumps.
//!
//! `docs/moss.csv` and `docs/moss_zoom.csv` are a full run.

pub mod displacement;
pub mod judge;
pub mod known;
pub mod log;
pub mod method;
pub mod scene;
pub mod sheet;
pub mod studio;
pub mod table;
pub mod truth;
pub mod zoom;

pub use crate::imaging::Error;
