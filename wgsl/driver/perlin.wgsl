// Perlin's gradient noise in the plane: at every lattice point a line of unit slope, blended by the quintic fade.
//
// Slopes point in one of 16 evenly spaced directions. Over all places the noise has the mean 0, the variance
// A₀ B₀ = 181/231 · 535/9009 and gradients of 8.38395 times that along either axis; it is at most √½.

/// The line of a lattice point, a slope of unit length.
///
/// Source: the definition.
/// Domain: place in [-1000, 1000], seed integer in [0, 4294967295].
/// Error: exact.
fn perlin_slope(place: vec2f, seed: u32) -> vec2f {
    let turn = lattice_word(place, seed) >> 28u;
    // cos and sin of π/8, π/4 and 3π/8, by quarter turns; selected, as tables in functions are copied at every call.
    let even = select(vec2f(1.0, 0.0), vec2f(0.707106781), (turn & 2u) != 0u);
    let odd = select(vec2f(0.923879533, 0.382683432), vec2f(0.382683432, 0.923879533), (turn & 2u) != 0u);
    let slope = select(even, odd, (turn & 1u) != 0u);
    let turned = select(slope, vec2f(-slope.y, slope.x), (turn & 4u) != 0u);
    return select(turned, -turned, (turn & 8u) != 0u);
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
    let p = clamp(position, vec2f(-1e9), vec2f(1e9));
    let t = fract(p);
    let corners = lattice_corners(p, period);
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

/// 1 − ρ(s/√2): the share of the power that a footprint of 1/√2 times these deviations, in cells, takes from the noise.
///
/// `deviations` are those along the major and the minor axis; beyond 1e3 they count as 1e3. With A(τ) and B(τ) for the
/// correlations of a point's weight and of its weighted line along one axis, ρ is a mean of ½ (A B + B A) over normal
/// offsets: of both factors 1 − s² N(s)/D(s) is a fit, exact to the order s² and as s^−1 and s^−3 far away, the largest
/// error in s from 0.005 to 1000 minimized to 3.3e-4 of each. The footprint's turn against the lattice changes ρ by
/// less than 0.013.
///
/// Source: the autocorrelation of the definition; a fit, which a row measures against quadrature.
/// Domain: deviations log in [0.004, 100].
/// Error: 4e-4 absolute; the fit.
fn perlin_lost(deviations: vec2f) -> f32 {
    let s = clamp(deviations, vec2f(), vec2f(1e3));
    let tail = 97.6903487 + 183.927984 * s;
    let all = 1.0 + s * (12.1188286 + s * (22.5310434 + s * (80.0358548 + s * tail)));
    let a = s * s * (1.82320442 + s * (25.0145307 + s * (5.03403862 + 183.927984 * s)));
    let b = s * s * (6.56074766 + s * (80.0358548 + s * tail));
    let sum = (a + b) * all.yx;
    return 0.5 * (sum.x + sum.y - (a.x * b.y + b.x * a.y)) / (all.x * all.y);
}

/// How a point of the noise stands for a footprint whose deviations along the major and the minor axis, in cells, are
/// given: (multiplier, coupling, rest).
///
/// The footprint's mean is best told as the multiplier times the noise. Around that the variance is, over the noise's
/// own, the rest, and |Σ^½ ∇n|² times the square of the coupling. All three together lose what the multiplier leaves:
/// rest + coupling² 8.38395 tr Σ is 1 − multiplier².
///
/// Source: the mean and the variance, given the noise and its gradient at the point, of a Gaussian process of the same
/// autocorrelation. The coupling is fitted to E|m|²/tr Σ, m being the regression on the gradient; the multiplier is a
/// shorter fit than that of `perlin_lost`, within 4.2e-3.
/// Domain: deviations log in [0.004, 100].
/// Error: 1.2e-2 absolute; the fits.
fn perlin_filter(deviations: vec2f) -> vec3f {
    let s = clamp(deviations, vec2f(), vec2f(1e3));
    let u = s * s;
    let trace = u.x + u.y;
    let lead = 1.0 + 0.577155296 * s.x;
    let gone = 4.19197604 * trace * lead + u.x * u.y * (24.1762994 + 26.3892551 * s.x);
    let all = gone + lead + 0.797044572 * u.x;
    let wide = 14.3391429 + 38.7244725 * s.x + s.y * (203.802549 * s.y - 60.3494511);
    let inverse = 1.0 + u.x * wide + 14.0754616 * u.y;
    // One division serves both.
    let unit = 1.0 / (all * inverse);
    let squared = all * unit;
    let lost = gone * inverse * unit;
    let share = 8.38395208 * trace * squared;
    return vec3f(1.0 - lost, sqrt(squared), lost * (2.0 - lost) - share);
}

/// 1 − g along the major and along the minor axis of a footprint with these deviations in cells.
///
/// Along either axis the footprint's mean slope is best told as g times that of a point. Around that the variance of
/// slopes is 1 − g² of the noise's. With R for the mean of the noise's correlation over all turns, g is the footprint's
/// mean of the second derivative of R along the axis, over that at 0. As R is near ½ (A B + B A), g is a sum of two
/// products of factors along the axes, as s^−5 s^−1 and s^−3 s^−3 far away: a fit, exact to the order s², the largest
/// error in deviations from 0.01 to 30 and aspects to 100 minimized to 6e-4.
///
/// Source: the mean of the gradient, given it at the point, of a Gaussian process of the same autocorrelation.
/// Domain: deviations log in [0.004, 100].
/// Error: 8e-4 absolute; the fit.
fn perlin_leveled(deviations: vec2f) -> vec2f {
    let s = clamp(deviations, vec2f(), vec2f(1e3));
    let u = s * s;
    // Along the axis, with the second derivatives of lines and weights; across it with the other's correlation.
    let lines = u * (10.2286860 + s * (2.37759961 + s * (14.1056065 + 47.7829723 * s)));
    let weights = u * (5.62265418 + 30.3947375 * u);
    let beside_lines = (u * (3.01139589 + 3.40596163 * s)).yx;
    let beside_weights = (u * (4.27941938 + 5.06835086 * s)).yx;
    let all_lines = 1.0 + (s * (1.67639002 + 1.50308350 * s)).yx + beside_lines;
    let all_weights = 1.0 + 5.33316686 * s + weights;
    return 0.857968634 * ((lines * all_lines + beside_lines) / (all_lines * (1.0 + lines)))
        + 0.142031366 * ((beside_weights * all_weights + weights) / (all_weights * (1.0 + beside_weights)));
}
