//! Errors of moving pictures that change from frame to frame.

use super::measure::{root_mean_square, worst};
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

/// The largest change of (result − truth) from a frame to the next, root mean square over the pixels' worst channels,
/// and the frame that it leads to.
pub fn largest_jump(shown: &[Picture], truth: &[Picture]) -> (f64, usize) {
    let change = |frame: usize| {
        let off = |frame: usize, pixel: usize, channel: usize| {
            shown[frame].pixels[pixel][channel] - truth[frame].pixels[pixel][channel]
        };
        let pixels = 0..truth[frame].pixels.len();
        let worst = pixels.map(|pixel| {
            let [now, before] = [frame, frame - 1].map(|frame| [0, 1, 2].map(|channel| off(frame, pixel, channel)));
            worst(&now, &before)
        });
        root_mean_square(&worst.collect::<Vec<_>>())
    };
    let changes = (1..truth.len()).map(|frame| (change(frame), frame));
    changes.fold((0.0, 0), |most, next| if most.0 >= next.0 || most.0.is_nan() { most } else { next })
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

    #[test]
    fn the_largest_jump_is_found_where_it_is() {
        let gray = |value: f32| Picture { width: 2, height: 1, pixels: vec![[value; 3]; 2] };
        let truth = [0.1, 0.3, 0.2, 0.4].map(gray);
        let mut shown = [0.2, 0.4, 0.35, 0.55].map(gray);
        let (jump, frame) = largest_jump(&shown, &truth);
        assert!((jump - 0.05).abs() < 1e-6 && frame == 2, "{jump} {frame}");
        shown[3].pixels[0][1] += 0.2;
        let (jump, frame) = largest_jump(&shown, &truth);
        assert!((jump - 0.2 / 2f64.sqrt()).abs() < 1e-6 && frame == 3, "{jump} {frame}");
        shown[1].pixels[1][2] = f32::NAN;
        assert!(largest_jump(&shown, &truth).0.is_nan());
    }
}
