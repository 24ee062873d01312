// Hart et al. 1999, "Antialiased Parameterized Solid Texturing Simplified for Consumer-Level Hardware Implementation"
// (Bruneton and Neyret 2012, equation 39): the mean of the map over the values between which the noise varies if it is
// linear over the pixel, from a table of the map's integral. Here the integral is exact, and the interval has the
// deviation that the linear noise has.

// The integral of the map from its first knot to a value.
fn integral(value: f32) -> vec3f {
    let count = arrayLength(&knots);
    var sum = knots[0].left.xyz * min(value - knots[0].left.w, 0.0);
    sum += knots[count - 1u].right.xyz * max(value - knots[count - 1u].left.w, 0.0);
    for (var next = 1u; next < count; next++) {
        let start = knots[next - 1u].left.w;
        let along = clamp(value, start, knots[next].left.w) - start;
        let end = mix(knots[next - 1u].right.xyz, knots[next].left.xyz, along / (knots[next].left.w - start));
        sum += 0.5 * along * (knots[next - 1u].right.xyz + end);
    }
    return sum;
}

fn shown(position: Place, dpdx: Place, dpdy: Place) -> vec3f {
    let value = noise_value(position);
    let gradient = noise_gradient(position);
    // 0.5: the deviation of the pixel filter. An interval is √12 of its deviations wide.
    let reach = 0.5 * sqrt(3.0) * length(vec2f(dot(gradient, dpdx), dot(gradient, dpdy)));
    if reach < 1e-3 {
        return map_color(value);
    }
    return (integral(value + reach) - integral(value - reach)) / (2.0 * reach);
}
