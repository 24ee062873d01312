// Value noise in the plane: at every lattice point a value, blended by the quintic fade.
//
// Values are evenly distributed over [−1, 1]. Over all places the noise has the mean 0, the variance A₀²/3 =
// (181/231)²/3 and gradients of 3.64641 times that along either axis; it is at most 1.

/// The value of a lattice point.
///
/// Source: the definition.
/// Domain: place in [-1000, 1000], seed integer in [0, 4294967295].
/// Error: exact.
fn value_point(place: vec2f, seed: u32) -> f32 {
    return f32(lattice_word(place, seed) >> 8u) * (2.0 / 16777216.0) - (1.0 - 1.0 / 16777216.0);
}

/// Noise and its gradient along x and y: (noise, gradient).
///
/// Lattice points are the whole numbers. `period`, in whole lattice points, makes it tile; 0 does not. Seeds have noise
/// of their own.
///
/// Source: the definition; the gradient by differentiation.
/// Domain: position in [-1000, 1000], period integer in [0, 300], seed integer in [0, 4294967295].
/// Error: 3e-6 absolute; f32 rounding of the gradient.
fn value_noise(position: vec2f, period: vec2f, seed: u32) -> vec3f {
    let p = clamp(position, vec2f(-1e9), vec2f(1e9));
    let t = fract(p);
    let corners = lattice_corners(p, period);
    let a = value_point(corners.xy, seed);
    let b = value_point(corners.zy, seed);
    let c = value_point(corners.xw, seed);
    let d = value_point(corners.zw, seed);
    let fade = lattice_fade(t);
    let low = a + fade.x * (b - a);
    let high = c + fade.x * (d - c);
    let across = b - a + fade.y * ((d - c) - (b - a));
    return vec3f(low + fade.y * (high - low), fade.zw * vec2f(across, high - low));
}

/// 1 − ρ(s/√2): the share of the power that a footprint of 1/√2 times these deviations, in cells, takes from the noise.
///
/// `deviations` are those along the major and the minor axis; beyond 1e3 they count as 1e3. With A(τ) for the
/// correlation of a point's weight along one axis, ρ is a mean of A A over normal offsets: of a factor 1 − s² N(s)/D(s)
/// is a fit, exact to the order s² and as s^−1 far away, the largest error in s from 0.005 to 1000 minimized to 1.1e-4.
///
/// Source: the autocorrelation of the definition; a fit, which a row measures against quadrature.
/// Domain: deviations log in [0.004, 100].
/// Error: 3e-4 absolute; the fit.
fn value_lost(deviations: vec2f) -> f32 {
    let s = clamp(deviations, vec2f(), vec2f(1e3));
    let all = 1.0 + s * (1.53926561 + s * (4.10173767 + s * (4.25332484 + 3.25574062 * s)));
    let a = s * s * (1.82320442 + s * (2.60700891 + 3.25574062 * s));
    return (a.x * all.y + a.y * all.x - a.x * a.y) / (all.x * all.y);
}

/// How a point of the noise stands for a footprint whose deviations along the major and the minor axis, in cells, are
/// given: (multiplier, coupling, rest), as `perlin_filter` has it.
///
/// Source: as `perlin_filter`; rest + coupling² 3.64641 tr Σ is 1 − multiplier².
/// Domain: deviations log in [0.004, 100].
/// Error: 1.3e-2 absolute; the fit of the coupling.
fn value_filter(deviations: vec2f) -> vec3f {
    let lost = value_lost(deviations);
    let s = clamp(deviations, vec2f(), vec2f(1e3));
    let u = s * s;
    let wide = 8.56982598 + 13.6938601 * s.x + s.y * (53.4998582 * s.y - 19.4372272);
    let inverse = 1.0 + u.x * wide + 6.9267625 * u.y;
    let coupling = inverseSqrt(inverse);
    let share = 3.64640884 * (u.x + u.y) * coupling * coupling;
    return vec3f(1.0 - lost, coupling, lost * (2.0 - lost) - share);
}

/// 1 − g along the major and along the minor axis of a footprint with these deviations in cells, as `perlin_leveled`
/// has it.
///
/// As R is near A A, g is a product of factors along the axes: a fit, exact to the order s² and as s^−3 s^−1 far away,
/// the largest error in deviations from 0.01 to 30 and aspects to 100 minimized to 1.8e-3, and to 1.4 % of 1 − g².
///
/// Source: as `perlin_leveled`.
/// Domain: deviations log in [0.004, 100].
/// Error: 2e-3 absolute; the fit.
fn value_leveled(deviations: vec2f) -> vec2f {
    let s = clamp(deviations, vec2f(), vec2f(1e3));
    let u = s * s;
    let along = u * (5.86740332 + u * (13.5601370 + 10.4283954 * s));
    let across = (u * (1.95580111 + 2.62979288 * s)).yx;
    let all_along = 1.0 + s * (0.290097123 + 2.01302158 * s) + along;
    let all_across = 1.0 + (s * (1.63765369 + 1.37619803 * s)).yx + across;
    return (along * all_across + across * (all_along - along)) / (all_along * all_across);
}
