//! Bounds that hold for every map and range hold for those that nobody chose: narrow and huge ranges, colors far from
//! zero, knots far outside, edges between edges.

use std::error::Error;

use prefilter::gpu::Device;
use prefilter::{Bound, ColorMap, Colors, Kernel, Ranges, Scene, Tier};
use spirv_tests::judged::{measured, points};
use spirv_tests::random::Random;

type Outcome = Result<(), Box<dyn Error + Send + Sync>>;

/// The largest position and color.
const MOST: f32 = 65504.0;

/// Every tier whose bound is a promise.
const PROMISED: [(Tier, Colors); 4] = [
    (Tier::Naive, Colors::Constant),
    (Tier::ClosedForm(Kernel::Fast), Colors::Constant),
    (Tier::ClosedForm(Kernel::Exact), Colors::Constant),
    (Tier::ClosedForm(Kernel::Exact), Colors::Dynamic),
];

/// Tiers whose bound is an estimate over the whole range of means, which the paper's does not cover.
const TABLES: [(Tier, Colors); 2] = [(Tier::Table, Colors::Constant), (Tier::Table, Colors::Dynamic)];

/// Ranges of any width and place, with deviations from a thousandth of it to ten times it.
fn ranges(random: &mut Random) -> Ranges {
    let width = random.pick([1e-3, 1e-2, 1.0, 1.5, 100.0, MOST]);
    let center = random.pick([0.0, 0.5, -3.0, 1000.0, 65_000.0]);
    // Far from 0 the narrowest ranges lie between two numbers.
    let low = (center - 0.5 * width).clamp(-MOST, MOST - 0.01);
    let high = (low + width).min(MOST).max(low + low.abs() * 2.4e-7 + 1e-3);
    Ranges { mean: (low, high), deviation: (random.pick([1e-3, 0.1, 0.33, 1.0, 10.0]) * width).clamp(1e-3, MOST) }
}

/// A map about the middle of the ranges, narrower or wider than they, smooth or not, with hard edges or without.
fn map(random: &mut Random, ranges: Ranges) -> Result<ColorMap, prefilter::Error> {
    let (low, high) = ranges.mean;
    let (middle, spread) = (0.5 * (low + high), random.pick([1.0, 1.0, 1e-2, 10.0]) * (high - low));
    let (offset, size) = (random.pick([0.0, 1.0, 100.0, -30_000.0]), random.pick([1.0, 1.0, 1e-2, 1e-4, 30_000.0]));
    let (smooth, hard) = (random.pick([true, false]), random.pick([true, false]));
    let count = random.pick([1, 2, 3, 6, 20, 60, 300]);
    let mut positions: Vec<f32> =
        (0..count).map(|_| (middle + (random.unit() as f32 - 0.5) * spread).clamp(-MOST, MOST)).collect();
    positions.sort_by(f32::total_cmp);
    positions.dedup();
    let mut stops = Vec::new();
    for (index, position) in positions.into_iter().enumerate() {
        let phase = (position - middle) / spread * 7.0;
        let mut color = || {
            let part = |channel: usize| match smooth {
                true => 0.5 + 0.5 * (phase + channel as f32).sin(),
                false => random.unit() as f32,
            };
            [0, 1, 2, 3].map(part).map(|part| (offset + size * part).clamp(-MOST, MOST))
        };
        stops.push((position, color()));
        if hard && index % 3 == 1 {
            stops.push((position, color().map(|channel| (channel + 0.1 * size).min(MOST))));
        }
    }
    ColorMap::gradient(stops)
}

/// Checks the bounds of some tiers for a map.
fn keeps(device: &Device, map: &ColorMap, ranges: Ranges, tiers: &[(Tier, Colors)], case: &str) -> Outcome {
    let points = points(map, ranges, 1000);
    let (low, high) = map.hull();
    let largest = low.iter().chain(&high).fold(0.0f32, |largest, channel| largest.max(channel.abs()));
    for &(tier, colors) in tiers {
        let module = Scene::new("judged").texture(map.clone()).tier(tier).colors(colors).ranges(ranges).module()?;
        let bound = module.bound();
        assert_eq!(matches!(bound, Bound::Guaranteed(_)), tier != Tier::Table, "{tier}");
        let error = measured(device, &module, map, &points)?;
        // The reference errs by 1e-12 of the largest color.
        let place = format!("{case}, {tier}, {colors:?}, {ranges:?}, {} knots", map.knots().len());
        assert!(error <= bound.value() + 1e-12 * largest, "{error:e} exceeds {bound}: {place}");
    }
    Ok(())
}

#[test]
fn random_maps_keep_their_bounds_in_random_ranges() -> Outcome {
    let device = Device::new()?;
    for seed in 0..40 {
        let mut random = Random::new(seed);
        let ranges = ranges(&mut random);
        keeps(&device, &map(&mut random, ranges)?, ranges, &PROMISED, &format!("seed {seed}"))?;
    }
    Ok(())
}

/// Twice what was measured between texels is no promise, but it held for each of 400 random cases.
#[test]
fn estimates_of_tables_hold_for_random_maps() -> Outcome {
    let device = Device::new()?;
    for seed in 1000..1012 {
        let mut random = Random::new(seed);
        let ranges = ranges(&mut random);
        keeps(&device, &map(&mut random, ranges)?, ranges, &TABLES, &format!("seed {seed}"))?;
    }
    Ok(())
}

#[test]
fn maps_that_broke_a_bound_keep_it() -> Outcome {
    let device = Device::new()?;
    // A change so small that its sum with the color rounds by more than the change's own error.
    let pale = ColorMap::gradient([(0.0, [0.9; 3]), (1.0, [0.91, 0.92, 0.93])])?;
    keeps(&device, &pale, Ranges::default(), &PROMISED, "pale")?;
    // Knots one and two numbers apart, far from 0: a compiler folds half a width into the position.
    let next = |at: f32, by: u32| f32::from_bits(at.to_bits() + by);
    let at = 64_999.76;
    let stops = [(at, [0.0, 1.0, 0.5]), (next(at, 1), [1.0, 0.0, 0.5]), (next(at, 3), [0.5, 0.2, 0.9])];
    let far = Ranges { mean: (64_999.5, 65_000.5), deviation: 0.33 };
    keeps(&device, &ColorMap::gradient(stops)?, far, &PROMISED, "far")?;
    // A width that devices flush to 0.
    let stops = [(-0.5, [0.3; 3]), (0.0, [0.0, 1.0, 0.5]), (1e-40, [1.0, 0.0, 0.5]), (0.5, [0.2; 3])];
    keeps(&device, &ColorMap::gradient(stops)?, Ranges::default(), &PROMISED, "subnormal")
}
