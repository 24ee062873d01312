//! Slopes of transferred heights: the mixture over scales and the nodes that stand for it.

mod device;
mod gap;
mod references;
mod rule;
