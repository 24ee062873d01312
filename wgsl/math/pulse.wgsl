// Steps, pulses and trains of pulses along one axis, averaged over a footprint: what `step` and a periodic pulse of a
// shader become over a pixel. A Gaussian footprint is given by its deviation, a box by its width; a box of √12 times
// the deviation has the same variance. All are 1 where the unfiltered function is 1 throughout the footprint.
//
// Positions far from the origin cost no digits: trains are reduced to the period around the position first, which is
// exact in f32, and every edge is then compared with what is left.

/// Mean of the step, 1 at `edge` and above, over a Gaussian footprint at a position.
///
/// Source: the definition, Φ((position − edge) / deviation).
/// Domain: position in [-8, 8], edge in [-8, 8], deviation log in [0.001, 10].
/// Error: 5e-7 absolute; that of `normal_cdf`.
fn pulse_step(position: f32, edge: f32, deviation: f32) -> f32 {
    return normal_cdf(clamp((position - edge) / max(deviation, 1e-18), -12.0, 12.0));
}

/// Mean of the step, 1 at `edge` and above, over a box around a position.
///
/// Source: the definition, the share of the box that is above the edge.
/// Domain: position in [-8, 8], edge in [-8, 8], width log in [0.001, 10].
/// Error: 2e-7 absolute; f32 rounding.
fn pulse_step_box(position: f32, edge: f32, width: f32) -> f32 {
    return clamp((position - edge) / max(width, 1e-18) + 0.5, 0.0, 1.0);
}

/// Mean of one pulse, 1 from `low` to `high`, over a Gaussian footprint at a position. 0 where `high` is below `low`.
///
/// Source: the difference of two steps.
/// Domain: position in [-8, 8], low in [-8, 8], high in [-8, 8], deviation log in [0.001, 10].
/// Error: 1e-6 absolute; that of `normal_cdf`, twice.
fn pulse_mean(position: f32, low: f32, high: f32, deviation: f32) -> f32 {
    return max(pulse_step(position, low, deviation) - pulse_step(position, high, deviation), 0.0);
}

/// Mean of one pulse, 1 from `low` to `high`, over a box around a position. 0 where `high` is below `low`.
///
/// Source: the difference of two steps.
/// Domain: position in [-8, 8], low in [-8, 8], high in [-8, 8], width log in [0.001, 10].
/// Error: 2e-7 absolute; f32 rounding.
fn pulse_box(position: f32, low: f32, high: f32, width: f32) -> f32 {
    return max(pulse_step_box(position, low, width) - pulse_step_box(position, high, width), 0.0);
}

/// Mean of a train of pulses, 1 from every whole number on for the share `duty` of the period 1, over a Gaussian
/// footprint at a position.
///
/// Pulses of more than half a period are the gaps of shorter ones. Below a deviation of 0.16 the nearest pulse and the
/// next one on the position's side are summed, above it four terms of the Fourier series: either leaves out 1e-6 at
/// most.
///
/// Source: the definition; the transform of a Gaussian for the series.
/// Domain: position in [-10000, 10000], duty in [0, 1], deviation log in [0.001, 10].
/// Error: 2e-6 absolute; that of `normal_cdf`, four times, and what is left out.
fn pulse_train(position: f32, duty: f32, deviation: f32) -> f32 {
    let x = position - round(position);
    let d = clamp(duty, 0.0, 1.0);
    let gaps = d > 0.5;
    let low = select(0.0, d - 1.0, gaps);
    let high = select(d, 0.0, gaps);
    var share = 0.0;
    if deviation < 0.16 {
        let beside = select(-1.0, 1.0, x + x > low + high);
        share = pulse_mean(x, low, high, deviation) + pulse_mean(x - beside, low, high, deviation);
    } else {
        share = high - low + pulse_waves(x - 0.5 * (low + high), high - low, deviation);
    }
    return clamp(select(share, 1.0 - share, gaps), 0.0, 1.0);
}

/// What a train of pulses of the share `duty`, one of which is centered at 0, has beyond that share over a Gaussian
/// footprint: its first four waves.
///
/// Source: Fourier series, Σ 2 sin(π n duty) cos(2π n position) exp(−2π² n² deviation²) / (π n).
/// Domain: position in [-1, 1], duty in [0, 0.5], deviation log in [0.16, 10].
/// Error: 1e-6 absolute; the fifth wave, and the device's sin, cos and exp.
fn pulse_waves(position: f32, duty: f32, deviation: f32) -> f32 {
    let angle = 6.28318531 * (position - round(position)); // 2π
    let narrow = 3.14159265 * clamp(duty, 0.0, 1.0); // π
    let s = clamp(deviation, 0.0, 1e9);
    let fade = exp(-min(19.7392088 * s * s, 80.0)); // 2π²
    // Multiples of angles follow from those before: sin((n + 1) x) = 2 cos(x) sin(n x) − sin((n − 1) x), and so do
    // powers: (n + 1)² is n² and 2 n + 1.
    let turn = cos(angle);
    let twist = cos(narrow);
    var waves = vec2f(1.0, turn); // of n − 1 and n
    var sines = vec2f(0.0, sin(narrow));
    var power = fade;
    var ratio = fade * fade * fade;
    var sum = 0.0;
    for (var n = 1; n <= 4; n++) {
        sum += sines.y * waves.y * power / f32(n);
        waves = vec2f(waves.y, 2.0 * turn * waves.y - waves.x);
        sines = vec2f(sines.y, 2.0 * twist * sines.y - sines.x);
        power *= ratio;
        ratio *= fade * fade;
    }
    return 0.636619772 * sum; // 2/π
}

/// Mean of a train of pulses, 1 from every whole number on for the share `duty` of the period 1, over a box around a
/// position.
///
/// Source: Apodaca, Gritz 1999, "Advanced RenderMan", section 11.3.1, `filteredpulsetrain`: the difference of the
/// integral at both ends; for boxes within a period every edge is compared with the position, which keeps its digits.
/// Domain: position in [-10000, 10000], duty in [0, 1], width log in [0.001, 10].
/// Error: 4e-7 absolute; f32 rounding.
fn pulse_train_box(position: f32, duty: f32, width: f32) -> f32 {
    let x = position - round(position);
    let d = clamp(duty, 0.0, 1.0);
    if width <= 1.0 {
        // The pulse before, moved so that sums are exact where a narrow box meets its end.
        let shift = select(0.0, 0.5, x < -0.25);
        let before = pulse_box(x + shift, shift - 1.0, d - (1.0 - shift), width);
        return clamp(pulse_box(x, 0.0, d, width) + before, 0.0, 1.0);
    }
    let ends = x + vec2f(-0.5, 0.5) * min(width, 1e9);
    let whole = floor(ends);
    let filled = d * whole + min(ends - whole, vec2f(d));
    return clamp((filled.y - filled.x) / min(width, 1e9), 0.0, 1.0);
}
