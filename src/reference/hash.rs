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

/// Three words for three words: pcg3d of Jarzynski and Olano 2020, "Hash Functions for GPU Rendering".
pub fn triple(words: [u32; 3]) -> [u32; 3] {
    let stir = |[x, y, z]: [u32; 3]| {
        let x = y.wrapping_mul(z).wrapping_add(x);
        let y = z.wrapping_mul(x).wrapping_add(y);
        [x, y, x.wrapping_mul(y).wrapping_add(z)]
    };
    let congruent = words.map(|word| word.wrapping_mul(1_664_525).wrapping_add(1_013_904_223));
    stir(stir(congruent).map(|word| word ^ word >> 16))
}
