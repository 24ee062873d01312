//! C0: a color map over a normal variable.

use super::brute::Brute;
use super::case::{Case, Role, Row};
use super::maps::{naive, named};
use super::pixel::Drawn;
use crate::report::Error;
use prefilter::reference::texture;
use prefilter::{Kernel, Scene, Tier};

/// The maps: a gradient of seven stops, and six steps with hard edges.
const MAPS: [&str; 2] = ["terrain", "steps6"];

/// Tiers of the ladder.
const TIERS: [Tier; 3] = [Tier::Table, Tier::ClosedForm(Kernel::Fast), Tier::ClosedForm(Kernel::Exact)];

/// Every map by every tier.
///
/// # Errors
/// Damaged data.
pub fn cases(count: usize) -> Result<Vec<Case>, Error> {
    MAPS.into_iter().rev().take(count).map(case).collect()
}

fn case(name: &str) -> Result<Case, Error> {
    let map = named(name)?;
    let scene = || Scene::new("judged").texture(map.clone());
    let (plain, reference, ranges) = (naive("plain", &map)?, map.reference(), scene().chosen_ranges());
    let mut rows = vec![Row::of(Role::Naive, "naive", scene().tier(Tier::Naive).module()?)];
    rows.push(Row::of(Role::Paper, Tier::Paper, scene().tier(Tier::Paper).module()?));
    for tier in TIERS {
        rows.push(Row::of(Role::Tier, tier, scene().tier(tier).module()?));
    }
    let [low, high] = [ranges.mean.0, ranges.mean.1].map(f64::from);
    Ok(Case {
        stem: format!("texture_{name}"),
        map: name.to_owned(),
        rows: Row::with_default(rows, scene().module()?),
        drawn: Drawn {
            mean: [low, high],
            deviation: [1e-3 * (high - low), ranges.deviation.into()],
            slope: 0.0,
            slope_deviation: [0.1, 0.5],
            rise: 0.0,
        },
        share: 1,
        truth: Box::new(move |pixel| texture::mean(&reference, pixel.mean, pixel.deviation)),
        sources: vec![include_str!("texture.rs"), include_str!("maps.rs")],
        brute: Brute {
            modules: vec![plain],
            parameters: "mean: f32, deviation: f32",
            before: String::new(),
            sample: "let weight = 1.0;
        let color = plain_texture(mean + deviation * brute_quantile(point.x, 1.0 - point.x), 0.0);"
                .to_owned(),
        },
    })
}
