//! Periodic Gaussian height fields of a given spectrum.

use rustfft::num_complex::Complex;
use rustfft::FftPlanner;
use std::f64::consts::TAU;

/// What a height field is made of, as a density of variance over plane wave vectors. All are isotropic.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Spectrum {
    /// The autocorrelation exp(−r²/ℓ²), ℓ being the grain.
    Gaussian,
    /// One wavelength, 1.5 grains, within a sixth of its wave number: ripples without a direction.
    Band,
    /// k⁻⁴ from wavelengths of 4 grains down to a quarter of a grain, where a Gaussian ends it: slopes stay finite.
    Smooth,
    /// k⁻³ between the same ends.
    Rough,
}

impl Spectrum {
    /// Every spectrum.
    pub const ALL: [Self; 4] = [Self::Gaussian, Self::Band, Self::Smooth, Self::Rough];

    /// Its name in tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::Gaussian => "gaussian",
            Self::Band => "band",
            Self::Smooth => "k^-4",
            Self::Rough => "k^-3",
        }
    }

    /// The density, up to a factor, at a wave number in radians a grain.
    fn density(self, wave: f64) -> f64 {
        let power_law = |exponent: i32| {
            if wave < TAU / 4.0 {
                0.0
            } else {
                wave.powi(-exponent) * (-(wave / (4.0 * TAU)).powi(2)).exp()
            }
        };
        match self {
            Self::Gaussian => (-0.25 * wave * wave).exp(),
            Self::Band => {
                let center = TAU / 1.5;
                (-0.5 * ((wave - center) / (center / 6.0)).powi(2)).exp()
            }
            Self::Smooth => power_law(4),
            Self::Rough => power_law(3),
        }
    }
}

/// Heights on a periodic square of nodes one texel apart, row by row, with mean 0 and deviation 1.
#[derive(Clone, Debug)]
pub struct Field {
    /// Nodes a row, and rows.
    pub size: usize,
    /// The heights.
    pub heights: Vec<f64>,
}

impl Field {
    /// Two independent fields: the real and the imaginary part of a sum of waves with random phases.
    pub fn pair(spectrum: Spectrum, size: usize, grain: f64, seed: u64) -> [Self; 2] {
        let mut random = Random(seed.wrapping_mul(0xd134_2543_de82_ef95));
        let mut waves = Vec::with_capacity(size * size);
        for row in 0..size {
            for column in 0..size {
                let [y, x] = [row, column].map(|index| index.min(size - index) as f64);
                let amplitude = spectrum.density(TAU * grain / size as f64 * x.hypot(y)).sqrt();
                waves.push(Complex::from_polar(amplitude, TAU * random.uniform()));
            }
        }
        let transform = FftPlanner::new().plan_fft_forward(size);
        for _ in 0..2 {
            transform.process(&mut waves);
            transpose(&mut waves, size);
        }
        let parts: [fn(&Complex<f64>) -> f64; 2] = [|wave| wave.re, |wave| wave.im];
        parts.map(|part| Self { size, heights: standardized(waves.iter().map(part).collect()) })
    }

    /// The field whose rows are the columns of this one.
    pub fn turned(&self) -> Self {
        let mut turned = self.clone();
        transpose(&mut turned.heights, self.size);
        turned
    }

    /// The field on the lines midway between its rows, where the surface of bilinear cells is straight between nodes.
    pub fn between_rows(&self) -> Self {
        let next = self.heights.iter().cycle().skip(self.size);
        let heights = self.heights.iter().zip(next).map(|(height, next)| 0.5 * (height + next)).collect();
        Self { size: self.size, heights }
    }

    /// The heights in the middle of the segments between neighbors in a row.
    pub fn middles(&self) -> impl Iterator<Item = f64> + '_ {
        self.rows().flat_map(|row| row.iter().zip(row.iter().cycle().skip(1)).map(|(one, next)| 0.5 * (one + next)))
    }

    /// The slopes of those segments, a texel.
    pub fn slopes(&self) -> impl Iterator<Item = f64> + '_ {
        self.rows().flat_map(|row| row.iter().zip(row.iter().cycle().skip(1)).map(|(one, next)| next - one))
    }

    /// The rows.
    pub fn rows(&self) -> impl Iterator<Item = &[f64]> {
        self.heights.chunks_exact(self.size)
    }

    /// The deviation of the slopes of the segments between neighbors in a row, a texel.
    pub fn slope_deviation(&self) -> f64 {
        (self.slopes().map(|slope| slope * slope).sum::<f64>() / self.heights.len() as f64).sqrt()
    }
}

fn standardized(mut heights: Vec<f64>) -> Vec<f64> {
    let count = heights.len() as f64;
    let mean = heights.iter().sum::<f64>() / count;
    let deviation = (heights.iter().map(|height| (height - mean).powi(2)).sum::<f64>() / count).sqrt();
    heights.iter_mut().for_each(|height| *height = (*height - mean) / deviation);
    heights
}

/// Exchanges the rows and columns of a square.
pub fn transpose<T>(square: &mut [T], size: usize) {
    for row in 0..size {
        for column in 0..row {
            square.swap(row * size + column, column * size + row);
        }
    }
}

/// SplitMix64: Steele, Lea and Flood 2014, "Fast splittable pseudorandom number generators". A field draws millions of
/// numbers: with 32 bits of state the sequences of two seeds could overlap.
struct Random(u64);

impl Random {
    /// A number in [0, 1).
    fn uniform(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((mixed ^ (mixed >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }
}
