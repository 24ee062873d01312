//! Errors of pixels by how much they resolve, and the figures that they make.

use crate::gap::figure::Figure;
use crate::imaging::measure::{self, Deviation};
use crate::imaging::region::Region;

/// The errors of a picture, pixel by pixel.
#[derive(Clone, Debug, Default)]
pub struct Errors {
    /// What each pixel resolves.
    pub regions: Vec<Region>,
    /// Of each method.
    pub methods: Vec<Vec<f32>>,
    /// Of brute force, by rising numbers of samples.
    pub brute: Vec<Vec<f32>>,
    /// Standard errors of the truth.
    pub truth: Vec<f32>,
}

/// Whose errors.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Of {
    /// A method's, by its number.
    Method(usize),
    /// Brute force's, by its number.
    Brute(usize),
    /// The truth's.
    Truth,
}

impl Errors {
    fn of(&self, of: Of, region: Option<Region>) -> impl Iterator<Item = f32> + '_ {
        let errors = match of {
            Of::Method(number) => &self.methods[number],
            Of::Brute(number) => &self.brute[number],
            Of::Truth => &self.truth,
        };
        let pixels = errors.iter().zip(&self.regions);
        pixels.filter(move |(_, of)| region.is_none_or(|region| region == **of)).map(|(error, _)| *error)
    }
}

/// Root mean square, what 99 pixels in 100 stay below, and the largest, over several pictures.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sizes {
    /// Root of the mean square, without the truth's variance.
    pub rms: Figure,
    /// The error that 99 pixels in 100 stay below.
    pub percentile: Figure,
    /// The largest error.
    pub maximum: Figure,
}

/// The errors' sizes over pictures from several places, with standard errors over places; in a region, or of all
/// pixels. NaN where there is none.
pub fn sizes(pictures: &[Errors], of: Of, region: Option<Region>) -> Sizes {
    let [rms, percentile, maximum] = Figure::jackknife(pictures, |some| {
        let Deviation { percentile, maximum, .. } = deviation(some, of, region);
        [rms(some, of, region), percentile, maximum]
    });
    Sizes { rms, percentile, maximum }
}

fn rms(pictures: &[&Errors], of: Of, region: Option<Region>) -> f64 {
    let square = |of: Of| {
        let errors: Vec<f32> = pictures.iter().flat_map(|picture| picture.of(of, region)).collect();
        measure::root_mean_square(&errors).powi(2)
    };
    // The truth's error is independent of the others and no fault of them.
    let truth = if of == Of::Truth { 0.0 } else { square(Of::Truth) };
    let left = square(of) - truth;
    if left < 0.0 {
        0.0
    } else {
        left.sqrt()
    }
}

fn deviation(pictures: &[&Errors], of: Of, region: Option<Region>) -> Deviation {
    measure::sizes(pictures.iter().flat_map(|picture| picture.of(of, region)).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn errors(values: &[f32]) -> Errors {
        let regions = (0..values.len()).map(|number| Region::ALL[2 * (number % 2)]).collect();
        Errors { regions, methods: vec![values.to_vec()], brute: Vec::new(), truth: vec![0.1; values.len()] }
    }

    #[test]
    fn figures_of_known_errors() {
        let pictures = [errors(&[0.3, 0.5]), errors(&[0.3, 0.7])];
        let near = sizes(&pictures, Of::Method(0), Some(Region::Near));
        assert!((near.rms.value - 0.08f64.sqrt()).abs() < 1e-7 && near.rms.error < 1e-9, "{near:?}");
        let far = sizes(&pictures, Of::Method(0), Some(Region::Far));
        assert!((far.rms.value - 0.36f64.sqrt()).abs() < 1e-7 && far.rms.error > 0.05, "{far:?}");
        // Without the second picture it is 0.5, without the first 0.7.
        assert!((far.maximum.value - 0.7).abs() < 1e-7 && (far.maximum.error - 0.1).abs() < 1e-7, "{far:?}");
        assert!(sizes(&pictures, Of::Method(0), Some(Region::Between)).rms.value.is_nan());
        assert!((sizes(&pictures, Of::Truth, None).rms.value - 0.1).abs() < 1e-7);
    }

    #[test]
    fn an_unwritten_pixel_spoils_every_figure() {
        let pictures = [errors(&[0.3, f32::NAN]), errors(&[0.3, 0.7])];
        let all = sizes(&pictures, Of::Method(0), None);
        assert!(all.rms.value.is_nan() && all.maximum.value.is_nan());
    }
}
