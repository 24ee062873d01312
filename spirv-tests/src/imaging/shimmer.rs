//! Errors of moving pictures that change from frame to frame.

use super::picture::Picture;

/// Shimmer: the deviation over time of (result − truth) in the worst channel of each pixel, root mean square over the
/// pixels. A method that is wrong by the same amount in every frame does not shimmer.
pub fn shimmer(shown: &[Picture], truth: &[Picture]) -> f64 {
    let pixels = truth.first().map_or(0, |picture| picture.pixels.len());
    let count = truth.len() as f64;
    let worst = (0..pixels).map(|pixel| {
        let channel = |channel: usize| {
            let difference = |(ours, theirs): (&Picture, &Picture)| {
                f64::from(ours.pixels[pixel][channel]) - f64::from(theirs.pixels[pixel][channel])
            };
            let differences: Vec<f64> = shown.iter().zip(truth).map(difference).collect();
            let mean = differences.iter().sum::<f64>() / count;
            differences.iter().map(|difference| (difference - mean).powi(2)).sum::<f64>() / count
        };
        let variances = [channel(0), channel(1), channel(2)];
        // `max` would drop a NaN.
        if variances.iter().any(|variance| variance.is_nan()) {
            f64::NAN
        } else {
            variances.into_iter().fold(0.0, f64::max)
        }
    });
    (worst.sum::<f64>() / pixels as f64).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_constant_error_does_not_shimmer_and_an_alternating_one_does() {
        let gray = |value: f32| Picture { width: 2, height: 1, pixels: vec![[value; 3]; 2] };
        let truth = [0.1, 0.3, 0.2, 0.4].map(gray);
        let constant = [0.2, 0.4, 0.3, 0.5].map(gray);
        let mut flicker = constant.clone();
        flicker[1].pixels[0][2] -= 0.2;
        flicker[3].pixels[0][2] -= 0.2;
        assert!(shimmer(&constant, &truth) < 1e-7);
        // Deviation 0.1 in one of two pixels.
        assert!((shimmer(&flicker, &truth) - 0.1 / 2f64.sqrt()).abs() < 1e-6);
        flicker[0].pixels[1][0] = f32::NAN;
        assert!(shimmer(&flicker, &truth).is_nan());
    }
}
