//! A combination: values, heights and slopes, added and multiplied.

use super::brute::Brute;
use super::case::{Case, Role, Row};
use super::height::{self, hiding, visible, LAMBDA};
use super::maps::naive;
use super::slope::{seen, SOURCE};
use crate::report::Error;
use prefilter::reference::{height as heights, steepness, texture};
use prefilter::{ColorMap, Combination, HeightTier, Kernel, Scene, SlopeTier, Tier};

/// Grain on rock that is darker where it is steep, under snow that lies high.
const SNOW: [f32; 3] = [0.9, 0.9, 0.95];

fn grain() -> Result<ColorMap, prefilter::Error> {
    ColorMap::gradient([(0.1, [0.5; 3]), (0.5, [0.8, 0.7, 0.6]), (0.9, [1.0, 0.95, 0.9])])
}

fn rock() -> Result<ColorMap, prefilter::Error> {
    ColorMap::gradient([(0.2, [0.5, 0.45, 0.3]), (0.5, [0.3, 0.3, 0.28]), (0.9, [0.2, 0.18, 0.17])])
}

fn high() -> Result<ColorMap, prefilter::Error> {
    ColorMap::gradient([(0.5, [0.0; 3]), (0.7, [1.0; 3])])
}

/// Tiers of the three layers; none are those of a scene without settings.
type Tiers = Option<(Tier, SlopeTier, HeightTier, Option<Tier>)>;

fn scene(tiers: Tiers) -> Result<Scene, prefilter::Error> {
    let grain = Scene::new("grain").texture(grain()?);
    let (rock, high) = (Scene::new("rock").steepness(rock()?), Scene::new("high").height(high()?));
    let layers = match tiers {
        None => [grain, rock, high],
        Some((values, slopes, heights, beneath)) => {
            let high = high.height_tier(heights);
            [grain.tier(values), rock.slope_tier(slopes), beneath.map_or(high.clone(), |tier| high.tier(tier))]
        }
    };
    let [grain, rock, high] = &layers;
    Ok(Scene::new("judged").combination(grain * rock * (1.0 - high) + Combination::color(SNOW)? * high))
}

const NAIVE: &str = "fn unfiltered(mean: f32, grain_mean: f32, mean_slope: vec2f) -> vec3f {
    let part = high_texture(mean, 0.0);
    let ground = grain_texture(grain_mean, 0.0) * rock_texture(length(mean_slope), 0.0);
    return ground * (1.0 - part) + vec3f(0.9, 0.9, 0.95) * part;
}";

/// The combination by its layers' tiers.
///
/// # Errors
/// None: the maps are fixed.
pub fn cases(_: usize) -> Result<Vec<Case>, Error> {
    let plain = vec![naive("grain", &grain()?)?, naive("rock", &rock()?)?, naive("high", &high()?)?];
    let exact = Tier::ClosedForm(Kernel::Exact);
    let paper = scene(Some((Tier::Paper, SlopeTier::Gaussian, HeightTier::Paper, Some(Tier::Paper))))?.module()?;
    let closest = scene(Some((exact, SlopeTier::Pair, HeightTier::ClosedForm, None)))?.module()?;
    let rows = vec![
        Row::text(Role::Naive, "naive: mean value, height and slope", plain.clone(), NAIVE, "unfiltered"),
        Row::of(Role::Paper, "the paper's tables of values and heights", paper),
        Row::of(Role::Independent, "all heights and slopes alike", scene(None)?.module()?).straight(),
        Row::of(Role::Tier, "the closest tier of each layer", closest),
    ];
    let rows = Row::with_default(rows, scene(None)?.module()?);
    let [grain, rock, high] = [grain()?, rock()?, high()?].map(|map| map.reference());
    Ok(vec![Case {
        stem: "combination_snow".to_owned(),
        map: "snow".to_owned(),
        rows,
        drawn: super::pixel::Drawn { slope_deviation: [0.05, 0.5], ..height::DRAWN },
        share: 8,
        truth: Box::new(move |pixel| {
            let grain = texture::mean(&grain, pixel.value[0], pixel.value[1]);
            let rock = steepness::mean(&rock, &seen(pixel));
            let high = heights::mean(&high, pixel.mean, pixel.deviation, hiding(pixel));
            let snow = SNOW.map(f64::from);
            let of = |c: usize| grain[c] * rock[c] * (1.0 - high[c]) + snow[c] * high[c];
            [of(0), of(1), of(2), 0.0]
        }),
        sources: vec![SOURCE, include_str!("combine.rs"), include_str!("height.rs"), include_str!("maps.rs")],
        brute: Brute {
            modules: plain,
            parameters: "mean: f32, deviation: f32, grain_mean: f32, grain_deviation: f32, mean_slope: vec2f, \
                         slope_covariance: vec3f, view: vec3f, light: vec3f",
            before: LAMBDA.to_owned(),
            sample: format!(
                "let other = brute_number(index, count, 173u, chance);
        {}
        let slope = brute_slope(point, mean_slope, slope_covariance);
        let area = max(view.z - dot(view.xy, slope), 1e-6);
        let value = grain_mean + grain_deviation * brute_quantile(other, 1.0 - other);
        let part = high_texture(mean + deviation * height, 0.0);
        let ground = grain_texture(value, 0.0) * rock_texture(length(slope), 0.0);
        let color = ground * (1.0 - part) + vec3f(0.9, 0.9, 0.95) * part;
        let weight = shown * area;",
                visible("brute_number(index, count, 421u, chance)").replace("let weight", "let shown")
            ),
        },
    }])
}
