//! The demo: a real terrain and a real gravel, filtered on the device and judged against brute force.

pub mod heights;
pub mod measure;
pub mod picture;
pub mod plane;
pub mod truth;
