//! How a picture is framed, and how that moves: a pinhole that looks level, its pixels counted from the line of sight.

use crate::demo::motion::Motion;

/// A frame of a picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lens {
    /// Pixels a row.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// The first row's center below the horizon, in pixels.
    pub first_row: f64,
    /// Distance of the picture from the eye, in pixels.
    pub focal: f64,
    /// Where the picture has been moved to, in pixels right and down.
    pub pan: [f64; 2],
}

impl Lens {
    /// The place of the first pixel's center: right of the middle and below the horizon.
    pub fn corner(&self) -> [f64; 2] {
        [self.pan[0] - 0.5 * (self.width as f64 - 1.0), self.pan[1] + self.first_row]
    }

    /// Pixels of the picture.
    pub fn pixels(&self) -> usize {
        self.width * self.height
    }

    /// The frames of a motion.
    pub fn moving(self, motion: Motion, frames: usize) -> Vec<Self> {
        let moved = |frame| {
            let (pan, zoom) = motion.at(frame);
            Self { pan: [self.pan[0] + pan[0], self.pan[1] + pan[1]], focal: self.focal * zoom, ..self }
        };
        (0..frames).map(moved).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pictures_move_as_they_say() {
        let lens = Lens { width: 48, height: 36, first_row: 2.5, focal: 60.0, pan: [0.0; 2] };
        assert_eq!(lens.corner(), [-23.5, 2.5]);
        let pan = lens.moving(Motion::Pan, 5);
        assert!(pan[0] == lens && pan[4].corner() == [-23.0, 2.625] && pan[4].focal == 60.0);
        let zoom = lens.moving(Motion::Zoom, 3);
        assert!(zoom[0] == lens && zoom[2].corner() == lens.corner() && (zoom[2].focal - 62.424).abs() < 1e-9);
    }
}
