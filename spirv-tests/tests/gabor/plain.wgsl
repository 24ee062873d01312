// The same noise at a point: neither filtered nor with its gradient.
fn plain_noise(position: vec3f, kernels: u32, seed: u32, spectrum: gabor_spectrum) -> f32 {
    let corner = floor(position - 0.5) - 1.0;
    let reach = gabor_reach * gabor_reach;
    var sum = 0.0;
    for (var index = 0u; index < 64u; index++) {
        let offset = vec3u(index & 3u, index >> 2u & 3u, index >> 4u);
        let apart = position - corner - vec3f(offset);
        let outside = max(max(apart - 1.0, -apart), vec3f());
        if dot(outside, outside) < reach {
            sum += plain_cell(apart, gabor_kernel_words(vec3i(corner), offset, seed), kernels, spectrum);
        }
    }
    return sum * 1.70185469 * inverseSqrt(f32(kernels));
}

// What one turn of that loop costs without the cell's kernels.
fn plain_step(position: vec3f, corner: vec3f, index: u32, seed: u32) -> vec3u {
    let offset = vec3u(index & 3u, index >> 2u & 3u, index >> 4u);
    let apart = position - corner - vec3f(offset);
    let outside = max(max(apart - 1.0, -apart), vec3f());
    if index < 64u && dot(outside, outside) < gabor_reach * gabor_reach {
        return gabor_kernel_words(vec3i(corner), offset, seed);
    }
    return vec3u(index + 1u);
}

fn plain_cell(apart: vec3f, words: vec3u, kernels: u32, spectrum: gabor_spectrum) -> f32 {
    var next = words;
    var sum = 0.0;
    for (var kernel = 0u; kernel < kernels; kernel++) {
        next = hash_triple(next);
        sum += plain_kernel(apart - gabor_kernel_place(next.x), next.yz, spectrum);
    }
    return sum;
}

fn plain_kernel(r: vec3f, words: vec2u, spectrum: gabor_spectrum) -> f32 {
    let distance = dot(r, r);
    if distance >= gabor_reach * gabor_reach {
        return 0.0;
    }
    let frequency = gabor_spectrum_frequency(words, spectrum);
    let turns = dot(frequency, r) + f32(words.y >> 16u) * 1.52587890625e-5;
    return exp2(-2.90071049 * distance) * cos(6.28318531 * (turns - floor(turns)));
}

// What a kernel beyond its reach costs: up to there.
fn plain_passed(r: vec3f) -> bool {
    return dot(r, r) >= gabor_reach * gabor_reach;
}

fn filtered_passed(apart: vec3f, footprint: gabor_footprint) -> bool {
    return dot(apart, apart) >= footprint.farthest;
}

// What one costs that is near, but not in the metric of the envelope.
fn filtered_near(apart: vec3f, footprint: gabor_footprint) -> bool {
    let square = dot(apart, apart);
    let place = vec2f(dot(footprint.first, apart), dot(footprint.second, apart));
    return square < footprint.farthest && max(square - dot(place, place), 0.0) >= gabor_reach * gabor_reach;
}

fn plain_value(position: vec3f, across: vec3f, along: vec3f) -> vec4f {
    let spectrum = gabor_spectrum(vec2f(FREQUENCY, 0.0), vec2f(0.0, 6.2831855), vec2f(-1.0, 2.0));
    return vec4f(plain_noise(position * 1.25, KERNELSu, 0u, spectrum), 0.0, 0.0, 0.0);
}

// The same with its gradient.
fn steep_noise(position: vec3f, kernels: u32, seed: u32, spectrum: gabor_spectrum) -> vec4f {
    let corner = floor(position - 0.5) - 1.0;
    let reach = gabor_reach * gabor_reach;
    var sum = vec4f();
    for (var index = 0u; index < 64u; index++) {
        let offset = vec3u(index & 3u, index >> 2u & 3u, index >> 4u);
        let apart = position - corner - vec3f(offset);
        let outside = max(max(apart - 1.0, -apart), vec3f());
        if dot(outside, outside) < reach {
            sum += steep_cell(apart, gabor_kernel_words(vec3i(corner), offset, seed), kernels, spectrum);
        }
    }
    return sum * 1.70185469 * inverseSqrt(f32(kernels)) * vec4f(1.0, vec3f(-6.28318531));
}

fn steep_cell(apart: vec3f, words: vec3u, kernels: u32, spectrum: gabor_spectrum) -> vec4f {
    var next = words;
    var sum = vec4f();
    for (var kernel = 0u; kernel < kernels; kernel++) {
        next = hash_triple(next);
        sum += steep_kernel(apart - gabor_kernel_place(next.x), next.yz, spectrum);
    }
    return sum;
}

fn steep_kernel(r: vec3f, words: vec2u, spectrum: gabor_spectrum) -> vec4f {
    let distance = dot(r, r);
    if distance >= gabor_reach * gabor_reach {
        return vec4f();
    }
    let frequency = gabor_spectrum_frequency(words, spectrum);
    let turns = dot(frequency, r) + f32(words.y >> 16u) * 1.52587890625e-5;
    let angle = 6.28318531 * (turns - floor(turns));
    let wave = exp2(-2.90071049 * distance) * vec2f(cos(angle), sin(angle));
    return vec4f(wave.x, 0.64 * wave.x * r + wave.y * frequency);
}

fn steep_value(position: vec3f, across: vec3f, along: vec3f) -> vec4f {
    let spectrum = gabor_spectrum(vec2f(FREQUENCY, 0.0), vec2f(0.0, 6.2831855), vec2f(-1.0, 2.0));
    return steep_noise(position * 1.25, KERNELSu, 0u, spectrum);
}
