//! Ch over percentiles: a color map over the share of the surface that lies below what is seen and lit.

use super::brute::Brute;
use super::case::{Case, Role, Row};
use super::height::{hiding, visible, DRAWN, LAMBDA};
use super::maps::{naive, named};
use crate::report::Error;
use prefilter::reference::percentile;
use prefilter::{Colors, Scene};

const MAPS: [&str; 2] = ["terrain", "steps6"];

/// Every map.
///
/// # Errors
/// Damaged data.
pub fn cases(count: usize) -> Result<Vec<Case>, Error> {
    MAPS.into_iter().take(count).map(case).collect()
}

/// Half of a surface lies below its mean, whatever the pixel.
const NAIVE: &str = "fn unfiltered(view: vec3f) -> vec3f {
    return plain_texture(0.5 + 1e-9 * view.x, 0.0);
}";

fn case(name: &str) -> Result<Case, Error> {
    let map = named(name)?;
    let scene = || Scene::new("judged").height_percentile(map.clone());
    let (plain, reference) = (naive("plain", &map)?, map.reference());
    let rows = vec![
        Row::text(Role::Naive, "naive: the percentile ½", vec![plain.clone()], NAIVE, "unfiltered"),
        Row::of(Role::Independent, "all heights alike", scene().module()?).straight(),
        Row::of(Role::Tier, "the closed form", scene().module()?),
        Row::of(Role::Tier, "the closed form over a texture of stops", scene().colors(Colors::Dynamic).module()?),
    ];
    Ok(Case {
        stem: format!("percentile_{name}"),
        map: name.to_owned(),
        rows: Row::with_default(rows, scene().module()?),
        drawn: DRAWN,
        share: 8,
        truth: Box::new(move |pixel| percentile::mean_by_ranks(&reference, hiding(pixel))),
        sources: vec![include_str!("height.rs"), include_str!("percentile.rs"), include_str!("maps.rs")],
        brute: Brute {
            modules: vec![plain],
            parameters: "slope_covariance: vec3f, view: vec3f, light: vec3f",
            before: LAMBDA.to_owned(),
            sample: visible("point.x") + "let color = plain_texture(rank, 0.0);",
        },
    })
}
