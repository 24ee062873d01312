//! `include_wgsl!` of the `prefilter` crate.
#![deny(missing_docs)]
