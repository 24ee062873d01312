//! Ch: a color map over the heights that are seen and lit.

use super::brute::Brute;
use super::case::{Case, Role, Row};
use super::maps::{naive, named};
use super::pixel::{Drawn, Pixel};
use crate::report::Error;
use prefilter::reference::height;
use prefilter::reference::smith::Along;
use prefilter::{HeightTier, Kernel, Scene, Tier};

const MAPS: [&str; 2] = ["steps6", "terrain"];

/// Every map by every tier.
///
/// # Errors
/// Damaged data.
pub fn cases(count: usize) -> Result<Vec<Case>, Error> {
    MAPS.into_iter().take(count).map(case).collect()
}

/// The sum of Smith's Λ of view and light over a level surface.
pub fn hiding(pixel: &Pixel) -> f64 {
    let of = |direction: [f64; 3]| Along::new(direction, pixel.covariance, [0.0; 2]).lambda();
    of(pixel.view) + of(pixel.light)
}

/// The statements that name Λ of view and light.
pub const LAMBDA: &str = "let seen = brute_lambda(view, slope_covariance);
    let lit = brute_lambda(light, slope_covariance);";

/// The statements that name a visible height in deviations, its `rank`, and what it counts: P^(1 + Λ) of the view is
/// even, and P^Λ of the light reaches it.
pub fn visible(random: &str) -> String {
    format!(
        "let loss = -log({random}) / (1.0 + seen);
        let rank = exp(-loss);
        let rest = select(1.0 - rank, loss * (1.0 - 0.5 * loss), loss < 1e-3);
        let height = brute_quantile(rank, rest);
        let weight = max(exp(-lit * loss), 1e-30);"
    )
}

/// What pixels of heights are drawn from: a level surface, seen from up to 3 degrees above it.
pub const DRAWN: Drawn =
    Drawn { mean: [-0.25, 1.25], deviation: [5e-3, 0.5], slope: 0.0, slope_deviation: [0.1, 1.0], rise: 0.05 };

fn case(name: &str) -> Result<Case, Error> {
    let map = named(name)?;
    let scene = || Scene::new("judged").height(map.clone());
    let (plain, reference) = (naive("plain", &map)?, map.reference());
    let fast = Tier::ClosedForm(Kernel::Fast);
    let alone = Scene::new("judged").texture(map.clone()).module()?;
    let paper = scene().height_tier(HeightTier::Paper).tier(Tier::Paper).module()?;
    let mut rows = vec![
        Row::of(Role::Naive, "naive: the mean height", naive("judged", &map)?),
        Row::of(Role::Paper, "the paper's fits over its table", paper),
        Row::of(Role::Independent, "all heights alike", alone),
    ];
    for tier in [Tier::Table, fast] {
        let module = scene().height_tier(HeightTier::Gaussian).tier(tier).module()?;
        rows.push(Row::of(Role::Tier, format!("{} over {tier}", HeightTier::Gaussian), module));
    }
    let bands = map.edges().map(|_| HeightTier::Exact);
    for tier in [HeightTier::Skewed, HeightTier::ClosedFormFast, HeightTier::ClosedForm].into_iter().chain(bands) {
        rows.push(Row::of(Role::Tier, tier, scene().height_tier(tier).module()?));
    }
    let color = "let color = plain_texture(mean + deviation * height, 0.0);";
    Ok(Case {
        stem: format!("height_{name}"),
        map: name.to_owned(),
        rows: Row::with_default(rows, scene().module()?),
        drawn: DRAWN,
        share: 2,
        truth: Box::new(move |pixel| height::mean(&reference, pixel.mean, pixel.deviation, hiding(pixel))),
        sources: vec![include_str!("height.rs"), include_str!("maps.rs")],
        brute: Brute {
            modules: vec![plain],
            parameters: "mean: f32, deviation: f32, slope_covariance: vec3f, view: vec3f, light: vec3f",
            before: LAMBDA.to_owned(),
            sample: visible("point.x") + color,
        },
    })
}
