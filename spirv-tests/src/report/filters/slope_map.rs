//! Cs of a map of the whole slope.

use super::brute::Brute;
use super::case::{Case, Role, Row};
use super::slope::{seen, DRAWN, SAMPLE, SOURCE};
use crate::report::Error;
use prefilter::{Scene, SlopeDomain, SlopeMap, SlopeTaps, SlopeTier};

/// Snow to one side of a slope and below another, between two components each in 32nds: where maps of 32 cells from −1
/// to 1 have nodes, so that they are bilinear as the function is.
struct Snow {
    name: &'static str,
    along: [f32; 2],
    across: [f32; 2],
}

const MAPS: [Snow; 2] = [
    Snow { name: "snow", along: [-13.0, 7.0], across: [-5.0, 15.0] },
    Snow { name: "hard snow", along: [-3.0, -1.0], across: [5.0, 7.0] },
];

/// Colors of rock and of snow.
const ROCK: [f32; 3] = [0.31, 0.28, 0.25];
const SNOW: [f32; 3] = [0.91, 0.93, 0.97];

impl Snow {
    fn map(&self) -> Result<SlopeMap, prefilter::Error> {
        let ramp = |[low, high]: [f32; 2], at: f32| ((32.0 * at - low) / (high - low)).clamp(0.0, 1.0);
        SlopeMap::from_function(32, SlopeDomain::Within(1.0), |[x, y]| {
            let covered = ramp(self.along, x) * (1.0 - ramp(self.across, y));
            [0, 1, 2].map(|channel| ROCK[channel] + covered * (SNOW[channel] - ROCK[channel]))
        })
    }

    /// The same for a shader.
    fn color(&self) -> String {
        let ramp =
            |[low, high]: [f32; 2], at: &str| format!("clamp((32.0 * {at} - {low:?}) / {:?}, 0.0, 1.0)", high - low);
        let (along, across) = (ramp(self.along, "slope.x"), ramp(self.across, "slope.y"));
        let vector = |[red, green, blue]: [f32; 3]| format!("vec3f({red:?}, {green:?}, {blue:?})");
        format!("let color = mix({}, {}, {along} * (1.0 - {across}));", vector(ROCK), vector(SNOW))
    }
}

/// Every map by every tier.
///
/// # Errors
/// None: the maps are fixed.
pub fn cases(count: usize) -> Result<Vec<Case>, Error> {
    MAPS.iter().take(count).map(case).collect()
}

fn case(snow: &Snow) -> Result<Case, Error> {
    let map = snow.map()?;
    let scene = || Scene::new("judged").slope_map(map.clone());
    let reference = map.reference();
    let of = |role: Role, tier: SlopeTier, taps: SlopeTaps| -> Result<Row, prefilter::Error> {
        let module = scene().slope_tier(tier).slope_taps(taps).module()?;
        Ok(Row::of(role, format!("{tier} by {taps}"), module))
    };
    let rows = vec![
        Row::of(Role::Naive, "naive: the mean slope", scene().slope_tier(SlopeTier::Naive).module()?),
        of(Role::Independent, SlopeTier::Unweighted, SlopeTaps::Three)?,
        of(Role::Tier, SlopeTier::Gaussian, SlopeTaps::One)?,
        of(Role::Tier, SlopeTier::Gaussian, SlopeTaps::Three)?,
        of(Role::Tier, SlopeTier::Pair, SlopeTaps::Five)?,
        of(Role::Tier, SlopeTier::Pair, SlopeTaps::Seven)?,
        of(Role::Tier, SlopeTier::Pair, SlopeTaps::Eleven)?,
    ];
    Ok(Case {
        stem: format!("slope_map_{}", snow.name.replace(' ', "_")),
        map: snow.name.to_owned(),
        rows: Row::with_default(rows, scene().module()?),
        drawn: DRAWN,
        share: 32,
        truth: Box::new(move |pixel| reference.mean_visible(&seen(pixel))),
        sources: vec![SOURCE, include_str!("slope_map.rs"), include_str!("maps.rs")],
        brute: Brute {
            modules: Vec::new(),
            parameters: "mean_slope: vec2f, slope_covariance: vec3f, view: vec3f",
            before: String::new(),
            sample: SAMPLE.to_owned() + &snow.color(),
        },
    })
}
