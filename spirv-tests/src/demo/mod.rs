//! The demo: a real terrain and a real gravel, filtered on the device and judged against brute force.

pub mod heights;
pub mod input;
pub mod judge;
pub mod method;
pub mod motion;
pub mod page;
pub mod plane;
pub mod pyramid;
pub mod sheet;
pub mod table;
pub mod truth;

pub use crate::imaging::Error;
