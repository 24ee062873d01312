// Perlin's gradient noise in the plane: at every lattice point a line of unit slope, blended by the quintic fade.
//
// Slopes point in one of 16 evenly spaced directions. Over all places the noise has the mean 0, the variance
// A₀ B₀ = 181/231 · 535/9009 and gradients of 8.38395 times that along either axis; it is at most √½.

/// cos and sin of the multiples of π/8.
const perlin_directions = array<vec2f, 16>(
    vec2f(1.0, 0.0), vec2f(0.923879533, 0.382683432), vec2f(0.707106781, 0.707106781), vec2f(0.382683432, 0.923879533),
    vec2f(0.0, 1.0), vec2f(-0.382683432, 0.923879533), vec2f(-0.707106781, 0.707106781),
    vec2f(-0.923879533, 0.382683432), vec2f(-1.0, 0.0), vec2f(-0.923879533, -0.382683432),
    vec2f(-0.707106781, -0.707106781), vec2f(-0.382683432, -0.923879533), vec2f(0.0, -1.0),
    vec2f(0.382683432, -0.923879533), vec2f(0.707106781, -0.707106781), vec2f(0.923879533, -0.382683432),
);

/// The line of a lattice point, a slope of unit length.
///
/// Source: the definition.
/// Domain: place in [-1000, 1000], seed integer in [0, 4294967295].
/// Error: exact.
fn perlin_slope(place: vec2f, seed: u32) -> vec2f {
    return perlin_directions[lattice_word(place, seed) >> 28u];
}

/// Noise and its gradient along x and y: (noise, gradient).
///
/// Lattice points are the whole numbers. `period`, in whole lattice points, makes it tile; 0 does not. Seeds have noise
/// of their own.
///
/// Source: Perlin 2002, "Improving Noise", with slopes in the plane; the gradient by differentiation.
/// Domain: position in [-1000, 1000], period integer in [0, 300], seed integer in [0, 4294967295].
/// Error: 3e-6 absolute; f32 rounding of the gradient.
fn perlin_noise(position: vec2f, period: vec2f, seed: u32) -> vec3f {
    let t = fract(clamp(position, vec2f(-1e9), vec2f(1e9)));
    let corners = lattice_corners(position, period);
    let a = perlin_slope(corners.xy, seed);
    let b = perlin_slope(corners.zy, seed);
    let c = perlin_slope(corners.xw, seed);
    let d = perlin_slope(corners.zw, seed);
    let fade = lattice_fade(t);
    // The four lines at the place, and what the blend adds to their blended slopes.
    let lines = vec4f(dot(a, t), dot(b, t - vec2f(1.0, 0.0)), dot(c, t - vec2f(0.0, 1.0)), dot(d, t - 1.0));
    let across = lines.yw - lines.xz;
    let low = lines.x + fade.x * across.x;
    let high = lines.z + fade.x * across.y;
    let below = a + fade.x * (b - a);
    let above = c + fade.x * (d - c);
    let steep = fade.zw * vec2f(across.x + fade.y * (across.y - across.x), high - low);
    return vec3f(low + fade.y * (high - low), below + fade.y * (above - below) + steep);
}
