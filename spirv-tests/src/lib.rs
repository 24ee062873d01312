//! Every shelf function on a Vulkan device, judged by its own contract against the f64 reference.
#![deny(missing_docs)]

pub mod any;
pub mod cliffs;
pub mod contract;
pub mod demo;
pub mod environments;
pub mod exports;
pub mod fill;
pub mod gap;
pub mod harness;
pub mod horizon;
pub mod imaging;
pub mod judged;
pub mod kernel;
mod made;
pub mod maps;
pub mod moss;
pub mod noise;
pub mod program;
pub mod random;
pub mod report;
pub mod rough;
pub mod rows;
pub mod scenes;
pub mod signature;
pub mod snake;
