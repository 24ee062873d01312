//! The one entry for people and for CI.
#![deny(missing_docs)]
fn main() {}
