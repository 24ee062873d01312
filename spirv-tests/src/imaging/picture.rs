//! Pictures of linear colors, and how they are shown.

/// Linear colors, row by row from the top.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// Pixels a row.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// The colors.
    pub pixels: Vec<[f32; 3]>,
}

impl Picture {
    /// A picture whose every pixel is NaN, so that a pixel that nobody wrote shows in every figure.
    pub fn new(width: usize, height: usize) -> Self {
        Self { width, height, pixels: vec![[f32::NAN; 3]; width * height] }
    }

    /// The mean of two pictures of one size.
    pub fn mean(&self, other: &Self) -> Self {
        let pixels = self.pixels.iter().zip(&other.pixels);
        let pixels = pixels.map(|(a, b)| std::array::from_fn(|channel| 0.5 * (a[channel] + b[channel]))).collect();
        Self { pixels, ..*self }
    }

    /// The picture with every pixel as a square of several a side.
    pub fn enlarged(&self, times: usize) -> Self {
        let pixels = enlarged(&self.pixels, self.width, times);
        Self { width: self.width * times, height: self.height * times, pixels }
    }

    /// The picture in 8-bit sRGB (IEC 61966-2-1), three bytes a pixel.
    pub fn encoded(&self) -> Vec<[u8; 3]> {
        self.pixels.iter().map(|pixel| pixel.map(encode)).collect()
    }
}

/// Rows of `width` pixels each, with every pixel as a square of several a side.
pub fn enlarged<T: Copy>(pixels: &[T], width: usize, times: usize) -> Vec<T> {
    let wide = |row: &[T]| row.iter().flat_map(|&pixel| std::iter::repeat_n(pixel, times)).collect::<Vec<T>>();
    pixels.chunks(width.max(1)).flat_map(|row| wide(row).repeat(times)).collect()
}

/// The byte that shows a linear value.
fn encode(linear: f32) -> u8 {
    let value = linear.clamp(0.0, 1.0);
    let encoded = if value <= 0.003_130_8 { 12.92 * value } else { 1.055 * value.powf(1.0 / 2.4) - 0.055 };
    (255.0 * encoded + 0.5) as u8
}

/// Colors of an error map from no error to the largest shown: the `inferno` map of matplotlib (CC0) at nine places.
const ERROR_SCALE: [[u8; 3]; 9] = [
    [0, 0, 4],
    [31, 12, 72],
    [85, 15, 109],
    [136, 34, 106],
    [186, 54, 85],
    [227, 89, 51],
    [249, 140, 10],
    [249, 201, 50],
    [252, 255, 164],
];

/// The color that shows an error, as a fraction of the largest error shown. NaN is shown as green.
pub fn error_color(fraction: f32) -> [u8; 3] {
    if fraction.is_nan() {
        return [0, 255, 0];
    }
    let place = fraction.clamp(0.0, 1.0) * (ERROR_SCALE.len() - 1) as f32;
    let below = (place as usize).min(ERROR_SCALE.len() - 2);
    let along = place - below as f32;
    std::array::from_fn(|channel| {
        let (from, to) = (ERROR_SCALE[below][channel], ERROR_SCALE[below + 1][channel]);
        (f32::from(from) + along * (f32::from(to) - f32::from(from)) + 0.5) as u8
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn encoding_is_that_of_srgb() {
        // Half of the light is byte 188 (187.5 before rounding), a fifth of the bytes' range is 3.3 % of the light.
        assert_eq!([0.0, 0.5, 1.0, 2.0, -1.0].map(encode), [0, 188, 255, 255, 0]);
        assert_eq!(encode(0.0331), 51);
    }

    #[test]
    fn enlarged_pixels_are_squares() {
        assert_eq!(enlarged(&[1, 2, 3, 4], 2, 2), [1, 1, 2, 2, 1, 1, 2, 2, 3, 3, 4, 4, 3, 3, 4, 4]);
        let picture = Picture { width: 1, height: 2, pixels: vec![[0.1; 3], [0.2; 3]] }.enlarged(3);
        assert_eq!((picture.width, picture.height, picture.pixels.len()), (3, 6, 18));
    }

    #[test]
    fn the_error_scale_runs_from_dark_to_bright() {
        let brightness = |fraction: f32| error_color(fraction).map(u32::from).iter().sum::<u32>();
        let steps: Vec<u32> = (0..=16).map(|step| brightness(step as f32 / 16.0)).collect();
        assert!(steps.windows(2).all(|pair| pair[0] < pair[1]), "{steps:?}");
        assert_eq!(error_color(2.0), error_color(1.0));
        assert_eq!(error_color(f32::NAN), [0, 255, 0]);
    }
}
