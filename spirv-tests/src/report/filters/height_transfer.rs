//! A height transfer: a color map over the visible heights that a curve makes.

use super::brute::Brute;
use super::case::{Case, Role, Row};
use super::maps::{naive, named};
use super::pixel::{Drawn, Pixel};
use crate::report::Error;
use prefilter::reference::slope_nodes::{Along, Transferred};
use prefilter::{HeightTransfer, Ranges, Scene, TransferTier};

const MAPS: [&str; 2] = ["terrain", "steps6"];

/// Where the curve, a smoothstep, begins to rise, and where it ends.
const ENDS: [f32; 2] = [0.0, 1.2];

/// Every map by every tier.
///
/// # Errors
/// Damaged data.
pub fn cases(count: usize) -> Result<Vec<Case>, Error> {
    MAPS.into_iter().take(count).map(case).collect()
}

const NAIVE: &str = "fn unfiltered(mean: f32) -> vec3f {
    let t = clamp(mean / 1.2, 0.0, 1.0);
    return plain_texture(t * t * (3.0 - 2.0 * t), 0.0);
}";

/// Statements before the samples: how steep the curve is in the mean, and by the area of the facets that face view and
/// light, how much they hide, Λ.
const BEFORE: &str = "var steep = 0.0;
    var area = vec2f();
    let d = view.xy;
    let e = light.xy;
    let reach = sqrt(max(vec2f(
        d.x * d.x * slope_covariance.x + 2.0 * d.x * d.y * slope_covariance.y + d.y * d.y * slope_covariance.z,
        e.x * e.x * slope_covariance.x + 2.0 * e.x * e.y * slope_covariance.y + e.y * e.y * slope_covariance.z
    ), vec2f()));
    for (var index = 0u; index < count; index++) {
        let point = brute_point(index, across, chance);
        let t = clamp((mean + deviation * brute_quantile(point.x, 1.0 - point.x)) / 1.2, 0.0, 1.0);
        let slope = 5.0 * t * (1.0 - t);
        steep += slope;
        area += max(vec2f(view.z, light.z) - slope * reach * brute_quantile(point.y, 1.0 - point.y), vec2f());
    }
    steep = max(steep / f32(count), 1e-20);
    let lambda = max(area.x / (f32(count) * view.z) + area.y / (f32(count) * light.z) - 2.0, 0.0);
    var above = 0.0;";

/// A sample, from the highest value of f down: what is above it hides it, and more so where the curve is steep.
const SAMPLE: &str = "let place = f32(count - 1u - index);
        let along = fract(f32(across) * point.x);
        let rank = (place + along) / f32(count);
        let t = clamp((mean + deviation * brute_quantile(rank, 1.0 - rank)) / 1.2, 0.0, 1.0);
        let hiding = 5.0 * t * (1.0 - t) / steep;
        let hidden = above + hiding * log((place + 1.0) / (place + along));
        above += hiding * log((place + 1.0) / max(place, 1e-3));
        let weight = max((1.0 + lambda * hiding) * exp(-lambda * hidden), 1e-30);
        let color = plain_texture(t * t * (3.0 - 2.0 * t), 0.0);";

fn case(name: &str) -> Result<Case, Error> {
    let map = named(name)?;
    let curve = HeightTransfer::smoothstep(ENDS[0], ENDS[1])?;
    let scene = || Scene::new("judged").height(map.clone()).transfer(curve.clone());
    let (plain, reference) = (naive("plain", &map)?, map.reference());
    let Ranges { mean: (low, high), deviation } = Ranges::of_transfer(&curve);
    let of = |tier: TransferTier| scene().transfer_tier(tier).module();
    let rows = vec![
        Row::text(Role::Naive, "naive: the height of the mean", vec![plain.clone()], NAIVE, "unfiltered"),
        // Its bound is against one normal distribution of heights, which those of a curve have not.
        Row::of(Role::Paper, TransferTier::Paper, of(TransferTier::Paper)?).unbounded(),
        Row::of(Role::Independent, "all heights alike", scene().module()?).straight(),
        Row::of(Role::Tier, TransferTier::ThreeNodes, of(TransferTier::ThreeNodes)?),
    ];
    let rows = Row::with_default(rows, scene().module()?);
    // Where the map bends or jumps no part may lie on both sides.
    let bends = map.knots().iter().flat_map(|knot| curve.crossings(-10.0, 10.0, knot.position.into()));
    let breaks: Vec<f64> = curve.bends().into_iter().chain(bends).collect();
    let truth = move |pixel: &Pixel| {
        let surface = Transferred::new([pixel.mean, pixel.deviation], &breaks, |f| curve.height(f), |f| curve.slope(f));
        let lambda = surface.lambda(along(pixel, pixel.view)) + surface.lambda(along(pixel, pixel.light));
        let mut color = [0.0; 4];
        for (part, share) in surface.parts.iter().zip(surface.visible_heights(lambda)) {
            let value = reference.value(part.height);
            color.iter_mut().zip(value).for_each(|(sum, channel)| *sum += share * channel);
        }
        color
    };
    Ok(Case {
        stem: format!("transfer_{name}"),
        map: name.to_owned(),
        rows,
        drawn: Drawn {
            mean: [low, high].map(f64::from),
            // From the distance of two columns of the table of nodes on.
            deviation: [f64::from(high - low) / 63.0, deviation.into()],
            slope: 0.0,
            slope_deviation: [0.1, 0.8],
            rise: 0.12,
        },
        share: 8,
        truth: Box::new(truth),
        sources: vec![include_str!("height_transfer.rs"), include_str!("maps.rs")],
        brute: Brute {
            modules: vec![plain],
            parameters: "mean: f32, deviation: f32, slope_covariance: vec3f, view: vec3f, light: vec3f",
            before: BEFORE.to_owned(),
            sample: SAMPLE.to_owned(),
        },
    })
}

/// The slopes of f towards a direction.
fn along(pixel: &Pixel, direction: [f64; 3]) -> Along {
    let [x, y, z] = direction;
    let away = x.hypot(y).max(1e-12);
    let [xx, xy, yy] = pixel.covariance;
    let variance = (x * x * xx + 2.0 * x * y * xy + y * y * yy) / (away * away);
    Along { angle: away.atan2(z), mean: 0.0, deviation: variance.sqrt() }
}
