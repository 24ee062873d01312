// The color map by its definition, for methods and the truth that do not filter it in closed form.

// The color at a value: straight lines between the knots, constant outside.
fn map_color(value: f32) -> vec3f {
    let count = arrayLength(&knots);
    if value < knots[0].left.w {
        return knots[0].left.xyz;
    }
    var color = knots[count - 1u].right.xyz;
    for (var next = 1u; next < count; next++) {
        let start = knots[next - 1u].left.w;
        let end = knots[next].left.w;
        if value >= start && value < end {
            color = mix(knots[next - 1u].right.xyz, knots[next].left.xyz, (value - start) / (end - start));
        }
    }
    return color;
}
