//! The demo of a rough surface: heights colored by a map, seen and lit from many directions, near and far, judged
//! against rays through all of them.

pub mod judge;
pub mod known;
pub mod method;
pub mod page;
pub mod relief;
pub mod scene;
pub mod sheet;
pub mod surface;
pub mod table;
pub mod tally;
pub mod truth;
pub mod view;

pub use crate::imaging::Error;
