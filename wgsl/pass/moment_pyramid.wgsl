// Levels of a pyramid of moments, texel by texel: what a pass stores that builds the pyramid on the device. Its entry
// points are `prefilter::gpu::MomentPass`.
//
// First the moments of the image's bilinear reconstruction over the area of each of its texels; then any level from
// them, or from a level in whose texels its own nest: of each row the parts, and of the columns of these parts the
// parts again. Boxes are products, and mixtures of mixtures are mixtures.

/// Texels whose contributions are summed apart, so that rounding grows with the root of their number.
const moment_pyramid_block = 64u;

/// The image's value at a texel, which may be one step beyond the edges; the first channel.
///
/// Source: the address modes of samplers.
/// Domain: x integer in [-1, 13], y integer in [-1, 7], repeats integer in [0, 1].
/// Error: exact.
fn moment_pyramid_value(image: texture_2d<f32>, x: i32, y: i32, repeats: bool) -> f32 {
    let size = vec2i(textureDimensions(image, 0));
    let at = vec2i(x, y);
    let inside = select(clamp(at, vec2i(), size - 1), ((at % size) + size) % size, repeats);
    return textureLoad(image, inside, 0).x;
}

/// Central moments of the bilinear reconstruction over a quarter of a texel, about the value at the texel's center:
/// the quarter towards the neighbor at (x + side.x, y + side.y).
///
/// There it is c + p u + q v + r u v about the quarter's center, with u and v uniform in [-1/2, 1/2].
///
/// Source: moments of a uniform variable, E[u²] = 1/12 and E[u⁴] = 1/80.
/// Domain: x integer in [0, 12], y integer in [0, 6], right integer in [0, 1], below integer in [0, 1],
/// repeats integer in [0, 1].
/// Error: 3e-8 absolute; f32 rounding.
fn moment_pyramid_quarter(
    image: texture_2d<f32>,
    x: i32,
    y: i32,
    right: bool,
    below: bool,
    repeats: bool,
) -> four_moments {
    let side = x + select(-1, 1, right);
    let level = y + select(-1, 1, below);
    let own = moment_pyramid_value(image, x, y, repeats);
    let beside = vec3f(
        moment_pyramid_value(image, side, y, repeats),
        moment_pyramid_value(image, x, level, repeats),
        moment_pyramid_value(image, side, level, repeats),
    );
    // Relative to the texel: equal values leave exact zeros.
    let apart = clamp(beside - own, vec3f(-2e7), vec3f(2e7));
    let across = 0.5 * apart.x;
    let down = 0.5 * apart.y;
    let corner = 0.25 * (apart.x + apart.y + apart.z);
    let p = 0.5 * (across - down + corner);
    let q = 0.5 * (down - across + corner);
    let r = corner - across - down;
    let squares = vec3f(p * p, q * q, r * r);
    let fourths = dot(squares * squares, vec3f(1.0 / 80.0, 1.0 / 80.0, 1.0 / 6400.0));
    return four_moments(
        0.25 * (across + down + corner),
        dot(squares, vec3f(1.0 / 12.0, 1.0 / 12.0, 1.0 / 144.0)),
        p * q * r / 24.0,
        fourths + squares.x * squares.y / 24.0 + (squares.x + squares.y) * squares.z / 160.0,
    );
}

/// Central moments of the bilinear reconstruction over the area of a texel, `repeats` where the image goes on with
/// itself beyond its edges and not with the texels there.
///
/// Source: the mixture of the texel's quarters.
/// Domain: x integer in [0, 12], y integer in [0, 6], repeats integer in [0, 1].
/// Error: 8e-8 absolute; f32 rounding.
fn moment_pyramid_texel(image: texture_2d<f32>, x: i32, y: i32, repeats: bool) -> four_moments {
    let above = four_moments_pair(
        moment_pyramid_quarter(image, x, y, false, false, repeats),
        moment_pyramid_quarter(image, x, y, true, false, repeats),
        0.5,
    );
    let below = four_moments_pair(
        moment_pyramid_quarter(image, x, y, false, true, repeats),
        moment_pyramid_quarter(image, x, y, true, true, repeats),
        0.5,
    );
    let all = four_moments_pair(above, below, 0.5);
    let own = moment_pyramid_value(image, x, y, repeats);
    return four_moments(own + all.mean, all.variance, all.third, all.fourth);
}

/// Central moments over part `index` of `count` equal parts of row `number` of texels, or of a column where not
/// `across`.
///
/// Source: the mixture of the texels, each weighted by the length of it that the part covers.
/// Domain: across integer in [0, 1], number integer in [0, 6], index integer in [0, 4], count integer in [5, 7].
/// Error: 1.2e-7 absolute; f32 rounding.
fn moment_pyramid_part(level: texture_2d<f32>, across: bool, number: i32, index: i32, count: i32) -> four_moments {
    let step = select(vec2i(0, 1), vec2i(1, 0), across);
    let begin = step.yx * max(number, 0);
    let size = textureDimensions(level, 0);
    let length = select(size.y, size.x, across);
    let parts = u32(clamp(count, 1, 16384));
    // In units of 1 / (length · parts) of the side every edge is an integer.
    let low = u32(clamp(index, 0, i32(parts) - 1)) * length;
    let high = low + length;
    let last = (high + parts - 1u) / parts;
    let first = four_moments_central(textureLoad(level, begin + step * i32(low / parts), 0));
    var mean = 0.0;
    for (var block = low / parts; block < last; block += moment_pyramid_block) {
        var sum = 0.0;
        for (var at = block; at < min(block + moment_pyramid_block, last); at++) {
            let share = f32(min(high, (at + 1u) * parts) - max(low, at * parts)) / f32(length);
            sum += share * (textureLoad(level, begin + step * i32(at), 0).x - first.mean);
        }
        mean += sum;
    }
    mean += first.mean;
    var central = vec3f();
    for (var block = low / parts; block < last; block += moment_pyramid_block) {
        var sum = vec3f();
        for (var at = block; at < min(block + moment_pyramid_block, last); at++) {
            let share = f32(min(high, (at + 1u) * parts) - max(low, at * parts)) / f32(length);
            let texel = four_moments_central(textureLoad(level, begin + step * i32(at), 0));
            sum += share * four_moments_about(texel, mean);
        }
        central += sum;
    }
    return four_moments(mean, central.x, central.y, central.z);
}

/// A texel of the pyramid: mean, deviation, skewness and excess kurtosis.
///
/// Source: the definition of the deviation.
/// Domain: moments.mean in [-1, 1], moments.variance in [0.05, 1], moments.third in [-0.1, 0.1],
/// moments.fourth in [3, 6].
/// Error: 8e-7 relative; f32 rounding, and a division of 2.5 units that devices may have.
fn moment_pyramid_stored(moments: four_moments) -> vec4f {
    let standard = four_moments_standard(moments);
    return vec4f(standard.x, sqrt(standard.y), standard.zw);
}
