//! A few rays that stand for a pixel: equal parts of its filter, each with a footprint of its own.

use super::pixel::PIXEL_DEVIATION;

/// Taps an axis of a pixel.
const TAPS: usize = 2;

/// Taps of a pixel.
pub const ALL_TAPS: usize = TAPS * TAPS;

/// Where the taps are, in deviations of the pixel filter: the means of equally probable parts of a normal distribution.
const OFFSETS: [f64; TAPS] = [-0.797_884_561, 0.797_884_561]; // √(2/π)

/// Deviation of such a part in pixels: with the offsets' it makes up the filter's.
pub const TAP_DEVIATION: f64 = PIXEL_DEVIATION * 0.602_810_275; // √(1 − 2/π)

/// The places of the taps about the middle of a pixel, in pixels.
pub fn places([right, down]: [f64; 2]) -> [[f64; 2]; ALL_TAPS] {
    std::array::from_fn(|tap| {
        let [across, under] = [OFFSETS[tap % TAPS], OFFSETS[tap / TAPS]];
        [right + PIXEL_DEVIATION * across, down + PIXEL_DEVIATION * under]
    })
}
