//! Every shelf function on a Vulkan device, judged by its own contract against the f64 reference.
#![deny(missing_docs)]

pub mod demo;
pub mod maps;
pub mod scenes;
