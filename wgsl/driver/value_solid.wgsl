// Value noise in space: at every lattice point a value, blended by the quintic fade.
//
// Values are evenly distributed over [−1, 1]. Over all places the noise has the mean 0, the variance A₀³/3 =
// (181/231)³/3 and gradients of 3.64641 times that along any axis; it is at most 1. On a plane through the lattice its
// correlation is that of `value_noise`, whose `value_lost` and `value_filter` are its own.

/// The value of a lattice point.
///
/// Source: the definition.
/// Domain: place in [-1000, 1000], seed integer in [0, 4294967295].
/// Error: exact.
fn value_solid_point(place: vec3f, seed: u32) -> f32 {
    return f32(lattice_solid_word(place, seed) >> 8u) * (2.0 / 16777216.0) - (1.0 - 1.0 / 16777216.0);
}

/// Noise and its gradient: (noise, gradient).
///
/// Lattice points are the whole numbers. `period`, in whole lattice points, makes it tile; 0 does not. Seeds have noise
/// of their own.
///
/// Source: the definition; the gradient by differentiation.
/// Domain: position in [-1000, 1000], period integer in [0, 300], seed integer in [0, 4294967295].
/// Error: 5e-6 absolute; f32 rounding of the gradient.
fn value_solid_noise(position: vec3f, period: vec3f, seed: u32) -> vec4f {
    let p = clamp(position, vec3f(-1e9), vec3f(1e9));
    let low = lattice_solid_wrapped(floor(p), period);
    let high = lattice_solid_wrapped(floor(p) + 1.0, period);
    let t = fract(p);
    let level = lattice_fade(t.xy);
    let upright = lattice_fade(t.zz);
    // Values of the four edges along z, blended along it.
    var values = vec4f();
    var rises = vec4f();
    for (var edge = 0u; edge < 4u; edge++) {
        let place = select(low.xy, high.xy, vec2u(edge & 1u, edge >> 1u) == vec2u(1u));
        let below = value_solid_point(vec3f(place, low.z), seed);
        rises[edge] = value_solid_point(vec3f(place, high.z), seed) - below;
        values[edge] = below + upright.x * rises[edge];
    }
    let across = values.yw - values.xz;
    let front = values.x + level.x * across.x;
    let back = values.z + level.x * across.y;
    let rise = mix(mix(rises.x, rises.y, level.x), mix(rises.z, rises.w, level.x), level.y);
    let steep = vec3f(level.zw * vec2f(across.x + level.y * (across.y - across.x), back - front), upright.z * rise);
    return vec4f(front + level.y * (back - front), steep);
}
