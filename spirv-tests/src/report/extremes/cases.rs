//! The hard cases: one closed list, which the report shows and the tests judge.

/// Inputs of a kind at which filters go wrong.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Case {
    /// Views and lights just above the horizon.
    Grazing,
    /// Views and lights below it.
    BelowHorizon,
    /// Deviations that go to 0.
    NoDeviation,
    /// Deviations far beyond every range.
    HugeDeviation,
    /// Slopes that nearly lie on a line, or do.
    NearSingular,
    /// Deviations next to nothing at the hard edges of a map.
    HardEdges,
    /// Footprints of a million pixels.
    WideFootprints,
    /// Subnormal numbers.
    Denormals,
    /// Coordinates far from the origin.
    FarFromOrigin,
    /// One texel between two colors, or of another value.
    Stripes,
    /// Tables and pyramids of 16 bits.
    HalfTables,
    /// The light where the viewer is.
    OneDirection,
    /// Variances below 0 and correlations beyond 1, as differences of sums round.
    Rounded,
    /// Images of one texel.
    OneTexel,
    /// The largest numbers, infinite ones, and none.
    NoNumbers,
}

impl Case {
    /// All of them, in the report's order.
    pub const ALL: [Self; 15] = [
        Self::Grazing,
        Self::BelowHorizon,
        Self::NoDeviation,
        Self::HugeDeviation,
        Self::NearSingular,
        Self::HardEdges,
        Self::WideFootprints,
        Self::Denormals,
        Self::FarFromOrigin,
        Self::Stripes,
        Self::HalfTables,
        Self::OneDirection,
        Self::Rounded,
        Self::OneTexel,
        Self::NoNumbers,
    ];

    /// Its name in tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::Grazing => "grazing",
            Self::BelowHorizon => "below the horizon",
            Self::NoDeviation => "no deviation",
            Self::HugeDeviation => "huge deviation",
            Self::NearSingular => "near-singular covariance",
            Self::HardEdges => "hard edges",
            Self::WideFootprints => "wide footprints",
            Self::Denormals => "denormals",
            Self::FarFromOrigin => "far from the origin",
            Self::Stripes => "one-texel stripes",
            Self::HalfTables => "tables of halves",
            Self::OneDirection => "light at the viewer",
            Self::Rounded => "rounded moments",
            Self::OneTexel => "images of one texel",
            Self::NoNumbers => "no numbers",
        }
    }

    /// What is hard about it, and what the inputs are.
    pub fn hard(self) -> &'static str {
        match self {
            Self::Grazing => {
                "Λ grows without bound and most slopes face away: views and lights 1e-1 to 1e-7 above the horizon; \
                 footprints a thousand to a million times as long as wide"
            }
            Self::BelowHorizon => "nothing is seen or lit: views, lights and both 1e-7 to 0.9 below the horizon",
            Self::NoDeviation => "quotients of nothing: deviations of 0, of 1e-30 to 1e-4 of the usual ones",
            Self::HugeDeviation => "squares and exponentials overflow: deviations 10 to 1e18 times the usual ones",
            Self::NearSingular => {
                "determinants cancel: correlations of 1 - 1e-2 to 1 - 1e-7 and of 1, slopes along one axis"
            }
            Self::HardEdges => "a step within a thousandth: deviations of 1e-2 to 1e-6 of the map about its edges",
            Self::WideFootprints => "phases and reads lose their digits: derivatives of a million periods a pixel",
            Self::Denormals => "devices flush them to 0, and their reciprocals overflow: inputs of 1e-38 to 1e-45",
            Self::FarFromOrigin => {
                "differences of large numbers: maps about 60000, where f32 has steps of 0.004; positions of 1e4 to 1e6"
            }
            Self::Stripes => "a 256th of the map or one texel of an image has another color",
            Self::HalfTables => "eleven bits: tables of colors, moments and nodes that hold halves",
            Self::OneDirection => "angles between directions cancel: views that are lights, the normal among them",
            Self::Rounded => {
                "roots of what is below 0: variances of -1e-9, correlations of 1 + 1e-5, deviations of -1e-9; they \
                 count as the nearest that there are"
            }
            Self::OneTexel => "nothing to interpolate and no next level: images and maps of slopes of one texel",
            Self::NoNumbers => "whatever a division by 0 leaves: one input of 3.4e38, infinite or NaN, of both signs",
        }
    }
}
