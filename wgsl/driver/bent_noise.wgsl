// Noises of the plane with their second derivatives, and how a point of them stands for a footprint.
//
// Values and gradients are those of `perlin_noise`, `value_noise` and `simplex_noise`. What the mean over a footprint
// has of the trace of ΣH is the regression on it and the noise, with the autocorrelation of the definition: of that
// ((1 + a s)/(1 + a s + …))² is a fit, the largest error of it and of the multiplier in deviations from 0.004 to 1000
// minimized to 1.5e-2.

/// A noise at a place, with its derivatives.
struct bent_noise {
    /// The noise.
    noise: f32,
    /// Its gradient along x and y.
    slope: vec2f,
    /// Its second derivatives: xx, xy, yy.
    bends: vec3f,
}

/// `perlin_noise` with its second derivatives.
///
/// Source: as `perlin_noise`, by differentiation.
/// Domain: position in [-1000, 1000], period integer in [0, 300], seed integer in [0, 4294967295].
/// Error: 1.5e-5 absolute; f32 rounding of second derivatives up to 20.
fn bent_noise_perlin(position: vec2f, period: vec2f, seed: u32) -> bent_noise {
    let p = clamp(position, vec2f(-1e9), vec2f(1e9));
    let t = fract(p);
    let corners = lattice_corners(p, period);
    let a = perlin_slope(corners.xy, seed);
    let c = perlin_slope(corners.xw, seed);
    // From the left points to the right ones.
    let ab = perlin_slope(corners.zy, seed) - a;
    let cd = perlin_slope(corners.zw, seed) - c;
    let fade = lattice_fade(t);
    let steep = fade.zw;
    let bent = lattice_fade_bend(t);
    // Lines of the left points at the place, and what those of the right ones have more.
    let lines = vec2f(dot(a, t), dot(c, t - vec2f(0.0, 1.0)));
    let more = vec2f(dot(ab, t) - a.x - ab.x, dot(cd, t - vec2f(0.0, 1.0)) - c.x - cd.x);
    let low = lines.x + fade.x * more.x;
    let high = lines.y + fade.x * more.y;
    let across = more.x + fade.y * (more.y - more.x);
    let below = a + fade.x * ab;
    let rise = c + fade.x * cd - below;
    let turn = ab + fade.y * (cd - ab);
    return bent_noise(
        low + fade.y * (high - low),
        below + fade.y * rise + steep * vec2f(across, high - low),
        vec3f(
            bent.x * across + 2.0 * steep.x * turn.x,
            steep.y * (rise.x + steep.x * (more.y - more.x)) + steep.x * turn.y,
            bent.y * (high - low) + 2.0 * steep.y * rise.y,
        ),
    );
}

/// As `perlin_filter`, where second derivatives are known too.
///
/// Source: `bend_filter`, with the moments of the definition; a fit of the share.
/// Domain: deviations log in [0.004, 100].
/// Error: 2.5e-2 absolute; the fits.
fn bent_noise_perlin_filter(deviations: vec2f) -> bend_weights {
    let s = clamp(deviations, vec2f(), vec2f(1e3));
    let u = s * s;
    let lead = 1.0 + 0.497630130 * s.x;
    let wide = 5.80160106 + 0.411573190 * s.x + 10.2328686 * u.y;
    let root = lead / (lead + u.x * wide + 2.29250973 * u.y);
    return bend_filter(perlin_filter(s), root * root, s, 8.38395208, vec2f(166.214902, 47.8463366));
}

/// `value_noise` with its second derivatives.
///
/// Source: as `value_noise`, by differentiation.
/// Domain: position in [-1000, 1000], period integer in [0, 300], seed integer in [0, 4294967295].
/// Error: 1.5e-5 absolute; f32 rounding of second derivatives up to 12.
fn bent_noise_value(position: vec2f, period: vec2f, seed: u32) -> bent_noise {
    let p = clamp(position, vec2f(-1e9), vec2f(1e9));
    let t = fract(p);
    let corners = lattice_corners(p, period);
    let a = value_point(corners.xy, seed);
    let c = value_point(corners.xw, seed);
    let more = vec2f(value_point(corners.zy, seed) - a, value_point(corners.zw, seed) - c);
    let fade = lattice_fade(t);
    let bent = lattice_fade_bend(t);
    let low = a + fade.x * more.x;
    let rise = c + fade.x * more.y - low;
    let across = more.x + fade.y * (more.y - more.x);
    let bends = vec3f(bent.x * across, fade.z * fade.w * (more.y - more.x), bent.y * rise);
    return bent_noise(low + fade.y * rise, fade.zw * vec2f(across, rise), bends);
}

