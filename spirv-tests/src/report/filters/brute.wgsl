// Stratified samples of what a pixel covers, by no function of the shelf.

/// 32 bits of a hash.
///
/// Source: O'Neill 2014, "PCG: A Family of Simple Fast Space-Efficient Statistically Good Algorithms for Random Number
/// Generation", RXS-M-XS.
fn brute_bits(seed: u32) -> u32 {
    let state = seed * 747796405u + 2891336453u;
    let word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
    return (word >> 22u) ^ word;
}

/// A random point of stratum `index` of the unit square, which has `side` × `side` strata.
fn brute_point(index: u32, side: u32, seed: u32) -> vec2f {
    let bits = brute_bits(seed * 65536u + index);
    let jitter = (vec2f(f32(bits & 0xffffu), f32(bits >> 16u)) + 0.5) / 65536.0;
    return (vec2f(f32(index % side), f32(index / side)) + jitter) / f32(side);
}

/// A random number of one of `count` strata of 0 to 1, a power of two, all of which come up once, in an order by an odd
/// stride.
fn brute_number(index: u32, count: u32, stride: u32, seed: u32) -> f32 {
    let stratum = (index * stride + brute_bits(seed + stride)) % count;
    let bits = brute_bits(seed * 65536u + index + 8192u * stride);
    return (f32(stratum) + (f32(bits >> 16u) + 0.5) / 65536.0) / f32(count);
}

/// The value that a standard normal variable is below with a probability, and above with the rest.
///
/// Source: Giles 2010, "Approximating the erfinv function", single precision: within 2e-6 from 3e-8 on.
fn brute_quantile(below: f32, above: f32) -> f32 {
    let w = -log(4.0 * below * above);
    var root = 0.0;
    if w < 5.0 {
        let x = w - 2.5;
        root = 2.81022636e-08;
        root = 3.43273939e-07 + root * x;
        root = -3.5233877e-06 + root * x;
        root = -4.39150654e-06 + root * x;
        root = 0.00021858087 + root * x;
        root = -0.00125372503 + root * x;
        root = -0.00417768164 + root * x;
        root = 0.246640727 + root * x;
        root = 1.50140941 + root * x;
    } else {
        let x = sqrt(w) - 3.0;
        root = -0.000200214257;
        root = 0.000100950558 + root * x;
        root = 0.00134934322 + root * x;
        root = -0.00367342844 + root * x;
        root = 0.00573950773 + root * x;
        root = -0.0076224613 + root * x;
        root = 0.00943887047 + root * x;
        root = 1.00167406 + root * x;
        root = 2.83297682 + root * x;
    }
    return 1.41421356 * root * (below - above);
}

/// The complementary error function.
///
/// Source: Press, Teukolsky, Vetterling and Flannery 1992, "Numerical Recipes in C", section 6.2, `erfcc`: within 1e-5
/// of itself.
fn brute_erfc(x: f32) -> f32 {
    let t = 1.0 / (1.0 + 0.5 * abs(x));
    var sum = 0.17087277;
    sum = -0.82215223 + t * sum;
    sum = 1.48851587 + t * sum;
    sum = -1.13520398 + t * sum;
    sum = 0.27886807 + t * sum;
    sum = -0.18628806 + t * sum;
    sum = 0.09678418 + t * sum;
    sum = 0.37409196 + t * sum;
    sum = 1.00002368 + t * sum;
    let tail = t * exp(-x * x - 1.26551223 + t * sum);
    return select(2.0 - tail, tail, x >= 0.0);
}

/// Smith's lambda of a direction above a level surface of normal slopes.
///
/// Source: Heitz et al. 2014, "Filtering Non-Linear Transfer Functions on Surfaces", equation 2.
fn brute_lambda(direction: vec3f, covariance: vec3f) -> f32 {
    let d = direction.xy;
    let variance = d.x * d.x * covariance.x + 2.0 * d.x * d.y * covariance.y + d.y * d.y * covariance.z;
    let a = direction.z / sqrt(max(2.0 * variance, 1e-12));
    return max(exp(-min(a * a, 80.0)) / (3.54490770 * a) - 0.5 * brute_erfc(a), 0.0);
}

/// A slope of a normal distribution.
fn brute_slope(point: vec2f, mean: vec2f, covariance: vec3f) -> vec2f {
    let z = vec2f(brute_quantile(point.x, 1.0 - point.x), brute_quantile(point.y, 1.0 - point.y));
    let x = sqrt(covariance.x);
    let mixed = covariance.y / x;
    return mean + vec2f(x * z.x, mixed * z.x + sqrt(max(covariance.z - mixed * mixed, 0.0)) * z.y);
}
