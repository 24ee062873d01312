//! Axes of tables: the value at each node. The way back, from a value to a coordinate, is `wgsl/math/grid.wgsl`.

/// One axis of a table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axis {
    /// The value at the low end.
    pub low: f64,
    /// The value at the high end.
    pub high: f64,
    /// Nodes.
    pub count: usize,
    /// How the nodes are spread.
    pub spacing: Spacing,
}

/// How the nodes of an axis are spread between its ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Spacing {
    /// Evenly, a node on each end.
    Linear,
    /// Evenly in the cube root of the value, a node on each end; the low end is 0.
    CubeRoot,
    /// Evenly at the centers of `count` cells, as a texture's texels lie in [0, 1].
    Centers,
}

impl Axis {
    /// The value at a node number; fractions lie between nodes as bilinear filtering sees them.
    pub fn value(&self, number: f64) -> f64 {
        let span = self.high - self.low;
        let part = number / (self.count - 1).max(1) as f64;
        match self.spacing {
            Spacing::Linear => self.low + span * part,
            Spacing::CubeRoot => self.low + span * part * part * part,
            Spacing::Centers => self.low + span * (number + 0.5) / self.count as f64,
        }
    }

    /// The node number of a value: the inverse of [`Self::value`], clamped to the nodes as a clamping sampler does.
    pub fn number(&self, value: f64) -> f64 {
        let part = (value - self.low) / (self.high - self.low);
        let last = (self.count - 1) as f64;
        let number = match self.spacing {
            Spacing::Linear => part * last,
            Spacing::CubeRoot => part.max(0.0).cbrt() * last,
            Spacing::Centers => part * self.count as f64 - 0.5,
        };
        number.clamp(0.0, last)
    }
}
