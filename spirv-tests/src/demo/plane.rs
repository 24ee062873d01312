//! A ground plane in perspective, up to the horizon: from pixels to texture coordinates and back to footprints.
//!
//! The camera stands one unit above the plane and looks level, so the horizon is a row of the picture. A pixel lies
//! `px` to the right of the middle and `py` below the horizon; it sees the point (px, focal)/py of the plane.

/// The camera and the texture's place on the plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane {
    /// Pixels a row.
    pub width: usize,
    /// Rows, from just below the horizon down.
    pub height: usize,
    /// Distance of the first row's center from the horizon, in pixels.
    pub first_row: f64,
    /// Distance of the picture from the eye, in pixels.
    pub focal: f64,
    /// Where the picture has been moved to, in pixels right and down.
    pub pan: [f64; 2],
    /// Texture periods a unit of the plane, along both axes of the texture.
    pub periods: [f64; 2],
    /// Turn of the texture on the plane, in radians.
    pub turn: f64,
    /// Texture coordinates of the point below the camera.
    pub origin: [f64; 2],
}

impl Plane {
    /// The place of a pixel's center: right of the middle and below the horizon.
    pub fn pixel(&self, column: usize, row: usize) -> [f64; 2] {
        let middle = 0.5 * (self.width as f64 - 1.0);
        [column as f64 - middle + self.pan[0], row as f64 + self.first_row + self.pan[1]]
    }

    /// The texture coordinates of the point that is seen `px` right of the middle and `py` > 0 below the horizon.
    pub fn position(&self, [px, py]: [f64; 2]) -> [f64; 2] {
        let [along, across] = self.turned([px / py, self.focal / py]);
        [self.origin[0] + along, self.origin[1] + across]
    }

    /// The derivatives of [`Self::position`] to the right and down.
    pub fn derivatives(&self, [px, py]: [f64; 2]) -> [[f64; 2]; 2] {
        [self.turned([1.0 / py, 0.0]), self.turned([-px / (py * py), -self.focal / (py * py)])]
    }

    /// A vector of the plane in texture coordinates.
    fn turned(&self, [x, z]: [f64; 2]) -> [f64; 2] {
        let (sine, cosine) = self.turn.sin_cos();
        [self.periods[0] * (cosine * x - sine * z), self.periods[1] * (sine * x + cosine * z)]
    }

    /// The same picture with its content moved by a part of a pixel.
    pub fn panned(self, pixels: [f64; 2]) -> Self {
        Self { pan: [self.pan[0] + pixels[0], self.pan[1] + pixels[1]], ..self }
    }

    /// The same picture through a lens of another length; the horizon stays where it is.
    pub fn zoomed(self, factor: f64) -> Self {
        Self { focal: self.focal * factor, ..self }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn derivatives_are_those_of_the_position() {
        let plane = Plane {
            width: 40,
            height: 30,
            first_row: 2.5,
            focal: 50.0,
            pan: [0.3, -0.2],
            periods: [0.7, 0.4],
            turn: 0.35,
            origin: [0.1, 0.2],
        };
        let at = plane.pixel(31, 4);
        let step = 1e-4;
        for (axis, derivative) in plane.derivatives(at).into_iter().enumerate() {
            let ends = [step, -step].map(|step| {
                let mut moved = at;
                moved[axis] += step;
                plane.position(moved)
            });
            for part in 0..2 {
                let difference = (ends[0][part] - ends[1][part]) / (2.0 * step);
                assert!((difference - derivative[part]).abs() < 1e-6, "{axis} {part}: {difference} {derivative:?}");
            }
        }
    }
}
