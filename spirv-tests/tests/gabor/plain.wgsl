// The same noise at a point: neither filtered nor with its gradient.
fn plain_noise(position: vec3f, kernels: u32, seed: u32, spectrum: gabor_spectrum) -> f32 {
    let corner = floor(position - 0.5) - 1.0;
    let within = position - corner;
    let words = gabor_kernel_words(vec3i(corner), seed);
    var sum = 0.0;
    for (var index = 0u; index < 64u; index++) {
        let offset = vec3u(index & 3u, (index >> 2u) & 3u, index >> 4u);
        let apart = within - vec3f(offset);
        let outside = apart - saturate(apart);
        if dot(outside, outside) < gabor_reach * gabor_reach {
            sum = plain_cell(sum, apart, words + offset, kernels, spectrum);
        }
    }
    return sum * (1.70185469 * inverseSqrt(f32(kernels)));
}

fn plain_cell(sum: f32, apart: vec3f, words: vec3u, kernels: u32, spectrum: gabor_spectrum) -> f32 {
    var next = words;
    var all = sum;
    for (var number = 0u; number < kernels; number++) {
        next = hash_triple(next);
        all = plain_kernel(all, apart - gabor_kernel_place(next.x), next.yz, spectrum);
    }
    return all;
}

fn plain_kernel(sum: f32, r: vec3f, words: vec2u, spectrum: gabor_spectrum) -> f32 {
    var all = sum;
    let square = dot(r, r);
    if square < gabor_reach * gabor_reach {
        let frequency = gabor_spectrum_frequency(words, spectrum);
        let turns = dot(frequency, r) + f32(words.y >> 16u) * 1.52587890625e-5;
        all += exp2(-2.90071049 * square) * cos(6.28318531 * fract(turns));
    }
    return all;
}

fn plain_value(position: vec3f, across: vec3f, along: vec3f) -> vec4f {
    let spectrum = gabor_spectrum_of(vec2f(FREQUENCY, 0.0), vec2f(0.0, 6.2831855), vec2f(-1.0, 2.0));
    return vec4f(plain_noise(position * 1.25, KERNELSu, 0u, spectrum), 0.0, 0.0, 0.0);
}

// The same with its gradient.
fn steep_noise(position: vec3f, kernels: u32, seed: u32, spectrum: gabor_spectrum) -> vec4f {
    let corner = floor(position - 0.5) - 1.0;
    let within = position - corner;
    let words = gabor_kernel_words(vec3i(corner), seed);
    var sum = vec4f();
    for (var index = 0u; index < 64u; index++) {
        let offset = vec3u(index & 3u, (index >> 2u) & 3u, index >> 4u);
        let apart = within - vec3f(offset);
        let outside = apart - saturate(apart);
        if dot(outside, outside) < gabor_reach * gabor_reach {
            sum = steep_cell(sum, apart, words + offset, kernels, spectrum);
        }
    }
    return sum * (1.70185469 * inverseSqrt(f32(kernels))) * vec4f(1.0, vec3f(-6.28318531));
}

fn steep_cell(sum: vec4f, apart: vec3f, words: vec3u, kernels: u32, spectrum: gabor_spectrum) -> vec4f {
    var next = words;
    var all = sum;
    for (var number = 0u; number < kernels; number++) {
        next = hash_triple(next);
        all = steep_kernel(all, apart - gabor_kernel_place(next.x), next.yz, spectrum);
    }
    return all;
}

fn steep_kernel(sum: vec4f, r: vec3f, words: vec2u, spectrum: gabor_spectrum) -> vec4f {
    var all = sum;
    let square = dot(r, r);
    if square < gabor_reach * gabor_reach {
        let frequency = gabor_spectrum_frequency(words, spectrum);
        let turns = dot(frequency, r) + f32(words.y >> 16u) * 1.52587890625e-5;
        let angle = 6.28318531 * fract(turns);
        let wave = exp2(-2.90071049 * square) * vec2f(cos(angle), sin(angle));
        all += vec4f(wave.x, 0.64 * wave.x * r + wave.y * frequency);
    }
    return all;
}

fn steep_value(position: vec3f, across: vec3f, along: vec3f) -> vec4f {
    let spectrum = gabor_spectrum_of(vec2f(FREQUENCY, 0.0), vec2f(0.0, 6.2831855), vec2f(-1.0, 2.0));
    return steep_noise(position * 1.25, KERNELSu, 0u, spectrum);
}

// What one turn of the loops over cells costs without the cell's kernels.
fn step(within: vec3f, words: vec3u, index: u32) -> vec3u {
    let offset = vec3u(index & 3u, (index >> 2u) & 3u, index >> 4u);
    let apart = within - vec3f(offset);
    let outside = apart - saturate(apart);
    if index < 64u && dot(outside, outside) < gabor_reach * gabor_reach {
        return words + offset;
    }
    return vec3u(index + 1u);
}

// What a kernel costs that is found too far: for a point, and for a footprint at once or in the envelope's metric.
fn far(apart: vec3f, footprint: gabor_footprint) -> bool {
    return dot(apart, apart) < footprint.farthest;
}

fn near(apart: vec3f, footprint: gabor_footprint) -> bool {
    let square = dot(apart, apart);
    let place = vec2f(dot(footprint.first, apart), dot(footprint.second, apart.xy));
    return square < footprint.farthest && max(square - dot(place, place), 0.0) < gabor_reach * gabor_reach;
}
