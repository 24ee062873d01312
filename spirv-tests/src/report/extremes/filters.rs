//! Every filter, with its scenes.

use prefilter::{
    ColorMap, HeightTier, HeightTransfer, Irradiance, IrradianceTier, Kernel, Ranges, Scene, SlopeDomain, SlopeMap,
    SlopeTier, Tier,
};

use super::cases::Case;
use crate::environments::GRACE;
use crate::maps::named;

/// What goes wrong in a scene that cannot be made.
type Fault = Box<dyn std::error::Error + Send + Sync>;

/// A filter of statistics.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Filter {
    /// Colors by value.
    Texture,
    /// Colors by height.
    Height,
    /// Shares that are lit.
    Visibility,
    /// Colors by the share of lower heights.
    HeightPercentile,
    /// Colors by a component of the slope.
    Slope,
    /// Colors by the whole slope.
    SlopeMap,
    /// Colors by the length of the slope.
    Steepness,
    /// Light by slope.
    Irradiance,
    /// Layers together.
    Combination,
    /// Colors by a height that a curve makes.
    HeightTransfer,
}

/// Which map a filter has.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Map {
    /// A gradient with few edges.
    Usual,
    /// Hard edges alone.
    Edges,
    /// One texel of 256, or a slope's like, of another color.
    Stripe,
    /// A gradient far from 0.
    Far,
    /// The usual one from a table of halves.
    Halves,
}

impl Filter {
    /// All of them, in the report's order.
    pub const ALL: [Self; 10] = [
        Self::Texture,
        Self::Height,
        Self::Visibility,
        Self::HeightPercentile,
        Self::Slope,
        Self::SlopeMap,
        Self::Steepness,
        Self::Irradiance,
        Self::Combination,
        Self::HeightTransfer,
    ];

    /// Its name in tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::Texture => "texture",
            Self::Height => "height",
            Self::Visibility => "visibility",
            Self::HeightPercentile => "height percentile",
            Self::Slope => "slope",
            Self::SlopeMap => "slope map",
            Self::Steepness => "steepness",
            Self::Irradiance => "irradiance",
            Self::Combination => "combination",
            Self::HeightTransfer => "height transfer",
        }
    }

    /// The map that a case asks of the filter, and none where the case has no meaning for it.
    ///
    /// Values have no view and no slopes. Visibility has no colors, irradiance no edges. A filter takes deviations, not
    /// pixels: wide footprints are a matter of drivers. Slopes and percentiles are ratios, which have no origin; a
    /// stripe of a layer is that of its filter. Percentiles, visibility and irradiance read no halves, maps of the
    /// whole slope or its length and transferred heights always do.
    pub fn map(self, case: Case) -> Option<Map> {
        use Filter::{
            Combination, Height, HeightPercentile, HeightTransfer, Irradiance, Slope, SlopeMap, Steepness, Texture,
            Visibility,
        };
        match (case, self) {
            (Case::Grazing | Case::BelowHorizon | Case::NearSingular | Case::OneDirection, Texture) => None,
            (Case::Grazing | Case::BelowHorizon | Case::NearSingular | Case::OneDirection, _) => Some(Map::Usual),
            (Case::NoDeviation | Case::HugeDeviation | Case::Denormals, _) => Some(Map::Usual),
            (Case::Rounded | Case::NoNumbers, _) => Some(Map::Usual),
            (Case::OneTexel, _) => None,
            (Case::HardEdges, Visibility | Irradiance) => None,
            (Case::HardEdges, _) => Some(Map::Edges),
            (Case::WideFootprints, _) => None,
            (Case::FarFromOrigin, Texture | Height) => Some(Map::Far),
            (Case::FarFromOrigin, _) => None,
            (Case::Stripes, Visibility | Irradiance | Combination | HeightTransfer) => None,
            (Case::Stripes, _) => Some(Map::Stripe),
            (Case::HalfTables, HeightPercentile | Visibility | Irradiance) => None,
            (Case::HalfTables, Texture | Height | Slope | Combination) => Some(Map::Halves),
            (Case::HalfTables, SlopeMap | Steepness | HeightTransfer) => Some(Map::Usual),
        }
    }

    /// The filter's scene with a map; layers of combinations are made of those.
    ///
    /// # Errors
    /// Those of maps.
    pub fn scene(self, map: Map) -> Result<Scene, Fault> {
        let exact = Tier::ClosedForm(Kernel::Exact);
        let tier = if map == Map::Halves { Tier::Table } else { exact };
        let heights = if map == Map::Halves { HeightTier::Skewed } else { HeightTier::ClosedForm };
        let far = |scene: Scene| match map {
            Map::Far => scene.ranges(Ranges { mean: (FAR - 0.25, FAR + 1.25), deviation: 0.5 }),
            Map::Usual | Map::Edges | Map::Stripe | Map::Halves => scene,
        };
        Ok(match self {
            Self::Texture => far(Scene::new("hard").texture(values(map)?).tier(tier)),
            Self::Height | Self::Visibility => far(Scene::new("high").height(values(map)?).height_tier(heights)),
            Self::HeightPercentile => Scene::new("share").height_percentile(values(map)?),
            Self::Slope => Scene::new("dune").slope(slopes(map)?).slope_tier(SlopeTier::Pair).tier(tier),
            Self::SlopeMap => Scene::new("snow").slope_map(discs(map)?).slope_tier(SlopeTier::Pair),
            Self::Steepness => Scene::new("cliff").steepness(lengths(map)?).slope_tier(SlopeTier::Pair),
            Self::Irradiance => {
                let light = Irradiance::from_harmonics(GRACE)?;
                Scene::new("sky").irradiance(light).irradiance_tier(IrradianceTier::FourGaussians)
            }
            Self::Combination => {
                let [value, steep, high] = LAYERS;
                let (value, steep, high) = (value.scene(map)?, steep.scene(map)?, high.scene(map)?);
                Scene::new("hills").combination(&value * &steep * (1.0 - &high))
            }
            Self::HeightTransfer => Scene::new("moss").height(values(map)?).transfer(curve()?),
        })
    }
}

