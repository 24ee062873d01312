//! How far a picture is from the truth, and how much brute force would be as far.

use super::picture::Picture;

/// Sizes of the errors of a picture; a pixel's error is the largest difference of its channels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Deviation {
    /// Root of the mean square over the pixels.
    pub rms: f64,
    /// The error that 99 pixels in 100 stay below.
    pub percentile: f64,
    /// The largest error.
    pub maximum: f64,
}

/// The error of every pixel.
pub fn errors(picture: &Picture, truth: &Picture) -> Vec<f32> {
    picture.pixels.iter().zip(&truth.pixels).map(|(ours, theirs)| worst(ours, theirs)).collect()
}

/// The largest difference of a channel; NaN if any is.
pub fn worst(ours: &[f32; 3], theirs: &[f32; 3]) -> f32 {
    ours.iter().zip(theirs).map(|(ours, theirs)| (ours - theirs).abs()).fold(0.0, largest)
}

/// The larger of two numbers; NaN if either is.
fn largest(a: f32, b: f32) -> f32 {
    if a >= b || a.is_nan() {
        a
    } else {
        b
    }
}

/// The sizes of a picture's errors; NaN where a pixel is.
pub fn deviation(picture: &Picture, truth: &Picture) -> Deviation {
    sizes(errors(picture, truth))
}

/// The sizes of errors; NaN where one is.
pub fn sizes(mut errors: Vec<f32>) -> Deviation {
    errors.sort_by(f32::total_cmp);
    let rank = (0.99 * errors.len() as f64) as usize;
    let at = |rank: usize| errors.get(rank).map_or(f64::NAN, |&error| f64::from(error));
    Deviation { rms: root_mean_square(&errors), percentile: at(rank), maximum: at(errors.len().wrapping_sub(1)) }
}

/// Root of the mean square; NaN for nothing.
pub fn root_mean_square(values: &[f32]) -> f64 {
    (values.iter().map(|&value| f64::from(value).powi(2)).sum::<f64>() / values.len() as f64).sqrt()
}

/// Stratified samples a pixel at which brute force is as far from the truth as `rms`, from measured (samples, RMS)
/// pairs with rising samples: linear between their logarithms.
///
/// `Err` holds the last number of samples where even that many are farther.
pub fn samples_for(rms: f64, measured: &[(usize, f64)]) -> Result<f64, usize> {
    let Some(&(first, coarse)) = measured.first() else { return Err(0) };
    if rms >= coarse {
        return Ok(first as f64);
    }
    for pair in measured.windows(2) {
        let [(few, far), (many, near)] = [pair[0], pair[1]];
        if rms >= near {
            let along = (far / rms).ln() / (far / near).ln();
            return Ok(few as f64 * (many as f64 / few as f64).powf(along));
        }
    }
    Err(measured[measured.len() - 1].0)
}

/// Samples a pixel for the same RMS, or a bound where brute force was not measured that far.
pub fn samples(samples: Result<f64, usize>) -> String {
    match samples {
        Ok(count) if count <= 1.0 => "<= 1".into(),
        Ok(count) if count < 10.0 => format!("{count:.1}"),
        Ok(count) => format!("{count:.0}"),
        Err(most) => format!("> {most}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn gray(values: &[f32]) -> Picture {
        Picture { width: values.len(), height: 1, pixels: values.iter().map(|&value| [0.0, value, 0.1]).collect() }
    }

    #[test]
    fn deviations_of_known_errors() {
        let truth = gray(&[0.25; 200]);
        let mut values = vec![0.25; 200];
        values[3] = 0.75;
        values[90] = 0.125;
        let found = deviation(&gray(&values), &truth);
        assert_eq!((found.maximum, found.percentile), (0.5, 0.125));
        assert!((found.rms - (0.265625f64 / 200.0).sqrt()).abs() < 1e-9);
    }

    #[test]
    fn an_unwritten_pixel_spoils_every_figure() {
        let truth = gray(&[0.25; 4]);
        let mut picture = truth.clone();
        picture.pixels[2][0] = f32::NAN;
        let found = deviation(&picture, &truth);
        assert!(found.rms.is_nan() && found.maximum.is_nan());
    }

    #[test]
    fn samples_follow_the_slope_between_measurements() {
        let measured = [(1, 0.4), (4, 0.2), (16, 0.05)];
        assert_eq!(samples_for(0.5, &measured), Ok(1.0));
        assert!((samples_for(0.1, &measured).unwrap_or(0.0) - 8.0).abs() < 1e-9);
        assert_eq!(samples_for(0.01, &measured), Err(16));
    }
}
