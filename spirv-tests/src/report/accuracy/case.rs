//! Random scenes that an accuracy chooses for.

use prefilter::{Accuracy, ColorMap, Error, Kernel, Module, Ranges, Scene, Tier};

use super::filter::Filter;
use super::pixel::Pixel;
use super::truth::Truth;
use super::{curves, slopes, values};
use crate::random::Random;

/// A scene that asks for no accuracy yet, and what judges it.
pub struct Case {
    /// What it filters.
    pub filter: Filter,
    /// The scene.
    pub scene: Scene,
    /// The same with its finest tier, where it has more than one.
    pub finest: Option<Scene>,
    /// Where it is judged.
    pub pixels: Vec<Pixel>,
    /// By what.
    pub truth: Truth,
}

pub(super) const EXACT: Tier = Tier::ClosedForm(Kernel::Exact);

/// A map between two positions: of two to twenty stops, smooth, with hard edges or of bands, of much contrast or
/// little.
pub(super) fn map(random: &mut Random, low: f32, high: f32, banded: bool) -> Result<ColorMap, Error> {
    let count = random.pick([2, 3, 4, 5, 6, 8, 12, 20]);
    let hard = random.pick([false, false, false, true]);
    let contrast = random.pick([1.0, 1.0, 0.3]);
    let base = (1.0 - contrast) * random.unit() as f32;
    let mut color = || [(); 3].map(|()| base + contrast * random.unit() as f32);
    let mut stops = Vec::new();
    for index in 0..count {
        // Uneven, and never at the same place.
        let part = (index as f32 + 0.8 * (color()[0] - base) / contrast) / (count as f32 - 0.2);
        let position = low + (high - low) * part.min(1.0);
        stops.push((position, color()));
        if hard && index % 2 == 1 {
            stops.push((position, color()));
        }
    }
    if banded {
        let first = color();
        stops.dedup_by_key(|stop| stop.0);
        return ColorMap::bands(first, stops);
    }
    ColorMap::gradient(stops)
}

/// The ranges of the map, or narrower ones.
pub(super) fn ranges(random: &mut Random, map: &ColorMap) -> Option<Ranges> {
    let Ranges { mean: (low, high), .. } = Ranges::of(map);
    let width = high - low;
    let part = random.between(0.3, 1.2) as f32;
    let from = low + 0.3 * width * random.unit() as f32;
    let deviation = (f64::from(width) * random.between(0.01, 0.5)).max(1e-3) as f32;
    random.pick([None, Some(Ranges { mean: (from, from + part * width), deviation })])
}

impl Case {
    /// The case of a number, judged at so many times the usual count of pixels.
    ///
    /// # Errors
    /// None that was seen: maps and curves are such as there may be.
    pub fn new(number: u32, density: f64) -> Result<Self, Error> {
        let mut random = Random::new(number.wrapping_mul(2_654_435_761).wrapping_add(97));
        let random = &mut random;
        let count = |pixels: f64| (pixels * density).ceil() as usize;
        match Filter::of(number) {
            Filter::Texture => values::texture(random, count(400.0)),
            Filter::Bounded => values::bounded(random, count(60.0)),
            Filter::Height => values::height(random, count(300.0)),
            Filter::Percentile => values::percentile(random, count(200.0)),
            Filter::Slope => slopes::slope(random, count(60.0)),
            Filter::Steepness => slopes::steep(random, count(50.0)),
            Filter::SlopeMap => slopes::slope_map(random, count(16.0)),
            Filter::Irradiance => slopes::irradiance(random, count(50.0)),
            Filter::Combination => values::combination(random, count(60.0)),
            Filter::Raised => curves::raised(random, count(20.0)),
            Filter::Steepened => curves::steepened(random, count(60.0)),
        }
    }
}

impl Case {
    /// The module that a budget chooses.
    ///
    /// # Errors
    /// That no tier keeps it.
    pub fn within(&self, budget: f64) -> Result<Module, Error> {
        self.scene.clone().accuracy(Accuracy::max_filter_error(budget as f32)).module()
    }
}

pub(super) fn ranged(scene: Scene, ranges: Option<Ranges>) -> Scene {
    match ranges {
        Some(ranges) => scene.ranges(ranges),
        None => scene,
    }
}
