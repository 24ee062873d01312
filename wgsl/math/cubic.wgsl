// What a cubic between two values adds to the moments of a curve over a normal variable: see `piece.wgsl`.

/// What a cubic adds at three values of x, each with a weight: sums of q, q², q′ − b and (q′ − b)².
///
/// Source: the definition.
/// Domain: at in [0, 1], parts in [0, 1], coefficients in [-1, 1], slope in [-1, 1].
/// Error: 3e-5 absolute; f32 rounding. The fourth sum is at most 147.
fn cubic_nodes(at: vec3f, parts: vec3f, coefficients: vec4f, slope: f32) -> vec4f {
    let c = coefficients;
    let x = clamp(at, vec3f(-10.0), vec3f(10.0));
    let values = clamp(c.x + x * (c.y + x * (c.z + x * c.w)), vec3f(-1e17), vec3f(1e17));
    let slopes = clamp(c.y - slope + x * (2.0 * c.z + 3.0 * x * c.w), vec3f(-1e17), vec3f(1e17));
    return vec4f(dot(parts, values), dot(parts, values * values), dot(parts, slopes), dot(parts, slopes * slopes));
}

/// What the cubic with these coefficients of 1, x, x² and x³ over x in [0, 1] adds.
///
/// Source: the definition; moments about the mean up to the sixth between ends at least 2.5 deviations apart, else six
/// nodes.
/// Domain: mean in [-3, 4], deviation log in [1e-4, 10], coefficients in [-1, 1], about in [-1, 1].
/// Error: 5e-5 absolute; of moments and of nodes where they take turns. (q′ − b)² is at most 49.
fn cubic_piece(mean: f32, deviation: f32, coefficients: vec4f, about: vec2f) -> vec4f {
    let m = clamp(mean, -1e9, 1e9);
    let s = clamp(deviation, 1e-6, 1e9);
    let r = 1.0 / s;
    let low = clamp(m - 5.0 * s, 0.0, 1.0);
    let high = clamp(m + 5.0 * s, 0.0, 1.0);
    let limit = vec4f(1e16);
    let c = clamp(coefficients - vec4f(about.x, 0.0, 0.0, 0.0), -limit, limit);
    if high - low < 2.5 * s {
        let middle = vec3f(0.5 * (high + low));
        let radius = 0.5 * (high - low);
        let reach = radius * vec3f(0.932469514, 0.661209386, 0.238619186);
        let below = (middle - m - reach) * r;
        let above = (middle - m + reach) * r;
        let weights = 0.3989422804 * radius * r * vec3f(0.171324492, 0.360761573, 0.467913935); // the first is 1/√(2π)
        return cubic_nodes(middle - reach, weights * exp2(-0.7213475204 * below * below), c, about.y) // 1/(2 ln 2)
            + cubic_nodes(middle + reach, weights * exp2(-0.7213475204 * above * above), c, about.y);
    }
    let a = clamp(-m * r, -10.0, 10.0);
    let b = clamp((1.0 - m) * r, -10.0, 10.0);
    // Powers of the ends times the densities there, and the moments from 0 to 6.
    let start = 0.3989422804 * exp2(-0.7213475204 * a * a) * vec3f(1.0, a, a * a);
    let end = 0.3989422804 * exp2(-0.7213475204 * b * b) * vec3f(1.0, b, b * b);
    let edges = start - end;
    let higher = a * a * start - b * b * end;
    let n = vec4f(piece_mass(a, b), edges.x, 0.0, 0.0);
    let second = n.x + edges.y;
    let third = 2.0 * n.y + edges.z;
    let fourth = 3.0 * second + higher.y;
    let fifth = 4.0 * third + higher.z;
    let sixth = 5.0 * fourth + a * a * a * start.z - b * b * b * end.z;
    let bend = (c.z + 3.0 * m * c.w) * s * s;
    let value = c.x + m * (c.y + m * (c.z + m * c.w));
    let slope = c.y + m * (2.0 * c.z + 3.0 * m * c.w);
    let p = vec4f(value, slope * s, bend, c.w * s * s * s);
    let q = vec3f(slope - clamp(about.y, -1e16, 1e16), 2.0 * bend * r, 3.0 * c.w * s * s);
    let v = vec4f(
        dot(p, vec4f(n.x, n.y, second, third)),
        dot(p, vec4f(n.y, second, third, fourth)),
        dot(p, vec4f(second, third, fourth, fifth)),
        dot(p, vec4f(third, fourth, fifth, sixth)),
    );
    let w = vec3f(
        dot(q, vec3f(n.x, n.y, second)),
        dot(q, vec3f(n.y, second, third)),
        dot(q, vec3f(second, third, fourth)),
    );
    return vec4f(v.x, dot(p, v), w.x, dot(q, w));
}
