//! Sums of octaves of noise, by their definition.

/// The octaves of a noise in the plane, by their lattices.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Octaves {
    /// How many.
    pub count: u32,
    /// Of an octave's amplitude over that of the one before.
    pub gain: f64,
    /// Of an octave's frequency over that of the one before.
    pub lacunarity: f64,
    /// How far an octave is turned against the one before, in radians.
    pub rotation: f64,
    /// Where an octave has the origin of the one before.
    pub offset: [f64; 2],
}

impl Octaves {
    /// The sum over octaves of a noise of a position and of the octave's number, the first of amplitude 1.
    pub fn sum(&self, position: [f64; 2], noise: impl Fn([f64; 2], u32) -> f64) -> f64 {
        let (sin, cos) = libm::sincos(self.rotation);
        let turned = |[x, y]: [f64; 2]| [cos * x - sin * y, sin * x + cos * y];
        let next = |at: [f64; 2]| {
            let at = turned(at);
            [0, 1].map(|axis| self.lacunarity * at[axis] + self.offset[axis])
        };
        let (mut at, mut sum) = (position, 0.0);
        for octave in 0..self.count {
            sum += self.gain.powi(octave as i32) * noise(at, octave);
            at = next(at);
        }
        sum
    }

    /// The variance of the sum over that of one octave of amplitude 1.
    pub fn power(&self) -> f64 {
        (0..self.count).map(|octave| self.gain.powi(2 * octave as i32)).sum()
    }
}
