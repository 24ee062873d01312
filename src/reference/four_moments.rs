//! Four moments of images: raw ones, which mix linearly in f64, and central ones from them.

use super::moments::Image;
use super::quadrature::integrate;

/// Raw moments E\[f\] to E\[f⁴\].
pub type Raw = [f64; 4];

/// The raw moments of a single value.
pub fn powers(value: f64) -> Raw {
    [value, value.powi(2), value.powi(3), value.powi(4)]
}

/// The raw moments of a mixture.
pub fn mixture(parts: &[(f64, Raw)]) -> Raw {
    std::array::from_fn(|power| parts.iter().map(|(weight, raw)| weight * raw[power]).sum())
}

/// Mean and the moments E\[(f − center)^k\], k from 2 to 4, of a distribution with these raw moments.
pub fn about(raw: Raw, center: f64) -> [f64; 4] {
    let of = [1.0, raw[0], raw[1], raw[2], raw[3]];
    let moment = |k: usize| -> f64 {
        let choose = [[1.0, 2.0, 1.0, 0.0, 0.0], [1.0, 3.0, 3.0, 1.0, 0.0], [1.0, 4.0, 6.0, 4.0, 1.0]][k - 2];
        (0..=k).map(|power| choose[power] * of[power] * (-center).powi((k - power) as i32)).sum()
    };
    [raw[0], moment(2), moment(3), moment(4)]
}

/// Mean and central moments.
pub fn central(raw: Raw) -> [f64; 4] {
    about(raw, raw[0])
}

/// Raw moments from the mean and central moments.
pub fn raw([mean, second, third, fourth]: [f64; 4]) -> Raw {
    let [_, second, third, fourth] = about([0.0, second, third, fourth], -mean);
    [mean, second, third, fourth]
}

/// Mean, deviation, skewness and excess kurtosis as mean and central moments.
pub fn from_standard([mean, deviation, skewness, kurtosis]: [f64; 4]) -> [f64; 4] {
    [mean, deviation.powi(2), skewness * deviation.powi(3), (kurtosis + 3.0) * deviation.powi(4)]
}

impl Image {
    /// Raw moments of the reconstruction over the area of a texel inside the image, by quadrature.
    pub fn raw_over_texel(&self, x: usize, y: usize) -> Raw {
        let (x, y) = (x as f64, y as f64);
        // The reconstruction is one polynomial in each quarter: a panel each.
        integrate(y, y + 1.0, 0.5, |down| integrate(x, x + 1.0, 0.5, |across| powers(self.value(across, down))))
    }

    /// Mean and central moments that reading a pyramid of four moments is to give: those of the mixture that
    /// [`Image::read`] describes. `texels` are [`Self::raw_over_texel`] of all texels.
    pub fn read_four(&self, texels: &[Raw], position: [f64; 2], covariance: [f64; 3]) -> [f64; 4] {
        let mixed = central(mixture(&self.mixed_parts(texels, position, covariance, powers)));
        let wanted = (0.5 * (covariance[0] + covariance[2])).max(0.0);
        if wanted >= 1.0 {
            return mixed;
        }
        // Both have the same mean: central moments are those of the mixture of the plane's normal distribution and it.
        let texel = [position[0] * self.width as f64, position[1] * self.height as f64];
        let share = (libm::log(wanted.sqrt() / 0.25) / libm::log(4.0)).clamp(0.0, 1.0);
        let plane = self.plane(texel, covariance);
        let normal = [plane, 0.0, 3.0 * plane * plane];
        let [second, third, fourth] = [0, 1, 2].map(|k| share * mixed[k + 1] + (1.0 - share) * normal[k]);
        [mixed[0], second, third, fourth]
    }

    /// Mean and central moments that a level has at a position, its four texels mixed by their bilinear weights.
    pub fn level_four(&self, texels: &[Raw], position: [f64; 2], level: usize) -> [f64; 4] {
        if level > 0 {
            return central(mixture(&self.parts(texels, position, level, 1.0, powers)));
        }
        // Points: their values weighted, not the weighted value.
        let [x, y] = [position[0] * self.width as f64, position[1] * self.height as f64];
        let of = |power: i32| Image { values: self.values.iter().map(|value| value.powi(power)).collect(), ..*self };
        central([1, 2, 3, 4].map(|power| of(power).value(x, y)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The exponential distribution: raw moments k!, central ones 1, 2 and 9.
    #[test]
    fn central_moments_are_those_of_tables() {
        let exponential = [1.0, 2.0, 6.0, 24.0];
        assert_eq!(central(exponential), [1.0, 1.0, 2.0, 9.0]);
        assert_eq!(raw([1.0, 1.0, 2.0, 9.0]), exponential);
        assert_eq!(from_standard([1.0, 1.0, 2.0, 6.0]), central(exponential));
    }
}
