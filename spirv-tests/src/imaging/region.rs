//! How much of what a pixel covers its geometry resolves.

/// How much of a surface a pixel resolves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Region {
    /// The footprint loses less than half of the variance.
    Near,
    /// It loses more.
    Between,
    /// It loses nearly all: the filter alone makes the color.
    Far,
}

impl Region {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Near, Self::Between, Self::Far];

    /// The region of a pixel by the share of the variance that it loses, and the share from which it is far.
    pub fn of(lost: f64, far: f64) -> Self {
        match lost {
            lost if lost < 0.5 => Self::Near,
            lost if lost < far => Self::Between,
            _ => Self::Far,
        }
    }

    /// The name in tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::Near => "near",
            Self::Between => "between",
            Self::Far => "far",
        }
    }
}
