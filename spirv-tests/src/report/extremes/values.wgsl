// Formulas as textbooks and renderers have them, with the parameters of the functions of the shelf that the report
// shows beside them: values, footprints and patterns.

/// Moments of a mixture from raw moments: E[x²] − E[x]² and its likes.
fn textbook_moments(first: four_moments, second: four_moments, weight: f32) -> four_moments {
    let mean = mix(first.mean, second.mean, weight);
    let a = first.mean;
    let b = second.mean;
    let squares = mix(first.variance + a * a, second.variance + b * b, weight);
    let cubes = mix(first.third + 3.0 * a * first.variance + a * a * a,
        second.third + 3.0 * b * second.variance + b * b * b, weight);
    let fourths = mix(first.fourth + 4.0 * a * first.third + 6.0 * a * a * first.variance + a * a * a * a,
        second.fourth + 4.0 * b * second.third + 6.0 * b * b * second.variance + b * b * b * b, weight);
    return four_moments(
        mean,
        squares - mean * mean,
        cubes - 3.0 * mean * squares + 2.0 * mean * mean * mean,
        fourths - 4.0 * mean * cubes + 6.0 * mean * mean * squares - 3.0 * mean * mean * mean * mean,
    );
}

/// A number as 16 bits hold it.
fn textbook_half(x: vec4f) -> vec4f {
    let bits = bitcast<vec4u>(x);
    return bitcast<vec4f>((bits + 4095u + ((bits >> vec4u(13u)) & vec4u(1u))) & vec4u(0xffffe000u));
}

/// Mean and variance of four texels that hold E[x] and E[x²] in 16 bits.
fn textbook_halves(cell: moments_cell) -> vec2f {
    let first = textbook_half(cell.means);
    let second = textbook_half(cell.means * cell.means + cell.deviations * cell.deviations);
    let f = cell.fraction;
    let weights = vec4f((1.0 - f.x) * (1.0 - f.y), f.x * (1.0 - f.y), (1.0 - f.x) * f.y, f.x * f.y);
    let mean = dot(weights, first);
    return vec2f(mean, dot(weights, second) - mean * mean);
}

/// The logarithm of a probability next to 1.
fn textbook_upper_tail(x: f32) -> f32 {
    return -log2(normal_cdf(x));
}

/// The logarithm of 1 + erf next to −1, with the error function of Abramowitz and Stegun 1964, 7.1.26.
fn textbook_lower_tail(x: f32) -> f32 {
    let y = abs(x) * 0.707106781; // 1/√2
    let t = 1.0 / (1.0 + 0.3275911 * y);
    let polynomial = 0.254829592 + t * (-0.284496736 + t * (1.421413741 + t * (-1.453152027 + t * 1.061405429)));
    let erf = 1.0 - t * polynomial * exp(-y * y);
    return -log2(0.5 * (1.0 + select(erf, -erf, x < 0.0)));
}

/// Eigenvalues from trace and determinant.
fn textbook_axes(covariance: vec3f) -> vec2f {
    let half = 0.5 * (covariance.x + covariance.z);
    let radius = sqrt(half * half - (covariance.x * covariance.z - covariance.y * covariance.y));
    return sqrt(vec2f(half + radius, half - radius));
}

/// The eigenvector (xy, λ − xx).
fn textbook_direction(covariance: vec3f) -> vec2f {
    let half = 0.5 * (covariance.x + covariance.z);
    let radius = sqrt(half * half - (covariance.x * covariance.z - covariance.y * covariance.y));
    return normalize(vec2f(covariance.y, half + radius - covariance.x));
}

/// The difference of two kinks over the width.
fn textbook_ramp(distance: f32, width: f32, deviation: f32) -> f32 {
    let first = max(distance, 0.0) + deviation * normal_excess(abs(distance) / deviation);
    let past = distance - width;
    let second = max(past, 0.0) + deviation * normal_excess(abs(past) / deviation);
    return (first - second) / width;
}

/// The difference of the integral at both ends of the box over its width.
fn textbook_pulses(position: f32, duty: f32, width: f32) -> f32 {
    let ends = position + vec2f(-0.5, 0.5) * width;
    let filled = duty * floor(ends) + min(fract(ends), vec2f(duty));
    return (filled.y - filled.x) / width;
}

/// A wave of a point, its phase not reduced.
fn textbook_wave(position: vec2f, across: vec2f, along: vec2f, wave: vec4f) -> cosines_sum {
    let angle = 6.28318531 * (dot(wave.xy, position) + wave.w); // 2π
    let turned = 6.28318531 * wave.xy;
    let curvature = -wave.z * cos(angle) * vec3f(turned.x * turned.x, turned.x * turned.y, turned.y * turned.y);
    return cosines_sum(wave.z * cos(angle), 0.0, -wave.z * sin(angle) * turned, curvature, vec3f());
}

/// Two normal distributions by Cardano's root of 2 u³ + kurtosis u = skewness².
fn textbook_mixture(skewness: f32, kurtosis: f32) -> mixture {
    let half = 0.25 * skewness * skewness;
    let root = sqrt(half * half + kurtosis * kurtosis * kurtosis / 216.0);
    let u = pow(half + root, 1.0 / 3.0) - pow(root - half, 1.0 / 3.0);
    let apart = sqrt(skewness * skewness / (u * u) + 4.0 * u);
    let light = 0.5 - 0.5 * skewness / (u * apart);
    return mixture(vec2f(1.0 - light, -light) * apart, vec2f(light, 1.0 - light), sqrt(1.0 - u));
}

/// Mean of max(x, 0) as x Φ + σ φ, with the error function of Abramowitz and Stegun 1964, 7.1.26.
fn textbook_kink(distance: f32, deviation: f32) -> f32 {
    let x = distance / deviation;
    let y = abs(x) * 0.707106781; // 1/√2
    let t = 1.0 / (1.0 + 0.3275911 * y);
    let polynomial = 0.254829592 + t * (-0.284496736 + t * (1.421413741 + t * (-1.453152027 + t * 1.061405429)));
    let tail = 0.5 * t * polynomial * exp(-y * y);
    return distance * select(1.0 - tail, tail, x < 0.0) + deviation * 0.39894228 * exp(-0.5 * x * x);
}

/// The difference of two kinks over the width, of values that may not vary.
fn textbook_sharp_ramp(distance: f32, width: f32, deviation: f32) -> f32 {
    return (textbook_kink(distance, deviation) - textbook_kink(distance - width, deviation)) / width;
}
