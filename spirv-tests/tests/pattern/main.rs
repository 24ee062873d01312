//! Patterns: steps, pulses and what they repeat, over footprints.

mod limits;
mod pulses;
mod scenes;
mod shares;
