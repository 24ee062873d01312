//! Random scenes of transferred heights.

use prefilter::reference::slopes::Visible;
use prefilter::{ColorMap, Error, HeightTransfer, Ranges, Scene, SlopeTier, TransferTier};

use super::case::{map, Case, EXACT};
use super::filter::Filter;
use super::pixel::{self, Pixel};
use super::truth::Truth;
use crate::random::Random;

fn curve(random: &mut Random) -> Result<HeightTransfer, Error> {
    match random.word() % 4 {
        0 => HeightTransfer::smoothstep(0.0, 1.2),
        1 => HeightTransfer::smoothstep(-1.0, 1.0),
        2 => Ok(HeightTransfer::absolute()),
        _ => HeightTransfer::samples(-1.0, 1.0, &[0.2, 0.9, 0.1, 0.4, 1.0]),
    }
}

/// Pixels over a curve, seen along x, with a light on the other side.
fn curved(random: &mut Random, curve: &HeightTransfer, floor: f64, count: usize) -> Vec<Pixel> {
    let Ranges { mean: (low, high), deviation } = Ranges::of_transfer(curve);
    let pixel = |random: &mut Random| {
        let map = ColorMap::gradient([(low, [0.0; 3]), (high, [1.0; 3])]).ok()?;
        let Pixel { light, frame, .. } = pixel::values(random, &map, Ranges::default(), 1).into_iter().next()?;
        let mean = f64::from(low) + f64::from(high - low) * random.unit();
        let [across, along] = [random.between(0.1, 0.8), random.between(0.1, 0.8)];
        let toward = |angle: f64| [angle.sin(), 0.0, angle.cos()];
        let (view, [_, _, z]) = (toward(1.45 * random.unit()), light);
        let visible = Visible { view, covariance: [along * along, 0.0, across * across], mean: [0.0; 2] };
        let light = toward(-1.45 * z);
        Some(Pixel {
            mean,
            deviation: random.between(floor, deviation.into()),
            visible,
            light,
            direction: [1.0, 0.0],
            frame,
        })
    };
    (0..count).filter_map(|_| pixel(random)).map(Pixel::rounded).collect()
}

pub(super) fn raised(random: &mut Random, count: usize) -> Result<Case, Error> {
    let (curve, map) = (curve(random)?, map(random, 0.0, 1.0, false)?);
    let scene = Scene::new("judged").height(map.clone()).transfer(curve.clone());
    let Ranges { mean: (low, high), .. } = Ranges::of_transfer(&curve);
    let pixels = curved(random, &curve, 2.01 * f64::from(high - low) / 120.0, count);
    let truth = Truth::Raised(map.reference(), curve);
    Ok(Case { filter: Filter::Raised, scene, finest: None, pixels, truth })
}

pub(super) fn steepened(random: &mut Random, count: usize) -> Result<Case, Error> {
    let (curve, map) = (curve(random)?, map(random, -0.8, 0.8, true)?);
    // Risers are up to four times as steep as f.
    let ranges = Ranges { mean: (-1.0, 1.0), deviation: 4.0 };
    let scene = Scene::new("judged").slope(map.clone()).ranges(ranges).transfer(curve.clone());
    let Ranges { mean: (low, high), .. } = Ranges::of_transfer(&curve);
    let pixels = curved(random, &curve, f64::from(high - low) / 63.0, count);
    let finest = scene.clone().slope_tier(SlopeTier::Pair).tier(EXACT).transfer_tier(TransferTier::FourNodes);
    let truth = Truth::Steepened(map.reference(), curve);
    Ok(Case { filter: Filter::Steepened, scene, finest: Some(finest), pixels, truth })
}
