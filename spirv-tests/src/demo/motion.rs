//! Moving pictures: what shimmers is the error that changes from frame to frame.

use super::plane::Plane;
use crate::imaging::picture::Picture;

/// A way to move.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Motion {
    /// The picture's content moves right and a little down, an eighth of a pixel a frame.
    Pan,
    /// The lens grows longer, two percent a frame.
    Zoom,
}

impl Motion {
    /// All of them.
    pub const ALL: [Self; 2] = [Self::Pan, Self::Zoom];

    /// The name in tables.
    pub fn label(self) -> &'static str {
        match self {
            Self::Pan => "pan",
            Self::Zoom => "zoom",
        }
    }

    /// How far a frame's content has moved, in pixels right and down, and how much longer its lens is.
    pub fn at(self, frame: usize) -> ([f64; 2], f64) {
        match self {
            Self::Pan => ([frame as f64 / 8.0, frame as f64 / 32.0], 1.0),
            Self::Zoom => ([0.0; 2], 1.02f64.powi(frame as i32)),
        }
    }

    /// The planes that the frames show.
    pub fn planes(self, plane: Plane, frames: usize) -> Vec<Plane> {
        let moved = |frame| {
            let (pan, zoom) = self.at(frame);
            plane.panned(pan).zoomed(zoom)
        };
        (0..frames).map(moved).collect()
    }
}

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
