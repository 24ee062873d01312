//! Long footprints anywhere in an image.

use prefilter::reference::moments::Image;

use crate::random;

const POSITIONS: usize = 48;

/// A long footprint in texels: center, direction of the major axis, deviations.
pub struct Footprint {
    pub center: [f64; 2],
    angle: f64,
    major: f64,
    minor: f64,
}

impl Footprint {
    /// Texture coordinates and screen derivatives under which a pixel of deviation ½ covers the footprint.
    pub fn point(&self, image: &Image) -> [f32; 6] {
        let (width, height) = (image.width as f64, image.height as f64);
        let (sin, cos) = self.angle.sin_cos();
        let [across, down] = [[cos, sin], [-sin, cos]];
        let scaled =
            |axis: [f64; 2], deviation: f64| [2.0 * axis[0] * deviation / width, 2.0 * axis[1] * deviation / height];
        let ([a, b], [c, d]) = (scaled(across, self.major), scaled(down, self.minor));
        [self.center[0] / width, self.center[1] / height, a, b, c, d].map(|number| number as f32)
    }

    pub fn covariance(&self) -> [f64; 3] {
        let (sin, cos) = self.angle.sin_cos();
        let (a, b) = (self.major * self.major, self.minor * self.minor);
        [a * cos * cos + b * sin * sin, (a - b) * cos * sin, a * sin * sin + b * cos * cos]
    }
}

pub fn footprints(image: &Image, seed: u32, minor: f64, aspect: f64) -> Vec<Footprint> {
    let mut next = random(seed);
    let footprint = |_| Footprint {
        center: [next() * image.width as f64, next() * image.height as f64],
        angle: next() * std::f64::consts::PI,
        major: minor * aspect,
        minor,
    };
    (0..POSITIONS).map(footprint).collect()
}
