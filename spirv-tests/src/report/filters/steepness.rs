//! Cs by steepness: a color map over the length of the slopes that are seen.

use super::brute::Brute;
use super::case::{Case, Role, Row};
use super::maps::{naive, named};
use super::slope::{seen, DRAWN, SAMPLE, SOURCE};
use crate::report::Error;
use prefilter::reference::steepness;
use prefilter::{Scene, SlopeTaps, SlopeTier};

const MAPS: [&str; 2] = ["terrain", "steps6"];

/// Every map by every tier.
///
/// # Errors
/// Damaged data.
pub fn cases(count: usize) -> Result<Vec<Case>, Error> {
    MAPS.into_iter().take(count).map(case).collect()
}

fn case(name: &str) -> Result<Case, Error> {
    let map = named(name)?;
    let scene = || Scene::new("judged").steepness(map.clone());
    let (plain, reference) = (naive("plain", &map)?, map.reference());
    let of = |tier: SlopeTier| scene().slope_tier(tier).module();
    let rows = vec![
        Row::of(Role::Naive, "naive: the mean slope", of(SlopeTier::Naive)?),
        Row::of(Role::Independent, "all slopes alike", of(SlopeTier::Gaussian)?).straight(),
        Row::of(Role::Tier, "one distribution of Rice", of(SlopeTier::Gaussian)?),
        Row::of(Role::Tier, "three distributions of Rice", scene().slope_taps(SlopeTaps::Three).module()?),
        Row::of(Role::Tier, "ten distributions of Rice", of(SlopeTier::Pair)?),
    ];
    Ok(Case {
        stem: format!("steepness_{name}"),
        map: name.to_owned(),
        rows: Row::with_default(rows, scene().module()?),
        drawn: DRAWN,
        share: 16,
        truth: Box::new(move |pixel| steepness::mean(&reference, &seen(pixel))),
        sources: vec![SOURCE, include_str!("steepness.rs"), include_str!("maps.rs")],
        brute: Brute {
            modules: vec![plain],
            parameters: "mean_slope: vec2f, slope_covariance: vec3f, view: vec3f",
            before: String::new(),
            sample: SAMPLE.to_owned() + "let color = plain_texture(length(slope), 0.0);",
        },
    })
}