/// As `value_filter`, where second derivatives are known too.
///
/// Source: as `bent_noise_perlin_filter`.
/// Domain: deviations log in [0.004, 100].
/// Error: 2.5e-2 absolute; the fits.
fn bent_noise_value_filter(deviations: vec2f) -> bend_weights {
    let s = clamp(deviations, vec2f(), vec2f(1e3));
    let u = s * s;
    let lead = 1.0 + 2.18436447 * s.x;
    let wide = 5.47685746 + 2.37705583 * s.x + 3.24728461 * u.y;
    let root = lead / (lead + u.x * wide + 1.30714362 * u.y);
    return bend_filter(value_filter(s), root * root, s, 3.64640884, vec2f(43.7569061, 13.2962974));
}

/// `simplex_part` with its second derivatives.
///
/// Source: as `simplex_part`, by differentiation.
/// Domain: away in [-1, 1], slope unit.
/// Error: 3e-5 absolute; f32 rounding of second derivatives up to 60.
fn bent_noise_simplex_part(away: vec2f, slope: vec2f) -> bent_noise {
    let d = clamp(away, vec2f(-1.0), vec2f(1.0));
    let g = clamp(slope, vec2f(-1.0), vec2f(1.0));
    let w = max(0.5 - dot(d, d), 0.0);
    let cube = 560.0 * w * w * w;
    let weight = 0.125 * cube * w;
    let rise = dot(g, d);
    let squares = 3360.0 * w * w * rise * vec3f(d.x * d.x, d.x * d.y, d.y * d.y);
    let lines = cube * vec3f(rise + 2.0 * g.x * d.x, g.x * d.y + g.y * d.x, rise + 2.0 * g.y * d.y);
    return bent_noise(weight * rise, weight * g - (cube * rise) * d, squares - lines);
}

/// `simplex_noise` with its second derivatives.
///
/// Source: as `simplex_noise`, by differentiation.
/// Domain: position in [-100, 100], seed integer in [0, 4294967295].
/// Error: 4e-5 absolute; f32 rounding of second derivatives up to 60.
fn bent_noise_simplex(position: vec2f, seed: u32) -> bent_noise {
    let p = clamp(position, vec2f(-1e9), vec2f(1e9));
    let corner = floor(p + simplex_skew.x * (p.x + p.y));
    let sum = corner.x + corner.y;
    let near = fract(p) + ((floor(p) - corner) + simplex_back.x * sum) + simplex_back.y * sum;
    let step = select(vec2f(0.0, 1.0), vec2f(1.0, 0.0), near.x > near.y);
    let a = bent_noise_simplex_part(near, perlin_slope(corner, seed));
    let b = bent_noise_simplex_part(near - step + simplex_skew.y, perlin_slope(corner + step, seed));
    let c = bent_noise_simplex_part(near - 1.0 + 2.0 * simplex_skew.y, perlin_slope(corner + 1.0, seed));
    return bent_noise(a.noise + b.noise + c.noise, a.slope + b.slope + c.slope, a.bends + b.bends + c.bends);
}

/// As `simplex_filter`, where second derivatives are known too.
///
/// Source: as `bent_noise_perlin_filter`.
/// Domain: deviations log in [0.004, 100].
/// Error: 2.5e-2 absolute; the fits.
fn bent_noise_simplex_filter(deviations: vec2f) -> bend_weights {
    let s = clamp(deviations, vec2f(), vec2f(1e3));
    let u = s * s;
    let lead = 1.0 + 0.392681830 * s.x;
    let wide = 12.2051622 + 0.300030000 * s.x + 67.6520265 * u.y;
    let root = lead / (lead + u.x * wide + 3.63294875 * u.y);
    return bend_filter(simplex_filter(s), root * root, s, 22.8571429, vec2f(1110.85714, 370.285714));
}