/// The layers of the combination: the first times the second times what the third leaves of 1.
pub const LAYERS: [Filter; 3] = [Filter::Texture, Filter::Steepness, Filter::Height];

/// Where maps far from 0 begin.
const FAR: f32 = 60_000.0;

/// The curve of transferred heights.
///
/// # Errors
/// None that is known.
pub fn curve() -> Result<HeightTransfer, prefilter::Error> {
    HeightTransfer::smoothstep(0.0, 1.2)
}

/// A map over values and heights.
fn values(map: Map) -> Result<ColorMap, Fault> {
    match map {
        Map::Usual | Map::Halves => named("terrain"),
        Map::Edges => named("steps6"),
        Map::Stripe => named("stripe1_hard"),
        Map::Far => {
            let usual = named("terrain")?;
            let stops = usual.knots().iter().map(|knot| (FAR + knot.position, knot.right));
            Ok(ColorMap::gradient(stops.collect::<Vec<_>>())?)
        }
    }
}

const SAND: [f32; 3] = [0.31, 0.22, 0.12];
const GRASS: [f32; 3] = [0.78, 0.63, 0.41];
const SNOW: [f32; 3] = [0.93, 0.84, 0.68];

/// A map over a component of the slope.
fn slopes(map: Map) -> Result<ColorMap, prefilter::Error> {
    match map {
        Map::Usual | Map::Halves | Map::Far => ColorMap::gradient([(-0.6, SAND), (0.1, GRASS), (0.5, SNOW)]),
        Map::Edges => ColorMap::bands(SAND, [(-0.3, GRASS), (0.1, SNOW), (0.4, SAND)]),
        Map::Stripe => ColorMap::bands(SAND, [(0.1, SNOW), (0.1 + 1.0 / 256.0, SAND)]),
    }
}

/// A map over the length of the slope.
fn lengths(map: Map) -> Result<ColorMap, prefilter::Error> {
    match map {
        Map::Usual | Map::Halves | Map::Far => ColorMap::gradient([(0.25, SAND), (0.55, GRASS), (1.2, SNOW)]),
        Map::Edges => ColorMap::bands(SAND, [(0.25, GRASS), (0.55, SNOW), (0.9, SAND)]),
        Map::Stripe => ColorMap::bands(SAND, [(0.5, SNOW), (0.5 + 1.0 / 256.0, SAND)]),
    }
}

/// The radius of the edge of a map over the whole slope.
pub const DISC: f32 = 0.4;

/// A map over the whole slope: a soft disc, a hard one, and one node of another color.
fn discs(map: Map) -> Result<SlopeMap, prefilter::Error> {
    let domain = SlopeDomain::Within(0.8);
    SlopeMap::from_function(25, domain, |[x, y]| {
        let length = x.hypot(y);
        let covered = match map {
            Map::Usual | Map::Halves | Map::Far => (1.5 - 2.0 * length).clamp(0.0, 1.0),
            Map::Edges => f32::from(length < DISC),
            Map::Stripe => f32::from((length - DISC).abs() < 0.034),
        };
        [0, 1, 2].map(|channel| SAND[channel] + covered * (SNOW[channel] - SAND[channel]))
    })
}
