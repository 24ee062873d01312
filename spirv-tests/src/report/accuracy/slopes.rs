//! Random scenes of slopes and of normals.

use prefilter::{
    Colors, Error, Irradiance, IrradianceTier, Ranges, Scene, SlopeDomain, SlopeMap, SlopeTaps, SlopeTier,
};

use super::case::{map, ranged, Case, EXACT};
use super::filter::Filter;
use super::pixel;
use super::truth::Truth;
use super::values::{floor, largest_mean};
use crate::environments::GRACE;
use crate::random::Random;

pub(super) fn slope(random: &mut Random, count: usize) -> Result<Case, Error> {
    let (unit, banded) = (random.pick([1.0, 0.2]), random.pick([true, false, false, false]));
    let center = unit * random.pick([0.0, 0.3, -0.5]);
    let map = map(random, center - 0.5 * unit, center + 0.5 * unit, banded)?;
    let deviation = (unit * random.between(0.02, 0.6) as f32).max(1e-3);
    let own = Ranges { mean: (center - unit, center + unit), deviation };
    let colors = random.pick([Colors::Constant, Colors::Constant, Colors::Constant, Colors::Dynamic]);
    let ranges = random.pick([None, Some(own)]);
    let scene = ranged(Scene::new("judged").slope(map.clone()).colors(colors), ranges);
    let ranges = scene.chosen_ranges();
    let floor = floor(ranges, largest_mean(ranges).max(1.0));
    let pixels = pixel::components(random, &map, ranges, floor, count);
    let finest = scene.clone().slope_tier(SlopeTier::Pair).tier(EXACT);
    let truth = Truth::Component(map.reference());
    Ok(Case { filter: Filter::Slope, scene, finest: Some(finest), pixels, truth })
}

pub(super) fn steep(random: &mut Random, count: usize) -> Result<Case, Error> {
    let map = map(random, 0.1, 1.1, random.clone().pick([true, false, false]))?;
    let own = Ranges { mean: (0.0, 1.0), deviation: random.between(0.05, 0.6) as f32 };
    let ranges = random.pick([None, Some(own)]);
    let scene = ranged(Scene::new("judged").steepness(map.clone()), ranges);
    let ranges = scene.chosen_ranges();
    let most = f64::from(ranges.deviation);
    let floor = 1.001 * (1e-3 * (f64::from(ranges.mean.1) + 1.35 * most)).max(1e-5);
    let length = |random: &mut Random, deviation: f64| {
        let knot = f64::from(map.knots()[random.word() as usize % map.knots().len()].position);
        // As far as half a cell of the table.
        let reach = random.pick([2.0 * deviation, 0.01]);
        let near = knot + reach * (2.0 * random.unit() - 1.0);
        let at = random.pick([near, near, near, 1.0]).clamp(0.0, ranges.mean.1.into());
        let (sin, cos) = (std::f64::consts::TAU * random.unit()).sin_cos();
        [0.9999 * at * cos, 0.9999 * at * sin]
    };
    let pixels = pixel::slopes(random, [floor, most], length, count);
    let finest = scene.clone().slope_tier(SlopeTier::Pair);
    let truth = Truth::Length(map.reference());
    Ok(Case { filter: Filter::Steepness, scene, finest: Some(finest), pixels, truth })
}

pub(super) fn slope_map(random: &mut Random, count: usize) -> Result<Case, Error> {
    let domain = random.pick([SlopeDomain::All, SlopeDomain::Within(1.5)]);
    let (kind, contrast, turn) = (random.word() % 3, random.pick([1.0, 0.5, 0.1]), random.unit() as f32 * 6.3);
    let (sin, cos) = turn.sin_cos();
    let map = SlopeMap::from_function(64, domain, |[x, y]| {
        let [along, across] = [cos * x + sin * y, cos * y - sin * x];
        let inside = |yes: bool| f32::from(u8::from(yes));
        let azimuth = across.atan2(along);
        let color = match kind {
            // An edge of each shape that was measured, a channel each.
            0 => [inside(along > 0.17), inside(x.hypot(y) < 0.6), inside(along > 0.0 && across > 0.0)],
            1 => [0.5 + 0.5 * azimuth.cos(), 0.5 + 0.5 * azimuth.sin(), 0.5],
            _ => [0.5 + 0.5 * along.tanh(), 1.0 / (1.0 + x * x + y * y), 0.5 + 0.5 * (2.0 * across).tanh()],
        };
        color.map(|channel| 0.5 + contrast * (channel - 0.5))
    })?;
    let own = Ranges { mean: (-0.8, 0.8), deviation: random.between(0.1, 0.6) as f32 };
    let ranges = random.pick([None, Some(own)]);
    let scene = ranged(Scene::new("judged").slope_map(map.clone()), ranges);
    let ranges = scene.chosen_ranges();
    let (most, largest) = (f64::from(ranges.deviation), f64::from(largest_mean(ranges)));
    let mean = |random: &mut Random, _| [(); 2].map(|()| largest * (2.0 * random.unit() - 1.0));
    let pixels = pixel::slopes(random, [0.2401 * most, most], mean, count);
    let finest = scene.clone().slope_tier(SlopeTier::Pair).slope_taps(SlopeTaps::Eleven);
    let truth = Truth::Slopes(map.reference());
    Ok(Case { filter: Filter::SlopeMap, scene, finest: Some(finest), pixels, truth })
}

pub(super) fn irradiance(random: &mut Random, count: usize) -> Result<Case, Error> {
    let (brightness, part) = (random.between(0.02, 2.0), random.unit());
    let radiance = GRACE.map(|color| {
        color.map(|channel| (brightness * (f64::from(channel) * part + 0.3 * (1.0 - part) * random.unit())) as f32)
    });
    let narrow = Ranges { mean: (-0.3, 0.3), deviation: random.between(0.1, 1.0) as f32 };
    let ranges = random.pick([None, Some(narrow)]);
    let scene = ranged(Scene::new("judged").irradiance(Irradiance::from_harmonics(radiance)?), ranges);
    let pixels = pixel::normals(random, scene.chosen_ranges().deviation.into(), count);
    let finest = scene.clone().irradiance_tier(IrradianceTier::FourGaussians);
    let truth = Truth::Normals(radiance.map(|color| color.map(f64::from)));
    Ok(Case { filter: Filter::Irradiance, scene, finest: Some(finest), pixels, truth })
}
