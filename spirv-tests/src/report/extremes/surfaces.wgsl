// Formulas as textbooks and renderers have them, with the parameters of the functions of the shelf that the report
// shows beside them: heights, slopes and what hides them.

/// The power of the probability.
fn textbook_power(height: f32, lambda: f32) -> f32 {
    return pow(normal_cdf(height), 1.0 + lambda);
}

/// Mean and variance of visible slopes from R = Φ / (φ + a Φ).
fn textbook_slopes(parameter: f32) -> vec2f {
    let below = normal_cdf(parameter);
    let mean = below / (0.39894228 * exp(-0.5 * parameter * parameter) + parameter * below);
    return vec2f(mean, 2.0 - mean * (mean + parameter));
}

/// The same below the horizon from the tail 1 − Φ, and the weight that normalizes it.
fn textbook_hidden(depth: f32) -> vec3f {
    let above = 1.0 - normal_cdf(depth);
    let weight = 0.39894228 * exp(-0.5 * depth * depth) - depth * above;
    let mean = above / weight;
    return vec3f(mean, 2.0 - mean * (mean - depth), weight);
}

/// The factor with the root of a determinant.
fn textbook_factor(view: vec3f, covariance: vec3f) -> vec4f {
    let toward = normalize(view.xy);
    let product = vec2f(dot(covariance.xy, toward), dot(covariance.yz, toward));
    let reach = sqrt(dot(toward, product));
    let determinant = covariance.x * covariance.z - covariance.y * covariance.y;
    return vec4f(-product / reach, sqrt(determinant) / reach * vec2f(-toward.y, toward.x));
}

/// The difference of two powers over the span, in bits.
fn textbook_shares(bits: f32, span: f32, lambda: f32) -> f32 {
    return (percentile_kink(bits, lambda) - percentile_kink(bits + span, lambda)) / (span * 0.69314718); // ln 2
}

/// cot θ / (√2 σ) from the angle.
fn textbook_angle(direction: vec3f, deviation: f32) -> f32 {
    return clamp(1.0 / (1.41421356 * deviation * tan(acos(direction.z))), 0.0, 10.0);
}

/// Λ by the rational of Walter et al. 2007, "Microfacet Models for Refraction through Rough Surfaces".
fn textbook_rational(parameter: f32) -> f32 {
    let a = parameter;
    return select(0.0, (1.0 - 1.259 * a + 0.396 * a * a) / (3.535 * a + 2.181 * a * a), a < 1.6);
}

/// Λ by the scaled complementary error function, exp(a²) erfc(a).
fn textbook_scaled(parameter: f32) -> f32 {
    let a = parameter;
    let t = 1.0 / (1.0 + 0.3275911 * a); // Abramowitz and Stegun 1964, 7.1.26
    let polynomial = 0.254829592 + t * (-0.284496736 + t * (1.421413741 + t * (-1.453152027 + t * 1.061405429)));
    let scaled = exp(a * a) * (t * polynomial * exp(-a * a));
    return 0.5 * exp(-a * a) * (0.56418958 / a - scaled); // 1/√π
}

/// The angle between azimuths from its cosine.
fn textbook_azimuths(view: vec3f, light: vec3f) -> f32 {
    let angle = acos(dot(normalize(view.xy), normalize(light.xy)));
    return 4.41 * angle / (4.41 * angle + 1.0);
}

/// Lambert's cosine of one facet, with the root of a variance that rounds below 0.
fn textbook_cosine(means: normals_means, light: vec3f) -> f32 {
    let m = means;
    let mean = dot(m.first, light);
    let square = mat3x3f(vec3f(m.level.xy, m.upright.x), vec3f(m.level.yz, m.upright.y), m.upright);
    let deviation = sqrt(dot(light, square * light) - mean * mean);
    return max(mean, 0.0) + deviation * normal_excess(abs(mean / deviation));
}
