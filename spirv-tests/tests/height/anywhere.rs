//! Maps far from 0, of any size and color, with ranges that are not theirs.

use prefilter::gpu::Device;
use prefilter::{ColorMap, Colors, HeightTier, Ranges, Scene};
use spirv_tests::random::Random;

use crate::{calls, error, Fault, Outcome, EXACT};

/// Gradients with hard edges, or bands, about a place.
fn map(numbers: &mut Random, center: f64, unit: f64, banded: bool) -> Result<ColorMap, Fault> {
    let (offset, size) = (numbers.pick([0.0, 1.0, 100.0, -30_000.0]), numbers.pick([1.0, 1e-2, 1e-4, 30_000.0]));
    let count = numbers.pick([1, 2, 3, 20]);
    let mut positions: Vec<f32> = (0..count).map(|_| (center + unit * (numbers.unit() - 0.5)) as f32).collect();
    positions.sort_by(f32::total_cmp);
    positions.dedup();
    let mut color = || [0.0; 4].map(|_: f32| offset + size * numbers.unit() as f32);
    if banded {
        let lowest = color();
        return Ok(ColorMap::bands(lowest, positions.into_iter().map(|at| (at, color())))?);
    }
    let stops = positions.into_iter().enumerate().flat_map(|(index, at)| {
        let hard = (index % 3 == 0).then(&mut color);
        [Some((at, color())), hard.map(|color| (at, color))].into_iter().flatten().collect::<Vec<_>>()
    });
    Ok(ColorMap::gradient(stops.collect::<Vec<_>>())?)
}

/// Every tier holds its bound from the deviation that it states: a thousandth of the largest mean, or a tenth of the
/// largest deviation where that is less.
#[test]
fn any_map_keeps_its_bound_over_any_ranges() -> Outcome {
    let device = Device::new()?;
    for seed in 0..20 {
        let mut numbers = Random::new(300 + seed);
        let unit = numbers.pick([1e-2, 1.0, 300.0]);
        let center = unit * numbers.pick([0.0, 0.5, -3.0, 60.0]);
        let banded = seed % 4 == 3;
        let map = map(&mut numbers, center, unit, banded)?;
        let from = center + unit * numbers.pick([-0.6, -2.0, 0.1, 0.7]);
        let mean = (from as f32, (from + unit * numbers.pick([1.2, 0.2, 4.0])) as f32);
        let ranges = Ranges { mean, deviation: (unit * numbers.pick([0.5, 0.1, 2.0, 1e-2])).max(1e-3) as f32 };
        let largest = mean.0.abs().max(mean.1.abs());
        let floor = 1.001 * (1e-3 * largest).min(0.1 * ranges.deviation).max(1e-5);
        let calls = calls(&mut numbers, &map, ranges, floor, 300);
        let scene = |tier: HeightTier| Scene::new("rock").height(map.clone()).ranges(ranges).height_tier(tier);
        let closed = scene(HeightTier::ClosedForm);
        let mut scenes = vec![
            ("Gaussian", scene(HeightTier::Gaussian).tier(EXACT)),
            ("fast closed form", scene(HeightTier::ClosedFormFast)),
            ("closed form", closed.clone()),
            ("closed form, dynamic", closed.colors(Colors::Dynamic)),
            ("table", scene(HeightTier::Skewed)),
        ];
        scenes.extend(banded.then(|| ("bands", scene(HeightTier::Exact))));
        for (name, scene) in scenes {
            let (bound, found) = (f64::from(scene.module()?.bound().value()), error(&device, &scene, &calls)?);
            println!("seed {seed}, {name}: {found:.2e}, bound {bound:.2e}");
            // The reference errs by 1e-9 of a color.
            let largest = map.hull().0.into_iter().chain(map.hull().1).fold(0.0f32, |a, b| a.max(b.abs()));
            assert!(found <= bound + 1e-9 * f64::from(largest), "seed {seed}, {name}: {found:e} of {bound:e}");
        }
    }
    Ok(())
}
