//! Light from an environment on a diffuse surface: its irradiance by the surface's normal.

use super::color_map::MAX_COLOR;
use crate::Error;

/// The irradiance that an environment gives a plane, as a polynomial of order 2 in the plane's unit normal.
///
/// Diffuse surfaces blur an environment so much that order 2 holds its irradiance to 1 % on average over the sphere
/// (Ramamoorthi and Hanrahan 2001, "An Efficient Representation for Irradiance Environment Maps").
///
/// ```
/// use prefilter::Irradiance;
/// // A sky of radiance 1 from all around: irradiance π, whatever the normal.
/// let sky = Irradiance::from_equirectangular(64, 32, &[[1.0; 3]; 64 * 32])?;
/// assert!((sky.value([0.6, 0.0, 0.8])[0] - std::f32::consts::PI).abs() < 5e-3);
/// # Ok::<(), prefilter::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(into = "super::serial::Terms", try_from = "super::serial::Terms"))]
pub struct Irradiance {
    /// Colors of 1, x, y, z, x², x y, y², x z and y z; z² is 1 less the other squares.
    pub(super) polynomial: [[f32; 3]; 9],
}

impl Irradiance {
    /// From the radiance's coefficients of the real spherical harmonics: by order, in each from the lowest degree, as
    /// L₀₀, L₁₋₁ (y), L₁₀ (z), L₁₁ (x), L₂₋₂ (x y), L₂₋₁ (y z), L₂₀ (3 z² − 1), L₂₁ (x z), L₂₂ (x² − y²).
    ///
    /// Orders are scaled by π, 2π/3 and π/4 (Ramamoorthi and Hanrahan 2001, equation 8).
    ///
    /// # Errors
    /// A coefficient beyond ±65504.
    pub fn from_harmonics(radiance: [[f32; 3]; 9]) -> Result<Self, Error> {
        for (term, color) in radiance.iter().enumerate() {
            if let Some(value) = color.iter().find(|value| !(value.abs() <= MAX_COLOR)) {
                let what = format!("the coefficient {term} of the radiance");
                return Err(Error::value(what, *value, "a number from -65504 to 65504"));
            }
        }
        Ok(Self::of(radiance))
    }

    /// The irradiance of these coefficients, whatever they are.
    fn of(radiance: [[f32; 3]; 9]) -> Self {
        let mut polynomial = [[0.0; 3]; 9];
        for channel in 0..3 {
            let l = radiance.map(|color| f64::from(color[channel]));
            let [zero, one, two, flat] = factors();
            let [a, b, c] = [1.0, 2.0 / 3.0, 0.25].map(|scale| scale * std::f64::consts::PI);
            let (even, odd) = (c * flat * l[6], 0.5 * c * two * l[8]);
            let terms = [
                a * zero * l[0] + 2.0 * even,
                b * one * l[3],
                b * one * l[1],
                b * one * l[2],
                odd - 3.0 * even,
                c * two * l[4],
                -odd - 3.0 * even,
                c * two * l[7],
                c * two * l[5],
            ];
            for (color, term) in polynomial.iter_mut().zip(terms) {
                color[channel] = term as f32;
            }
        }
        Self { polynomial }
    }

    /// From an image of the radiance all around: rows from the zenith, +z, to the nadir, columns around from +x by +y.
    ///
    /// Each texel counts by its solid angle, at its center.
    ///
    /// # Errors
    /// A size other than the number of texels, and radiances below 0 or beyond 65504.
    pub fn from_equirectangular(width: usize, height: usize, texels: &[[f32; 3]]) -> Result<Self, Error> {
        if width == 0 || height == 0 || width.checked_mul(height) != Some(texels.len()) {
            let allowed = format!("{width} times {height}, both above 0");
            return Err(Error::Size { what: "the number of texels".to_owned(), count: texels.len(), allowed });
        }
        let mut sums = [[0.0f64; 3]; 9];
        for (at, texel) in texels.iter().enumerate() {
            let (column, row) = (at % width, at / width);
            if let Some(value) = texel.iter().find(|value| !(0.0..=MAX_COLOR).contains(*value)) {
                let what = format!("the radiance at column {column} of row {row}");
                return Err(Error::value(what, *value, "a number from 0 to 65504"));
            }
            // Exact over the band of a row: the height of a slice of the sphere is its share.
            let [above, below] = [row, row + 1].map(|edge| (edge as f64 / height as f64 * std::f64::consts::PI).cos());
            let solid_angle = (above - below) * std::f64::consts::TAU / width as f64;
            let polar = (row as f64 + 0.5) / height as f64 * std::f64::consts::PI;
            let azimuth = (column as f64 + 0.5) / width as f64 * std::f64::consts::TAU;
            let direction = [polar.sin() * azimuth.cos(), polar.sin() * azimuth.sin(), polar.cos()];
            for (sum, harmonic) in sums.iter_mut().zip(harmonics(direction)) {
                for (total, value) in sum.iter_mut().zip(texel) {
                    *total += solid_angle * harmonic * f64::from(*value);
                }
            }
        }
        // The first coefficient is up to √4π times the largest radiance.
        Ok(Self::of(sums.map(|color| color.map(|value| value as f32))))
    }

    /// The irradiance on a plane with this unit normal, not below 0.
    pub fn value(&self, [x, y, z]: [f32; 3]) -> [f32; 3] {
        let terms = [1.0, x, y, z, x * x, x * y, y * y, x * z, y * z];
        let sum = |channel: usize| self.polynomial.iter().zip(terms).map(move |(color, term)| term * color[channel]);
        [0, 1, 2].map(|channel| sum(channel).sum::<f32>().max(0.0))
    }

    /// Colors of 1, x, y, z, x², x y, y², x z and y z, z² being 1 less the other squares.
    pub fn polynomial(&self) -> &[[f32; 3]; 9] {
        &self.polynomial
    }
}

/// Y₀₀, then what stands before y, z and x in order 1, before x y and its like in order 2, and before 3 z² − 1.
fn factors() -> [f64; 4] {
    [0.25, 0.75, 3.75, 0.3125].map(|square: f64| (square / std::f64::consts::PI).sqrt())
}

fn harmonics([x, y, z]: [f64; 3]) -> [f64; 9] {
    let [zero, one, two, flat] = factors();
    let last = 0.5 * two * (x * x - y * y);
    [zero, one * y, one * z, one * x, two * x * y, two * y * z, flat * (3.0 * z * z - 1.0), two * x * z, last]
}
