//! Moving pictures.

use super::plane::Plane;

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
