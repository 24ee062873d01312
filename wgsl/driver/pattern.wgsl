// Patterns of two values over a Gaussian footprint at any rotation: the share of it that has the higher value. Squares
// of a checker and gaps of a grid are products of what lies along two axes; means of products are products of means
// only where the footprint lies along the axes, and `crossing_lines` is the rest.
//
// Footprints are covariances (xx, xy, yy) in periods² or squares². The forms over a box along the axes, of given widths
// across x and y, stand for what shaders do without the rest.

/// Share of a Gaussian footprint on the squares of a checker that begin at an even sum of two whole numbers. Squares
/// have the side 1.
///
/// Source: the definition; E[a b] = E[a] E[b] + covariance for a and b ±1.
/// Domain: position in [-8, 8], footprint psd(0.04, 2, 0.99).
/// Error: 0.08 absolute; that of `crossing_squares`, for footprints narrower than 0.02 periods near an axis.
fn pattern_checker(position: vec2f, footprint: vec3f) -> f32 {
    let at = 0.5 * position - round(0.5 * position);
    let deviations = 0.5 * sqrt(clamp(footprint.xz, vec2f(0.0), vec2f(1e36)));
    let x = 2.0 * pulse_train(at.x, 0.5, deviations.x) - 1.0;
    let y = 2.0 * pulse_train(at.y, 0.5, deviations.y) - 1.0;
    let rest = crossing_squares(at - 0.25, 0.25 * footprint);
    return clamp(0.5 + 0.5 * x * y + 2.0 * rest, 0.0, 1.0);
}

/// Share of a Gaussian footprint on the lines of a grid, centered at whole numbers along x and along y and as wide as
/// `widths` say.
///
/// Source: the definition; what is on no line is a product.
/// Domain: position in [-4, 4], widths in [0, 1], footprint psd(0.02, 2, 0.99).
/// Error: 0.02 absolute; that of `crossing_lines`.
fn pattern_grid(position: vec2f, widths: vec2f, footprint: vec3f) -> f32 {
    let at = position - round(position);
    let duties = clamp(widths, vec2f(), vec2f(1.0));
    let deviations = sqrt(clamp(footprint.xz, vec2f(0.0), vec2f(1e36)));
    let x = pulse_train(at.x + 0.5 * duties.x, duties.x, deviations.x);
    let y = pulse_train(at.y + 0.5 * duties.y, duties.y, deviations.y);
    return clamp(x + y - x * y - crossing_lines(at, duties, footprint), 0.0, 1.0);
}

/// Share of a box along the axes on the squares of a checker, as `pattern_checker`.
///
/// Source: Quilez 2016, "Filtering the checkerboard pattern": the product of the means along both axes.
/// Domain: position in [-8, 8], widths log in [0.01, 8].
/// Error: 3e-7 absolute; f32 rounding.
fn pattern_checker_box(position: vec2f, widths: vec2f) -> f32 {
    let at = 0.5 * position - round(0.5 * position);
    let x = 2.0 * pulse_train_box(at.x, 0.5, 0.5 * widths.x) - 1.0;
    let y = 2.0 * pulse_train_box(at.y, 0.5, 0.5 * widths.y) - 1.0;
    return 0.5 + 0.5 * x * y;
}

/// Share of a box along the axes on the lines of a grid, as `pattern_grid`.
///
/// Source: Quilez 2016, "Filtering the checkerboard pattern", of a grid's lines.
/// Domain: position in [-4, 4], lines in [0, 1], widths log in [0.01, 8].
/// Error: 6e-6 absolute; f32 rounding of an edge over the width.
fn pattern_grid_box(position: vec2f, lines: vec2f, widths: vec2f) -> f32 {
    let at = position - round(position) + 0.5 * lines;
    let x = pulse_train_box(at.x, lines.x, widths.x);
    let y = pulse_train_box(at.y, lines.y, widths.y);
    return x + y - x * y;
}

/// Mean, variance, skewness and excess kurtosis of a value that is 1 on a share of a footprint and 0 elsewhere.
///
/// Shares below 1e-5 and above 1 − 1e-5 have the skewness and kurtosis of those.
///
/// Source: moments of a Bernoulli variable.
/// Domain: share in [0.0001, 0.9999].
/// Error: 2e-6 relative; f32 rounding.
fn pattern_moments(share: f32) -> vec4f {
    let mean = clamp(share, 0.0, 1.0);
    let inside = clamp(share, 1e-5, 0.99999);
    let variance = inside * (1.0 - inside);
    return vec4f(mean, mean * (1.0 - mean), (1.0 - 2.0 * inside) * inverseSqrt(variance), 1.0 / variance - 6.0);
}
