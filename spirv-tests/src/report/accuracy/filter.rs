//! What random scenes filter, and how many of each there are.

/// What a scene filters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Filter {
    /// C0 over normal values.
    Texture,
    /// C0 over values of a Beta distribution.
    Bounded,
    /// Ch.
    Height,
    /// Ch by percentiles, of which there is one tier.
    Percentile,
    /// Cs by a component.
    Slope,
    /// Cs by length.
    Steepness,
    /// Cs by the whole slope.
    SlopeMap,
    /// Light from all around.
    Irradiance,
    /// Layers of values, heights and lengths of slopes.
    Combination,
    /// Ch of transferred heights, of which there is one tier.
    Raised,
    /// Cs of transferred heights.
    Steepened,
}

impl Filter {
    /// All of them.
    pub const ALL: [Self; 11] = [
        Self::Texture,
        Self::Bounded,
        Self::Height,
        Self::Percentile,
        Self::Slope,
        Self::Steepness,
        Self::SlopeMap,
        Self::Irradiance,
        Self::Combination,
        Self::Raised,
        Self::Steepened,
    ];

    /// How many of forty scenes filter that: the fewer the longer its truth takes.
    fn share(self) -> usize {
        match self {
            Self::Texture => 12,
            Self::Height => 9,
            Self::Slope => 5,
            Self::Steepness | Self::Irradiance => 3,
            Self::Bounded | Self::Combination => 2,
            Self::Percentile | Self::SlopeMap | Self::Raised | Self::Steepened => 1,
        }
    }

    /// That of a scene by its number.
    pub fn of(number: u32) -> Self {
        let all = Self::ALL.into_iter().flat_map(|filter| std::iter::repeat_n(filter, filter.share()));
        // Seven and forty have no common factor: a few scenes in a row filter different things.
        let place = (7 * (number as usize % 40)) % 40;
        all.into_iter().nth(place).unwrap_or(Self::Texture)
    }

    /// In words.
    pub fn name(self) -> &'static str {
        match self {
            Self::Texture => "texture",
            Self::Bounded => "texture, Beta distribution",
            Self::Height => "height",
            Self::Percentile => "height percentile",
            Self::Slope => "slope",
            Self::Steepness => "steepness",
            Self::SlopeMap => "slope map",
            Self::Irradiance => "irradiance",
            Self::Combination => "combination",
            Self::Raised => "transferred height",
            Self::Steepened => "transferred slope",
        }
    }
}
