// Solid Gabor noise by its definition (Lagae and Drettakis 2011, "Filtering Solid Gabor Noise", section 3): Gaussians
// times waves at random places in space. Where they are and which waves they have is the shelf's.

const noise_mean = 0.5;
const noise_deviation = 0.18;
// Sizes of the smallest and of the largest features: half a wave and a wave.
const noise_features = vec2f(0.3125, 0.625);

// Waves a unit.
const frequency = 1.6;
// Cells a unit: 1.2, the bandwidth, over 0.8.
const cells = 1.5;

// The sum of the kernels about a position, of the variance 1, and its gradient, both in cells.
fn kernels(position: vec3f) -> vec4f {
    let spectrum = gabor_spectrum_of(vec2f(frequency / cells, 0.0), vec2f(0.0, 6.28318531), vec2f(-1.0, 2.0));
    let corner = floor(position - 0.5) - 1.0;
    var sum = vec4f();
    for (var cell = 0u; cell < 64u; cell++) {
        let offset = vec3u(cell & 3u, cell >> 2u & 3u, cell >> 4u);
        let apart = position - corner - vec3f(offset);
        let outside = max(max(apart - 1.0, -apart), vec3f());
        // Kernels reach 1.5 cells.
        if dot(outside, outside) >= 2.25 {
            continue;
        }
        var words = gabor_kernel_words(vec3i(corner) + vec3i(offset), 0u);
        for (var kernel = 0; kernel < 2; kernel++) {
            words = hash_triple(words);
            let r = apart - gabor_kernel_place(words.x);
            if dot(r, r) < 2.25 {
                let wave = gabor_spectrum_frequency(words.yz, spectrum);
                let angle = 6.28318531 * (dot(wave, r) + f32(words.z >> 16u) / 65536.0);
                // π a², the bandwidth in cells being 0.8.
                let amplitude = exp(-2.01061930 * dot(r, r));
                let fall = -4.02123860 * cos(angle) * r - 6.28318531 * sin(angle) * wave;
                sum += amplitude * vec4f(cos(angle), fall);
            }
        }
    }
    // Two kernels a cell have the variance (2a²)^(-3/2).
    return 1.20339293 * sum;
}

fn noise_value(position: vec3f) -> f32 {
    return noise_mean + noise_deviation * kernels(cells * position).x;
}

fn noise_gradient(position: vec3f) -> vec3f {
    return noise_deviation * cells * kernels(cells * position).yzw;
}

// The noise, or its mean where it is too fine for a width.
//
// The fade is that of Apodaca and Gritz 1999, "Advanced RenderMan", `filteredsnoise`.
fn noise_clamped(position: vec3f, width: f32) -> f32 {
    return mix(noise_value(position), noise_mean, smoothstep(0.2, 0.75, frequency * width));
}
