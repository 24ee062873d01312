//! Height transfer functions: curves, their moments, and the surfaces that they make.

mod curve;
