// The footprint of a pixel on a surface with two coordinates, as the covariance of the positions that the pixel's
// filter covers. Covariances are (xx, xy, yy). Positions are in any unit; the covariance is in its square.
//
// Every form is a sum of squares or a product of factors with one sign: a footprint never has a negative variance.

/// Covariance J P Jᵀ of the positions that a pixel covers, J = (dpdx dpdy) being the position's screen derivatives.
///
/// `pixel_covariance` is that of the pixel's filter, in pixels². P is split into its Cholesky factor, so that the
/// result is a sum of two squares. Derivatives beyond 1e9 count as 1e9.
///
/// Source: Heckbert 1989, "Fundamentals of Texture Mapping and Image Warping", section 3.5: affine image of a Gaussian.
/// Domain: dpdx in [-8, 8], dpdy in [-8, 8], pixel_covariance psd(0.1, 2, 0.99).
/// Error: 2e-4 absolute; f32 rounding of variances up to 2e3.
fn footprint_covariance(dpdx: vec2f, dpdy: vec2f, pixel_covariance: vec3f) -> vec3f {
    let column = sqrt(max(pixel_covariance.x, 1e-30));
    let reach = sqrt(max(pixel_covariance.z, 0.0));
    let shear = clamp(pixel_covariance.y / column, -reach, reach);
    let rest = sqrt(max((reach - shear) * (reach + shear), 0.0));
    let limit = vec2f(1e9);
    let right = clamp(dpdx, -limit, limit);
    let down = clamp(dpdy, -limit, limit);
    let a = right * column + down * shear;
    let b = down * rest;
    return vec3f(a.x * a.x + b.x * b.x, a.x * a.y + b.x * b.y, a.y * a.y + b.y * b.y);
}

/// Covariance of the positions that a pixel with a round filter of the given deviation (in pixels) covers: σ² J Jᵀ.
///
/// The deviation of common filters: box 0.289, tent 0.408, Gaussian resolve 0.5. Match the filter that resolves the
/// image.
///
/// Source: as `footprint_covariance`, with P = σ² I.
/// Domain: dpdx in [-8, 8], dpdy in [-8, 8], pixel_deviation log in [0.1, 2].
/// Error: 1e-4 absolute; f32 rounding of variances up to 512.
fn footprint_covariance_round(dpdx: vec2f, dpdy: vec2f, pixel_deviation: f32) -> vec3f {
    let limit = vec2f(1e9);
    let deviation = clamp(pixel_deviation, 0.0, 1e9);
    let a = clamp(dpdx, -limit, limit) * deviation;
    let b = clamp(dpdy, -limit, limit) * deviation;
    return vec3f(a.x * a.x + b.x * b.x, a.x * a.y + b.x * b.y, a.y * a.y + b.y * b.y);
}

/// Deviations of a covariance along its major and its minor axis, the major one first.
///
/// The major variance is a sum of positive terms and the minor one the determinant divided by it: a singular
/// covariance has a minor deviation of zero up to 4e-4 of the major one, never NaN. Variances beyond 1e36 count as
/// 1e36.
///
/// Source: eigenvalues of a symmetric 2×2 matrix, scaled to its larger variance.
/// Domain: covariance psd(0.001, 16, 0.99).
/// Error: 6e-6 absolute; f32 rounding, the minor deviation through the determinant.
fn footprint_deviations(covariance: vec3f) -> vec2f {
    let scale = clamp(max(covariance.x, covariance.z), 1e-30, 1e36);
    // One quotient for all: those of three may be off by different parts, of which the determinant leaves 5e-4.
    let inverse = 1.0 / scale;
    let c = clamp(covariance * inverse, vec3f(-1.0), vec3f(1.0));
    let major = 0.5 * (c.x + c.z) + length(vec2f(0.5 * (c.x - c.z), c.y));
    let minor = max(c.x * c.z - c.y * c.y, 0.0) / max(major, 0.5);
    return sqrt(vec2f(max(major, 0.0), minor) * scale);
}

/// Unit vector along the major axis of a covariance; of the two opposite ones either. (1, 0) when no axis is longer.
///
/// The longer of the two eigenvector formulas is taken, which adds what the shorter one subtracts.
///
/// Source: eigenvectors of a symmetric 2×2 matrix.
/// Domain: covariance psd(0.001, 16, 0.99).
/// Error: 3e-7 absolute; f32 rounding, up to the sign, where the deviations differ by more than a tenth.
fn footprint_direction(covariance: vec3f) -> vec2f {
    let scale = clamp(max(covariance.x, covariance.z), 1e-30, 1e36);
    let c = clamp(covariance / scale, vec3f(-1.0), vec3f(1.0));
    let lean = 0.5 * (c.x - c.z);
    let radius = length(vec2f(lean, c.y));
    // 1e-15 only decides for isotropic covariances: its square is still a normal number.
    let wide = vec2f(max(radius + lean, 1e-15), c.y);
    let tall = vec2f(c.y, radius - lean);
    return normalize(select(tall, wide, lean >= 0.0));
}

/// A normal distribution as a round one that is stretched along an axis: deviation² I + away awayᵀ is its covariance.
struct footprint_stretch {
    /// Along the major axis, √(major² − minor²) long.
    away: vec2f,
    /// The minor deviation.
    deviation: f32,
    /// The same as a part of the major one.
    part: f32,
}

/// A covariance as a round one that is stretched, whose minor deviation counts as `least` of the major one at least: by
/// two square roots and a division behind each other, and without the axis of one that has none.
///
/// Variances beyond 1e18 are undefined, deviations below 1e-9 count as less.
///
/// Source: eigenvalues and eigenvectors of a symmetric 2×2 matrix, the longer of the two formulas of the latter.
/// Domain: covariance psd(0.2, 0.4, 0.5), least in [0.09, 0.3].
/// Error: 5e-7 absolute; f32 rounding.
fn footprint_stretched(covariance: vec3f, least: f32) -> footprint_stretch {
    let lean = 0.5 * (covariance.x - covariance.z);
    let radius = sqrt(lean * lean + covariance.y * covariance.y);
    let major = max(0.5 * (covariance.x + covariance.z) + radius, 1e-18);
    let inverse = 1.0 / major;
    let determinant = covariance.x * covariance.z - covariance.y * covariance.y;
    let narrowest = clamp(least, 0.0, 1.0) * clamp(least, 0.0, 1.0);
    let square = clamp(determinant * inverse * inverse, narrowest, 1.0);
    let longer = abs(lean) + radius;
    let along = select(vec2f(covariance.y, longer), vec2f(longer, covariance.y), lean >= 0.0);
    // The difference of the variances is twice the radius, without a difference.
    let stretch = min(2.0 * radius, (1.0 - narrowest) * major) / max(2.0 * radius * longer, 1e-36);
    return footprint_stretch(along * sqrt(stretch), sqrt(square * major), sqrt(square));
}
