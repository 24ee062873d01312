//! Random numbers that are the same on every machine: tests plant no surprise that another run cannot repeat.

/// PCG's output function over a 32-bit linear congruential generator.
///
/// Source: O'Neill 2014, "PCG: A Family of Simple Fast Space-Efficient Statistically Good Algorithms for Random Number
/// Generation", RXS-M-XS.
#[derive(Clone, Debug)]
pub struct Random(u32);

impl Random {
    /// The sequence of a seed.
    pub fn new(seed: u32) -> Self {
        Self(seed)
    }

    /// 32 random bits.
    pub fn word(&mut self) -> u32 {
        self.0 = self.0.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
        let word = ((self.0 >> ((self.0 >> 28) + 4)) ^ self.0).wrapping_mul(277_803_737);
        (word >> 22) ^ word
    }

    /// A number in [0, 1) of 24 bits, which f32 holds exactly.
    pub fn unit(&mut self) -> f64 {
        f64::from(self.word() >> 8) / 16_777_216.0
    }

    /// One of the values.
    ///
    /// # Panics
    /// Where there is none.
    pub fn pick<T: Copy, const N: usize>(&mut self, of: [T; N]) -> T {
        of[self.word() as usize % N]
    }

    /// A number between two positive ones, evenly in its logarithm.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low * (high / low).powf(self.unit())
    }
}
