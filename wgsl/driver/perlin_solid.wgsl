// Perlin's gradient noise in space: at every lattice point a line, blended by the quintic fade.
//
// Slopes are the twelve directions to the middles of a cube's edges, of length √2. Over all places the noise has the
// mean 0, the variance 2 A₀² B₀ = 2 (181/231)² 535/9009 and gradients of 6.80477 times that along any axis. A surface
// cuts it: footprints are flat, and what they retain is that of a plane.

/// The line of a lattice point, a slope of length √2.
///
/// Source: Perlin 2002, "Improving Noise", with twelve slopes that are equally likely.
/// Domain: place in [-1000, 1000], seed integer in [0, 4294967295].
/// Error: exact.
fn perlin_solid_slope(place: vec3f, seed: u32) -> vec3f {
    let word = lattice_solid_word(place, seed);
    let edge = ((word >> 16u) * 12u) >> 16u;
    let signs = 1.0 - 2.0 * vec2f(vec2u(edge & 1u, (edge >> 1u) & 1u));
    let upright = select(vec3f(signs, 0.0), vec3f(signs.x, 0.0, signs.y), edge >= 4u);
    return select(upright, vec3f(0.0, signs), edge >= 8u);
}

/// Noise and its gradient: (noise, gradient).
///
/// Lattice points are the whole numbers. `period`, in whole lattice points, makes it tile; 0 does not. Seeds have noise
/// of their own.
///
/// Source: Perlin 2002, "Improving Noise"; the gradient by differentiation.
/// Domain: position in [-1000, 1000], period integer in [0, 300], seed integer in [0, 4294967295].
/// Error: 5e-6 absolute; f32 rounding of the gradient.
fn perlin_solid_noise(position: vec3f, period: vec3f, seed: u32) -> vec4f {
    let p = clamp(position, vec3f(-1e9), vec3f(1e9));
    let t = fract(p);
    let low = lattice_solid_wrapped(floor(p), period);
    let high = lattice_solid_wrapped(floor(p) + 1.0, period);
    let level = lattice_fade(t.xy);
    let upright = lattice_fade(t.zz);
    // Slopes and lines of the four edges along z, blended along it.
    var slopes = array<vec3f, 4>();
    var lines = vec4f();
    var rises = vec4f();
    for (var edge = 0u; edge < 4u; edge++) {
        let corner = vec2u(edge & 1u, edge >> 1u);
        let place = select(low.xy, high.xy, corner == vec2u(1u));
        let below = perlin_solid_slope(vec3f(place, low.z), seed);
        let above = perlin_solid_slope(vec3f(place, high.z), seed);
        let apart = t - vec3f(vec2f(corner), 0.0);
        let start = dot(below, apart);
        rises[edge] = dot(above, apart - vec3f(0.0, 0.0, 1.0)) - start;
        lines[edge] = start + upright.x * rises[edge];
        slopes[edge] = below + upright.x * (above - below);
    }
    let across = lines.yw - lines.xz;
    let front = lines.x + level.x * across.x;
    let back = lines.z + level.x * across.y;
    let rise = mix(mix(rises.x, rises.y, level.x), mix(rises.z, rises.w, level.x), level.y);
    let slope = mix(mix(slopes[0], slopes[1], level.x), mix(slopes[2], slopes[3], level.x), level.y);
    let steep = vec3f(level.zw * vec2f(across.x + level.y * (across.y - across.x), back - front), upright.z * rise);
    return vec4f(front + level.y * (back - front), slope + steep);
}

/// 1 − ρ(s/√2): the share of the power that a flat footprint of 1/√2 times these deviations, in cells, takes from the
/// noise.
///
/// `deviations` are those along the major and the minor axis; beyond 1e3 they count as 1e3. With A and B as
/// `perlin_lost` has them, ρ of a plane through the lattice is ⅓ (A B + B A + A A); other planes differ by up to 0.01.
///
/// Source: the autocorrelation of the definition; the fits of `perlin_lost`.
/// Domain: deviations log in [0.004, 100].
/// Error: 5e-4 absolute; the fits.
fn perlin_solid_lost(deviations: vec2f) -> f32 {
    let s = clamp(deviations, vec2f(), vec2f(1e3));
    let tail = 97.6903487 + 183.927984 * s;
    let all = 1.0 + s * (12.1188286 + s * (22.5310434 + s * (80.0358548 + s * tail)));
    let a = s * s * (1.82320442 + s * (25.0145307 + s * (5.03403862 + 183.927984 * s))) / all;
    let b = s * s * (6.56074766 + s * (80.0358548 + s * tail)) / all;
    return (2.0 * (a.x + a.y) + b.x + b.y - (a.x * b.y + b.x * a.y + a.x * a.y)) / 3.0;
}

/// How a point of the noise stands for a flat footprint whose deviations along the major and the minor axis, in cells,
/// are given: (multiplier, coupling, rest), as `perlin_filter` has it.
///
/// Source: as `perlin_filter`; rest + coupling² 6.80477 tr Σ is 1 − multiplier².
/// Domain: deviations log in [0.004, 100].
/// Error: 2.2e-2 absolute; the fit of the coupling, times the trace of long footprints.
fn perlin_solid_filter(deviations: vec2f) -> vec3f {
    let lost = perlin_solid_lost(deviations);
    let s = clamp(deviations, vec2f(), vec2f(1e3));
    let u = s * s;
    let wide = 14.4536564 + 28.7961317 * s.x + s.y * (174.003371 * s.y - 45.6874547);
    let coupling = inverseSqrt(1.0 + u.x * wide + 10.2836563 * u.y);
    let share = 6.80477099 * (u.x + u.y) * coupling * coupling;
    return vec3f(1.0 - lost, coupling, lost * (2.0 - lost) - share);
}
