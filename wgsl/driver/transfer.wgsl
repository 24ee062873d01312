// Height transfers h = g(f) between a driver and a filter: from what a footprint holds of f to what it holds of h.

/// What a footprint holds of h = g(f) and of its slopes. `moments` are mean and variance of h and of g′(f); `slope` and
/// `slope_covariance` are mean and covariance of the slopes of f.
///
/// A Gaussian f and its gradient are independent at a point, and the slopes of h are g′(f) times those of f: their mean
/// is ⟨g′⟩ s, their covariance ⟨g′²⟩ Λ + Var(g′) s sᵀ. Skewness and excess kurtosis of h are not known.
///
/// Source: Heitz et al. 2014, "Filtering Non-Linear Transfer Functions on Surfaces", equations 24 to 26.
/// Domain: moments in [0, 1], slope in [-2, 2], slope_covariance psd(0.01, 1, 0.95).
/// Error: 2e-7 of 1 + the result; f32 rounding.
fn transfer_surface(moments: vec4f, slope: vec2f, slope_covariance: vec3f) -> statistics_surface {
    let variance = max(moments.w, 0.0);
    let square = variance + moments.z * moments.z;
    let tilt = vec3f(slope.x * slope.x, slope.x * slope.y, slope.y * slope.y);
    return statistics_surface(
        vec4f(moments.xy, 0.0, 0.0), moments.z * slope, square * slope_covariance + variance * tilt,
    );
}

/// Mean and variance of a curve, and of its slope, from a table of means and deviations: over the mean of f from `low`
/// to `high`, and over the square root of the deviation of f from 0 to `reach`. Values outside read the border.
///
/// Heights and slopes are in parts of their ranges about the middles of these. Where the deviation is less than about
/// four columns the table does not see bends: there means err by up to the change of the slope in half a column.
///
/// Source: Heitz et al. 2014, section 7: the preconvolved texture, with deviations in place of second moments.
/// Domain: mean in [-0.5, 1.5], deviation in [0.02, 0.5], low in [-0.5, -0.5], high in [1.5, 1.5], reach in [0.5, 0.5].
/// Error: 6e-3 absolute; bilinear interpolation of 512 × 48 nodes for eleven samples.
fn transfer_table(
    mean: f32, deviation: f32, low: f32, high: f32, reach: f32, transfer: texture_2d<f32>, transfer_sampler: sampler,
) -> vec4f {
    let size = vec2f(textureDimensions(transfer));
    let part = sqrt(clamp(deviation / max(reach, 1e-30), 0.0, 1.0));
    let at = vec2f(grid_linear(mean, low, high, size.x), grid_linear(part, 0.0, 1.0, size.y));
    let read = textureSampleLevel(transfer, transfer_sampler, at, 0.0);
    return vec4f(read.x, read.y * read.y, read.z, read.w * read.w);
}

/// Mean and variance of |f|^exponent with the sign of f, and of its slope, from a table over the share that the
/// deviation has in |mean| + deviation: all four are powers of that sum times what depends on the share alone.
///
/// Means and deviations of f beyond 1e4 count as that.
///
/// Source: the definition, for a homogeneous function.
/// Domain: mean in [-2, 2], deviation log in [1e-4, 2], exponent in [1.7, 1.7].
/// Error: 1e-5 of 1 + the result; linear interpolation between 512 nodes.
fn transfer_power(mean: f32, deviation: f32, exponent: f32, transfer: texture_2d<f32>) -> vec4f {
    let m = clamp(mean, -1e4, 1e4);
    let s = clamp(deviation, 0.0, 1e4);
    let size = max(abs(m) + s, 1e-30);
    let last = i32(textureDimensions(transfer).x) - 1;
    let place = s / size * f32(last);
    let node = clamp(i32(place), 0, last);
    let before = textureLoad(transfer, vec2i(node, 0), 0);
    let after = textureLoad(transfer, vec2i(min(node + 1, last), 0), 0);
    let read = mix(before, after, place - f32(node));
    let power = exp2(clamp(exponent, 1.0, 8.0) * log2(size));
    let heights = clamp(power * read.xy, vec2f(0.0), vec2f(1e17));
    let slopes = clamp(power / size * read.zw, vec2f(0.0), vec2f(1e17));
    return vec4f(select(heights.x, -heights.x, m < 0.0), heights.y * heights.y, slopes.x, slopes.y * slopes.y);
}

/// Four values that stand for a normal f.
///
/// Source: the rule of Gauss and Hermite of four nodes, ±√(3 ∓ √6).
/// Domain: mean in [-2, 2], deviation log in [1e-4, 1].
/// Error: 4e-7 absolute; f32 rounding of values up to 4.4.
fn transfer_places(mean: f32, deviation: f32) -> vec4f {
    return mean + deviation * vec4f(-2.33441422, -0.741963784, 0.741963784, 2.33441422);
}

/// A cubic of four values, by its coefficients of 1, x, x² and x³.
///
/// Source: the definition, by Horner's rule.
/// Domain: at in [-2, 2], coefficients in [-1, 1].
/// Error: 4e-7 of 1 + the result; f32 rounding.
fn transfer_cubic(at: vec4f, coefficients: vec4f) -> vec4f {
    let c = coefficients;
    let x = clamp(at, vec4f(-1e5), vec4f(1e5));
    return c.x + x * (c.y + x * (c.z + x * c.w));
}

/// Mean and deviation of the heights of a narrow normal f, from those at `transfer_places`.
///
/// Exact for cubics, as which a curve counts over few deviations. At a crease mean and deviation are up to 0.06 and
/// 0.08 deviations of f off, times the change of the slope.
///
/// Source: the rule's weights, (3 ± √6)/12.
/// Domain: heights in [-1, 1].
/// Error: 2e-7 absolute; f32 rounding.
fn transfer_heights(heights: vec4f) -> vec2f {
    let weights = vec4f(0.0458758548, 0.454124145, 0.454124145, 0.0458758548);
    let h = clamp(heights, vec4f(-1e16), vec4f(1e16));
    let mean = dot(weights, h);
    let apart = h - mean;
    return vec2f(mean, sqrt(dot(weights, apart * apart)));
}
