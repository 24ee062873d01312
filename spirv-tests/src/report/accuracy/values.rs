//! Random scenes of values and heights, and of layers of both.

use prefilter::{Colors, Distribution, Error, HeightTier, Microsurface, Ranges, Scene, SlopeTier};

use super::case::{map, ranged, ranges, Case, EXACT};
use super::filter::Filter;
use super::pixel::{self, Pixel};
use super::truth::{lambda, Truth};
use crate::random::Random;

/// A unit of positions and a place for them.
fn scale(random: &mut Random) -> (f32, f32) {
    let unit = random.pick([1.0, 1.0, 1.0, 0.05, 30.0]);
    (unit, unit * random.pick([0.0, 0.0, 0.0, -3.0, 0.5]))
}

pub(super) fn texture(random: &mut Random, count: usize) -> Result<Case, Error> {
    let ((unit, low), banded) = (scale(random), random.pick([true, false, false, false]));
    let map = map(random, low, low + unit, banded)?;
    let colors = random.pick([Colors::Constant, Colors::Constant, Colors::Constant, Colors::Dynamic]);
    let scene = ranged(Scene::new("judged").texture(map.clone()).colors(colors), ranges(random, &map));
    let pixels = pixel::values(random, &map, scene.chosen_ranges(), count);
    let (finest, truth) = (Some(scene.clone().tier(EXACT)), Truth::Values(map.reference()));
    Ok(Case { filter: Filter::Texture, scene, finest, pixels, truth })
}

pub(super) fn bounded(random: &mut Random, count: usize) -> Result<Case, Error> {
    let map = map(random, 0.1, 0.9, false)?;
    let scene = Scene::new("judged").texture(map.clone()).distribution(Distribution::Beta { low: 0.0, high: 1.0 });
    let mut pixels = pixel::values(random, &map, Ranges { mean: (0.001, 0.999), deviation: 0.49 }, count);
    // No value between the ends deviates by more.
    pixels.retain(|pixel| pixel.deviation.powi(2) < 0.999 * pixel.mean * (1.0 - pixel.mean));
    pixels.truncate(count);
    let truth = Truth::Bounded(map.reference(), [0.0, 1.0]);
    Ok(Case { filter: Filter::Bounded, finest: Some(scene.clone()), scene, pixels, truth })
}

/// The deviation of heights from which bounds hold.
pub(super) fn floor(ranges: Ranges, largest: f32) -> f64 {
    f64::from(1.001 * (1e-3 * largest).min(0.1 * ranges.deviation).max(1e-5))
}

pub(super) fn largest_mean(ranges: Ranges) -> f32 {
    ranges.mean.0.abs().max(ranges.mean.1.abs())
}

pub(super) fn height(random: &mut Random, count: usize) -> Result<Case, Error> {
    let ((unit, low), banded) = (scale(random), random.pick([true, false, false, false]));
    let map = map(random, low, low + unit, banded)?;
    let colors = random.pick([Colors::Constant, Colors::Constant, Colors::Constant, Colors::Dynamic]);
    let shadowing = random.pick([true, false]);
    let scene = Scene::new("judged").height(map.clone()).colors(colors);
    let scene = scene.microsurface(Microsurface { shadowing, ..Microsurface::default() });
    let scene = ranged(scene, ranges(random, &map));
    let ranges = scene.chosen_ranges();
    let floor = floor(ranges, largest_mean(ranges));
    let pixels = pixel::heights(random, &map, ranges, floor, |pixel| lambda(pixel, shadowing), count);
    let exact = banded && colors == Colors::Constant;
    let finest = scene.clone().height_tier(if exact { HeightTier::Exact } else { HeightTier::ClosedForm });
    let truth = Truth::Heights(map.reference(), shadowing);
    Ok(Case { filter: Filter::Height, scene, finest: Some(finest), pixels, truth })
}

pub(super) fn percentile(random: &mut Random, count: usize) -> Result<Case, Error> {
    let banded = random.pick([true, false]);
    let map = map(random, 0.0, 1.0, banded)?;
    let scene = Scene::new("judged").height_percentile(map.clone());
    let pixels = pixel::heights(random, &map, Ranges::default(), 1e-3, |pixel| lambda(pixel, true), count);
    let truth = Truth::Percentiles(map.reference(), true);
    Ok(Case { filter: Filter::Percentile, scene, finest: None, pixels, truth })
}

pub(super) fn combination(random: &mut Random, count: usize) -> Result<Case, Error> {
    let maps = [map(random, 0.2, 0.8, false)?, map(random, 0.1, 0.9, false)?, map(random, 0.2, 1.0, false)?];
    let [mask, one, other] = maps.each_ref();
    let layers = |finest: bool| {
        let [high, grain, rock] = [
            Scene::new("high").height(mask.clone()),
            Scene::new("grain").texture(one.clone()),
            Scene::new("rock").steepness(other.clone()),
        ];
        let [high, grain, rock] = match finest {
            true => [high.height_tier(HeightTier::ClosedForm), grain.tier(EXACT), rock.slope_tier(SlopeTier::Pair)],
            false => [high, grain, rock],
        };
        Scene::new("judged").combination(&high * &grain + (1.0 - &high) * &rock)
    };
    let (largest, most) = (1.25f64, 0.5f64);
    let mean = |random: &mut Random, _| {
        let (sin, cos) = (std::f64::consts::TAU * random.unit()).sin_cos();
        let at = 0.8 * largest * random.unit();
        [at * cos, at * sin]
    };
    let slopes = pixel::slopes(random, [0.05, most], mean, count);
    let heights = pixel::heights(random, mask, Ranges::default(), 2e-3, |pixel| lambda(pixel, true), count);
    let pixels = slopes.into_iter().zip(heights).filter_map(|(slopes, pixel)| {
        let joined = Pixel { visible: slopes.visible, ..pixel };
        (lambda(&joined, true) <= 1e4).then_some(joined)
    });
    let parts =
        [Truth::Heights(mask.reference(), true), Truth::Values(one.reference()), Truth::Length(other.reference())];
    let (pixels, truth) = (pixels.collect(), Truth::Mixed(Box::new(parts)));
    Ok(Case { filter: Filter::Combination, scene: layers(false), finest: Some(layers(true)), pixels, truth })
}
