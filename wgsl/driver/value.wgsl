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
    let t = fract(clamp(position, vec2f(-1e9), vec2f(1e9)));
    let corners = lattice_corners(position, period);
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
