//! Hashes of integers, by their definition.

/// Two words for a pair of words: pcg2d of Jarzynski and Olano 2020, "Hash Functions for GPU Rendering".
pub fn pair([x, y]: [u32; 2]) -> [u32; 2] {
    let (multiplier, increment) = (1_664_525u32, 1_013_904_223u32);
    let congruent = |word: u32| word.wrapping_mul(multiplier).wrapping_add(increment);
    let stir = |[x, y]: [u32; 2]| {
        let x = x.wrapping_add(y.wrapping_mul(multiplier));
        let y = y.wrapping_add(x.wrapping_mul(multiplier));
        [x, y].map(|word| word ^ word >> 16)
    };
    stir(stir([congruent(x), congruent(y)]))
}
