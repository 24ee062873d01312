// Lines along two axes over one footprint: how much more of it lies on both than if the axes were independent, which
// they are for a footprint along the axes only. Lines of the share `duty` of the period 1 are centered at whole
// numbers.
//
// Footprints within a quarter of a period see the corners of few lines, wider ones few waves: the covariance is the sum
// over either. Along an axis the footprint's deviation is √xx or √yy, and covariances are (xx, xy, yy).

/// Covariance of the lines across x and the lines across y, as shares of a Gaussian footprint.
///
/// Source: the definition, E[a b] − E[a] E[b] for a and b 1 on a line and 0 beside it.
/// Domain: position in [-4, 4], duties in [0, 1], footprint psd(0.02, 2, 0.99).
/// Error: 0.02 absolute; that of `crossing_waves`, largest for footprints narrower than 0.02 near an axis.
fn crossing_lines(position: vec2f, duties: vec2f, footprint: vec3f) -> f32 {
    // Lines wider than half a period are the gaps of narrower ones.
    let wide = duties > vec2f(0.5);
    let narrow = select(duties, 1.0 - duties, wide);
    let at = position - round(position) - select(vec2f(), vec2f(0.5), wide);
    let sign = select(1.0, -1.0, wide.x != wide.y);
    if max(footprint.x, footprint.z) < 0.0625 {
        return sign * crossing_near(at, narrow, footprint);
    }
    return sign * crossing_waves(at, narrow, footprint, 1.0);
}

/// Covariance of square waves, ½ wide lines, across x and across y, as shares of a Gaussian footprint.
///
/// Source: as `crossing_lines`, of which only odd waves are left.
/// Domain: position in [-4, 4], footprint psd(0.02, 2, 0.99).
/// Error: 0.03 absolute; as `crossing_lines`.
fn crossing_squares(position: vec2f, footprint: vec3f) -> f32 {
    let at = position - round(position);
    if max(footprint.x, footprint.z) < 0.0625 {
        return crossing_near(at, vec2f(0.5), footprint);
    }
    return crossing_waves(at, vec2f(0.5), footprint, 2.0);
}

/// Covariance of lines by the corners of those on both sides of a position, for footprints within a quarter of a
/// period.
///
/// Source: Plackett 1954, "A reduction formula for normal multivariate integrals": the derivative of a normal
/// probability by a covariance is the density at the corner, here integrated over the arc sine of the correlation by
/// Gauss and Legendre's five points (Abramowitz and Stegun 1964, table 25.4).
/// Domain: position in [-1, 1], duties in [0, 0.5], footprint psd(0.01, 0.25, 0.99).
/// Error: 1e-3 absolute; of the five points where the correlation is near one.
fn crossing_near(position: vec2f, duties: vec2f, footprint: vec3f) -> f32 {
    let deviations = sqrt(clamp(footprint.xz, vec2f(1e-18), vec2f(1e36)));
    let at = position - round(position);
    let beside = at - select(vec2f(-1.0), vec2f(1.0), at > vec2f());
    let reach = 0.5 * duties;
    let x = vec4f(at.x + reach.x, at.x - reach.x, beside.x + reach.x, beside.x - reach.x) / deviations.x;
    let y = vec4f(at.y + reach.y, at.y - reach.y, beside.y + reach.y, beside.y - reach.y) / deviations.y;
    let across = clamp(footprint.y, -1e36, 1e36) / (deviations.x * deviations.y);
    let angle = atan2(across, sqrt(max(1.0 - across * across, 1e-12)));
    let low = vec4f(crossing_corners(x, y, 0.0469100770 * angle), crossing_corners(x, y, 0.230765345 * angle),
        crossing_corners(x, y, 0.769234655 * angle), crossing_corners(x, y, 0.953089923 * angle));
    let sum = dot(low, vec4f(0.118463443, 0.239314335, 0.239314335, 0.118463443))
        + 0.284444444 * crossing_corners(x, y, 0.5 * angle);
    return 0.159154943 * angle * sum; // 1/(2π)
}

