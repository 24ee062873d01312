// Simplex noise in the plane: lines of unit slope at the points of a lattice of equilateral triangles, each times
// 70 (½ − r²)⁴ where its distance r is below √½.
//
// Over all places the noise has the mean 0, the variance √3 π/184320 · 70² = 0.144655 and gradients of 160/7 times that
// along either axis.

/// How a position is skewed to the lattice of whole numbers, (√3 − 1)/2, and back, (3 − √3)/6.
const simplex_skew = vec2f(0.366025404, 0.211324865);

/// The way back in two parts, 865/4096 and the rest: whole numbers up to 16384 times the first are exact.
const simplex_back = vec2f(0.211181640625, 0.000143224780);

/// The part of a lattice point in noise and gradient at a distance from it: (noise, gradient).
///
/// Source: Perlin 2001, "Noise Hardware", with the radius and scale of Gustavson 2005, "Simplex Noise Demystified".
/// Domain: away in [-1, 1], slope unit.
/// Error: 3e-6 absolute; f32 rounding of the gradient.
fn simplex_part(away: vec2f, slope: vec2f) -> vec3f {
    let d = clamp(away, vec2f(-1.0), vec2f(1.0));
    let g = clamp(slope, vec2f(-1.0), vec2f(1.0));
    let w = max(0.5 - dot(d, d), 0.0);
    let weight = 70.0 * w * w * w * w;
    let rise = dot(g, d);
    return vec3f(weight * rise, weight * g - (560.0 * w * w * w * rise) * d);
}

/// Noise and its gradient along x and y: (noise, gradient).
///
/// Seeds have noise of their own. It has no periods: its lattice has none along x and y both.
///
/// Source: Perlin 2001, "Noise Hardware"; the gradient by differentiation.
/// Domain: position in [-100, 100], seed integer in [0, 4294967295].
/// Error: 5e-6 absolute; f32 rounding of the gradient.
fn simplex_noise(position: vec2f, seed: u32) -> vec3f {
    let p = clamp(position, vec2f(-1e9), vec2f(1e9));
    let corner = floor(p + simplex_skew.x * (p.x + p.y));
    let sum = corner.x + corner.y;
    // Whole numbers first: they leave less than one, to which the fraction is added without loss.
    let near = fract(p) + ((floor(p) - corner) + simplex_back.x * sum) + simplex_back.y * sum;
    // The second of three corners stands to the right or above.
    let step = select(vec2f(0.0, 1.0), vec2f(1.0, 0.0), near.x > near.y);
    let middle = near - step + simplex_skew.y;
    let far = near - 1.0 + 2.0 * simplex_skew.y;
    return simplex_part(near, perlin_slope(corner, seed))
        + simplex_part(middle, perlin_slope(corner + step, seed))
        + simplex_part(far, perlin_slope(corner + 1.0, seed));
}

/// 1 − ρ(s/√2): the share of the power that a footprint of 1/√2 times these deviations takes from the noise.
///
/// `deviations` are those along the major and the minor axis; beyond 1e3 they count as 1e3. As the kernel is near a
/// Gaussian, ρ is near a mean of ½ (A B + B A) with factors along the axes, as `perlin_lost` has it: both 1 − s² N(s)/
/// D(s), fitted to ρ together, the largest error in deviations from 0.01 to 100 and aspects to 300 minimized to 4.4e-5.
///
/// Source: the autocorrelation of the definition; a fit, which a row measures against quadrature.
/// Domain: deviations log in [0.004, 100].
/// Error: 1e-4 absolute; the fit.
fn simplex_lost(deviations: vec2f) -> f32 {
    let s = clamp(deviations, vec2f(), vec2f(1e3));
    let tail = 280.935504 + 627.624157 * s;
    let all = 1.0 + s * (6.33333160 + s * (30.7481155 + s * (114.324221 + s * tail)));
    let a = s * s * (5.36359378 + s * (32.0058501 + s * (100.218027 + 627.624157 * s)));
    let b = s * s * (17.4935491 + s * (114.324221 + s * tail));
    let sum = (a + b) * all.yx;
    return 0.5 * (sum.x + sum.y - (a.x * b.y + b.x * a.y)) / (all.x * all.y);
}

/// How a point of the noise stands for a footprint whose deviations along the major and the minor axis are given:
/// (multiplier, coupling, rest), as `perlin_filter` has it.
///
/// Source: as `perlin_filter`; rest + coupling² 160/7 tr Σ is 1 − multiplier².
/// Domain: deviations log in [0.004, 100].
/// Error: 1.1e-2 absolute; the fits.
fn simplex_filter(deviations: vec2f) -> vec3f {
    let s = clamp(deviations, vec2f(), vec2f(1e3));
    let u = s * s;
    let trace = u.x + u.y;
    let lead = 1.0 + 0.565130737 * s.x;
    let gone = 11.4285714 * trace * lead + u.x * u.y * (186.753752 + 196.373409 * s.x);
    let all = gone + lead + 1.50660637 * u.x;
    let wide = 35.6361843 + 172.031197 * s.x + s.y * (1524.14801 * s.y - 262.329808);
    let inverse = 1.0 + u.x * wide + 37.0481602 * u.y;
    // One division serves both.
    let unit = 1.0 / (all * inverse);
    let squared = all * unit;
    let lost = gone * inverse * unit;
    let share = 22.8571429 * trace * squared;
    return vec3f(1.0 - lost, sqrt(squared), lost * (2.0 - lost) - share);
}

/// 1 − g along the major and along the minor axis of a footprint with these deviations, as `perlin_leveled` has it.
///
/// As the kernel is near a Gaussian, the same form serves: fitted to g as a whole, exact to the order s², the largest
/// error in deviations from 0.01 to 30 and aspects to 100 minimized to 1.6e-3.
///
/// Source: as `perlin_leveled`.
/// Domain: deviations log in [0.004, 100].
/// Error: 2e-3 absolute; the fit.
fn simplex_leveled(deviations: vec2f) -> vec2f {
    let s = clamp(deviations, vec2f(), vec2f(1e3));
    let u = s * s;
    let lines = u * (27.3164716 + s * (17.0402528 + s * (123.313498 + 665.067211 * s)));
    let weights = u * (18.9771178 + s * (1.56713306 + 111.558507 * s));
    let beside_lines = (6.51020383 * u).yx;
    let beside_weights = (u * (10.9053630 + 17.2774615 * s)).yx;
    let all_lines = 1.0 + 2.16483409 * s.yx + beside_lines;
    let all_weights = 1.0 + 0.971297660 * s + weights;
    return 0.638284735 * ((lines * all_lines + beside_lines) / (all_lines * (1.0 + lines)))
        + 0.361715265 * ((beside_weights * all_weights + weights) / (all_weights * (1.0 + beside_weights)));
}
