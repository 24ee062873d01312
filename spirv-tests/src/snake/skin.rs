//! The skin: scales as a map of heights, and the values of the pattern on them. Both are square, wrap the body once
//! around and repeat along it.

use super::body::AROUND;
use crate::demo::heights::{Address, Heights};
use crate::random::Random;
use std::f64::consts::TAU;

/// Texels a side of both maps; x is along the body.
pub const SIDE: usize = AROUND;

/// Rows of scales along the map, each shifted by half a scale against the next, and scales around the body.
const ROWS: usize = 20;
const SCALES: usize = 24;

/// How steep a scale is at its edge, and the deviation of how scales are tilted.
const STEEPEST: f64 = 0.85;
const TILT: f64 = 0.14;
/// How far scales rise toward the tail, where each lies on the next.
const RISE: f64 = 0.12;
/// Deviation of the slopes of wrinkles on the scales.
const WRINKLES: f64 = 0.12;

/// A skin.
#[derive(Clone, Debug)]
pub struct Skin {
    /// Heights in radii of the body, 0 on average.
    pub heights: Vec<f32>,
    /// The pattern's values, about 0 to 1.
    pub pattern: Heights,
}

/// Waves of random directions and phases that repeat over the map.
struct Waves(Vec<([f64; 2], f64)>);

impl Waves {
    /// `count` waves, each of which repeats from `few` to `many` times over the map.
    fn new(random: &mut Random, count: usize, few: f64, many: f64) -> Self {
        let wave = |_| {
            let (times, turn) = (random.between(few, many), TAU * random.unit());
            ([times * turn.cos(), times * turn.sin()].map(f64::round), TAU * random.unit())
        };
        Self((0..count).map(wave).collect())
    }

    /// A sum of deviation 1 at a place in parts of the map.
    fn value(&self, place: [f64; 2]) -> f64 {
        let wave = |(times, phase): &([f64; 2], f64)| (TAU * (times[0] * place[0] + times[1] * place[1]) + phase).cos();
        self.0.iter().map(wave).sum::<f64>() * (2.0 / self.0.len() as f64).sqrt()
    }

    /// Deviation of the slopes, in parts of the map.
    fn steepness(&self) -> f64 {
        let squares = self.0.iter().map(|(times, _)| times.iter().map(|part| part * part).sum::<f64>());
        TAU * (0.5 * squares.sum::<f64>() / self.0.len() as f64).sqrt()
    }
}

/// A scale: its middle in texels, its tilt and its share in the pattern.
struct Scale {
    middle: [f64; 2],
    tilt: [f64; 2],
    tone: f64,
}

impl Skin {
    /// The skin of a seed.
    pub fn new(seed: u32) -> Self {
        let mut random = Random::new(seed);
        let scales = scales(&mut random);
        let wrinkles = Waves::new(&mut random, 40, 25.0, 60.0);
        let (blots, grain) = (Waves::new(&mut random, 9, 2.0, 5.0), Waves::new(&mut random, 40, 30.0, 90.0));
        let (mut heights, mut pattern) = (Vec::new(), Vec::new());
        let size = WRINKLES * SIDE as f64 / wrinkles.steepness();
        for texel in 0..SIDE * SIDE {
            let at = [(texel % SIDE) as f64 + 0.5, (texel / SIDE) as f64 + 0.5];
            let place = at.map(|part| part / SIDE as f64);
            let (height, tone) = top(&scales, at);
            heights.push(height + size * wrinkles.value(place));
            // Saddles along the back, twice a map, and blots.
            let saddle = (TAU * 2.0 * place[0]).cos() * (TAU * place[1]).cos();
            let value = 0.5 + 0.13 * saddle + 0.07 * blots.value(place) + 0.07 * tone + 0.04 * grain.value(place);
            pattern.push(value as f32);
        }
        let mean = heights.iter().sum::<f64>() / heights.len() as f64;
        let heights = heights.into_iter().map(|height| ((height - mean) * TAU / SIDE as f64) as f32).collect();
        let pattern = Heights { width: SIDE, height: SIDE, texels: pattern, address: Address::Repeat };
        Self { heights, pattern }
    }
}

fn scales(random: &mut Random) -> Vec<Scale> {
    let spacing = [SIDE as f64 / ROWS as f64, SIDE as f64 / SCALES as f64];
    let mut even = || 3f64.sqrt() * (2.0 * random.unit() - 1.0);
    let scale = |number: usize| {
        let (row, scale) = (number / SCALES, number % SCALES);
        let shift = 0.5 * (row % 2) as f64;
        let middle =
            [(row as f64 + 0.5) * spacing[0] + 0.5 * even(), (scale as f64 + shift) * spacing[1] + 0.5 * even()];
        Scale { middle, tilt: [TILT * even() - RISE, TILT * even()], tone: even() }
    };
    (0..ROWS * SCALES).map(scale).collect()
}

/// Height in texels of the topmost scale, and its tone.
fn top(scales: &[Scale], at: [f64; 2]) -> (f64, f64) {
    // Of a scale's half: rows are twice as long as they are apart.
    let half = [0.62 * SIDE as f64 / ROWS as f64, 0.6 * SIDE as f64 / SCALES as f64];
    let side = SIDE as f64;
    let around = |part: f64| part - side * (part / side).round();
    let over = scales.iter().filter_map(|scale| {
        let [x, y] = [0, 1].map(|axis| around(at[axis] - scale.middle[axis]));
        let squares = x * x / half[0] + y * y / half[1];
        (x.abs() < 3.0 * half[0] && y.abs() < 3.0 * half[1])
            .then(|| (scale.tilt[0] * x + scale.tilt[1] * y - 0.5 * STEEPEST * squares, scale.tone))
    });
    over.fold((f64::NEG_INFINITY, 0.0), |most, next| if next.0 > most.0 { next } else { most })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Deviations of what the demo blends, and no seam where the maps repeat.
    #[test]
    fn skins_have_slopes_and_values_and_no_seam() {
        let skin = Skin::new(1);
        let texel = TAU / SIDE as f64;
        let height = |x: usize, y: usize| f64::from(skin.heights[y % SIDE * SIDE + x % SIDE]);
        let rms = |values: &mut dyn Iterator<Item = f64>| {
            let (sum, count) = values.fold((0.0, 0.0), |(sum, count), value| (sum + value * value, count + 1.0));
            f64::sqrt(sum / count)
        };
        let all = || (0..SIDE * SIDE).map(|texel| (texel % SIDE, texel / SIDE));
        let along = |(x, y): (usize, usize)| (height(x + 1, y) - height(x, y)) / texel;
        let around = |(x, y): (usize, usize)| (height(x, y + 1) - height(x, y)) / texel;
        let deviations = [rms(&mut all().map(along)), rms(&mut all().map(around))];
        println!("deviations of slopes along and around: {deviations:.3?}");
        assert!(deviations.iter().all(|deviation| (0.3..0.6).contains(deviation)), "{deviations:?}");
        let seam = rms(&mut (0..SIDE).map(|y| along((SIDE - 1, y))));
        assert!(seam < 1.5 * deviations[0], "{seam} across the seam");
        let mean = skin.heights.iter().map(|&height| f64::from(height)).sum::<f64>() / skin.heights.len() as f64;
        assert!(mean.abs() < 1e-6, "{mean}");
        let values = || skin.pattern.texels.iter().map(|&value| f64::from(value) - 0.5);
        let deviation = rms(&mut values());
        assert!((0.08..0.2).contains(&deviation), "{deviation}");
        assert!(values().all(|value| value.abs() < 0.75));
        assert_ne!(skin.heights, Skin::new(2).heights);
    }
}
