//! Cs: a color map over one component of the slopes that are seen.

use super::brute::Brute;
use super::case::{Case, Role, Row};
use super::maps::{naive, named, spread};
use super::pixel::{Drawn, Pixel};
use crate::report::Error;
use prefilter::reference::slope;
use prefilter::reference::slopes::Visible;
use prefilter::{Kernel, Scene, SlopeTier, Tier};

const MAPS: [&str; 2] = ["terrain", "steps6"];

/// Every map by every tier.
///
/// # Errors
/// Damaged data.
pub fn cases(count: usize) -> Result<Vec<Case>, Error> {
    MAPS.into_iter().rev().take(count).map(case).collect()
}

/// What the view sees.
pub fn seen(pixel: &Pixel) -> Visible {
    Visible { view: pixel.view, covariance: pixel.covariance, mean: pixel.mean_slope }
}

/// The statements that name a random slope and its area in the picture.
pub const SAMPLE: &str = "let slope = brute_slope(point, mean_slope, slope_covariance);
        let weight = max(view.z - dot(view.xy, slope), 1e-6);";

/// What pixels of slopes are drawn from: surfaces up to 3 degrees from their horizon.
pub const DRAWN: Drawn =
    Drawn { mean: [0.0, 1.0], deviation: [0.01, 0.5], slope: 0.4, slope_deviation: [0.05, 0.5], rise: 0.05 };

/// The text of what is seen of slopes.
pub const SOURCE: &str = include_str!("slope.rs");

fn case(name: &str) -> Result<Case, Error> {
    let map = spread(&named(name)?, -0.8, 0.8)?;
    let scene = || Scene::new("judged").slope(map.clone());
    let (plain, reference) = (naive("plain", &map)?, map.reference());
    let (fast, exact) = (Tier::ClosedForm(Kernel::Fast), Tier::ClosedForm(Kernel::Exact));
    let of = |role: Role, slopes: SlopeTier, tier: Tier| -> Result<Row, prefilter::Error> {
        let module = scene().slope_tier(slopes).tier(tier).module()?;
        Ok(Row::of(role, format!("{slopes} over {tier}"), module))
    };
    let mut paper = of(Role::Paper, SlopeTier::Gaussian, exact)?;
    paper.label = "the paper's single Gaussian, over the exact closed form".to_owned();
    let mut rows = vec![
        Row::of(Role::Naive, "naive: the mean slope", scene().slope_tier(SlopeTier::Naive).module()?),
        paper,
        of(Role::Independent, SlopeTier::Unweighted, fast)?,
    ];
    for tier in [Tier::Table, fast] {
        rows.push(of(Role::Tier, SlopeTier::Gaussian, tier)?);
    }
    for tier in [Tier::Table, fast, exact] {
        rows.push(of(Role::Tier, SlopeTier::Pair, tier)?);
    }
    Ok(Case {
        stem: format!("slope_{name}"),
        map: name.to_owned(),
        rows: Row::with_default(rows, scene().module()?),
        drawn: DRAWN,
        share: 8,
        truth: Box::new(move |pixel| slope::mean(&reference, &seen(pixel), pixel.direction)),
        sources: vec![SOURCE, include_str!("maps.rs")],
        brute: Brute {
            modules: vec![plain],
            parameters: "mean_slope: vec2f, slope_covariance: vec3f, view: vec3f, direction: vec2f",
            before: String::new(),
            sample: SAMPLE.to_owned() + "let color = plain_texture(dot(direction, slope), 0.0);",
        },
    })
}
