//! The tabulated driver: its pyramids against the images, the shelf on a device against the images, and question 3: how
//! far the color over a footprint is from the integral over the image's reconstruction, for 1, 2, 4 and 8 taps.

mod colors;
mod curvature;
mod device;
mod footprints;
mod indicators;
mod pairs;
mod passes;
mod pyramids;
mod quotients;
mod references;
mod roughness;
mod slope_colors;
mod slope_reads;
mod slopes;
mod tiling;
mod toksvig;

use prefilter::reference::moments::{Beyond, Image};
use spirv_tests::random::Random;

/// Values between 0 and 1 from a seed.
fn random(seed: u32) -> impl FnMut() -> f64 {
    let mut random = Random::new(seed);
    move || random.unit()
}

/// The numbers of the last row of a driver's documentation that begins with a label.
fn documented(file: &str, label: &str) -> Vec<f64> {
    let row = file.lines().rev().find_map(|line| line.strip_prefix(&format!("/// | {label} |"))).expect(label);
    row.split('|').filter_map(|number| number.trim().parse().ok()).collect()
}

/// An image of the examples, stretched to [0, 1].
fn photograph(name: &str, beyond: Beyond) -> (Image, Vec<f32>) {
    let path = format!("{}/../examples/data/{name}", env!("CARGO_MANIFEST_DIR"));
    let gray = image::open(path).unwrap().into_luma16();
    let (width, height) = (gray.width() as usize, gray.height() as usize);
    let raw: Vec<f64> = gray.into_raw().into_iter().map(f64::from).collect();
    let low = raw.iter().copied().fold(f64::MAX, f64::min);
    let high = raw.iter().copied().fold(f64::MIN, f64::max);
    let stored: Vec<f32> = raw.iter().map(|value| ((value - low) / (high - low)) as f32).collect();
    let values = stored.iter().map(|&value| f64::from(value)).collect();
    (Image { width, height, values, beyond }, stored)
}

/// Positions in [−1, 2] with round footprints of deviations from 1/32 to 64 texels.
fn points(count: usize) -> Vec<Vec<f64>> {
    let mut next = random(7);
    let point = |_| {
        let variance = 4f64.powf(-5.0 + 11.0 * next());
        let numbers = [3.0 * next() - 1.0, 3.0 * next() - 1.0, variance, 0.0, variance];
        numbers.map(|number| f64::from(number as f32)).to_vec()
    };
    (0..count).map(point).collect()
}