/// Sum of a normal distribution's densities at sixteen corners, each 1 at its center, with the signs of the edges, + −
/// + − along either axis; the correlation is the sine of the angle.
///
/// Source: density of two correlated normal variables.
/// Domain: x in [-4, 4], y in [-4, 4], angle in [-1.4, 1.4].
/// Error: 2e-6 absolute; f32 rounding of exponents.
fn crossing_corners(x: vec4f, y: vec4f, angle: f32) -> f32 {
    let sine = sin(angle);
    let cosine = cos(angle);
    let narrow = -0.5 / max(cosine * cosine, 1e-9);
    let edges = clamp(y, vec4f(-1e6), vec4f(1e6));
    let round = -0.5 * edges * edges;
    let signs = vec4f(1.0, -1.0, 1.0, -1.0);
    var sum = 0.0;
    for (var edge = 0; edge < 4; edge++) {
        let apart = clamp(x[edge], -1e6, 1e6) * vec4f(1.0) - sine * edges;
        sum += signs[edge] * dot(signs, exp(max(round + narrow * apart * apart, vec4f(-80.0))));
    }
    return sum;
}

/// Covariance of lines by their waves, for footprints of at least a quarter of a period along one axis.
///
/// For each wave along the narrower axis the footprint leaves those along the wider one that turn with it: the nearest
/// three. Every wave is taken, or with a stride of 2 every odd one, all that square waves have; the last is the 32nd.
///
/// Source: Fourier series of both lines; a Gaussian footprint of covariance Σ fades a wave ω by exp(−2π² ωᵀ Σ ω).
/// Domain: position in [-1, 1], duties in [0, 0.5], footprint psd(0.25, 0.8, 0.9), stride integer in [1, 2].
/// Error: 0.006 absolute; waves beyond the last.
fn crossing_waves(position: vec2f, duties: vec2f, footprint: vec3f, stride: f32) -> f32 {
    let upright = footprint.x <= footprint.z;
    let at = select(position.yx, position, upright);
    let duty = select(duties.yx, duties, upright);
    let variances = clamp(select(footprint.zx, footprint.xz, upright), vec2f(1e-30), vec2f(1e30));
    // Of a wave m, m² rest is what the footprint fades in every case, and the best other wave is −m turn.
    let turn = clamp(footprint.y / variances.y, -1.0, 1.0);
    let rest = max(variances.x - turn * turn * variances.y, 0.0);
    // What a footprint along the axes has is the product of the means, which the covariance does not hold.
    let beside = 2.0 * crossing_wave(1.0, duty.y) * cos(6.28318531 * at.y) * exp(-min(19.7392088 * variances.y, 80.0));
    let step = max(stride, 1.0);
    var sum = 0.0;
    for (var wave = 1.0; wave < 32.5; wave += step) {
        if wave * wave * rest > 0.25 { // fades to 0.007
            break;
        }
        let own = 19.7392088 * wave * wave; // 2π²
        let best = -wave * turn;
        let nearest = 1.0 + step * round((best - 1.0) / step);
        let others = nearest + step * vec3f(-1.0, 0.0, 1.0);
        let heights = vec3f(crossing_wave(others.x, duty.y), crossing_wave(others.y, duty.y),
            crossing_wave(others.z, duty.y));
        let turns = wave * at.x + others * at.y;
        let apart = others - best;
        let exponents = own * rest + 19.7392088 * variances.y * apart * apart;
        let waves = heights * cos(6.28318531 * (turns - round(turns))) * exp(-min(exponents, vec3f(80.0)));
        let whole = wave * at.x - round(wave * at.x);
        let alone = cos(6.28318531 * whole) * exp(-min(own * variances.x, 80.0));
        sum += 2.0 * crossing_wave(wave, duty.x) * (waves.x + waves.y + waves.z - beside * alone);
    }
    return sum;
}

/// Height of a wave of lines: the Fourier coefficient of cos(2π wave position) for a wave and for its negative. That of
/// the wave 0, the lines' share, is left out.
///
/// Source: Fourier series of a centered line.
/// Domain: wave integer in [-33, 33], duty in [0, 1].
/// Error: 2e-7 absolute; f32 rounding and the device's sin.
fn crossing_wave(wave: f32, duty: f32) -> f32 {
    let turns = 0.5 * wave * duty;
    return sin(6.28318531 * (turns - round(turns))) / select(3.14159265 * wave, 1e30, wave == 0.0);
}
