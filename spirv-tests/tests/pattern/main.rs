//! Patterns: steps, pulses and what they repeat, over footprints.

mod pulses;
mod scenes;
mod shares;
