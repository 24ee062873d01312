//! Noise on lattices.

/// The noise of one octave. All have the mean 0 and are smooth: quintic fades, or kernels of degree 8.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Basis {
    /// Perlin's: lines at the points of a square lattice.
    #[default]
    Perlin,
    /// Values at the points of a square lattice.
    Value,
    /// Lines at the points of a lattice of triangles.
    Simplex,
}
