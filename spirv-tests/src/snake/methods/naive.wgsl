// The maps at the mean value and at the mean slope, and the light on the mean normal: no filter at all.

fn seen(k: Known) -> Seen {
    let m = values_of(k);
    let green = skin_texture(m.x, 0.0);
    let slope = slopes_of(k).mean;
    let red = blush_slope(slope, vec3f(), k.direction);
    let light = day_irradiance(slope, vec3f(), vec3f(0.0, 0.0, 1.0), k.x, k.y, k.z);
    let color = red.rgb + (1.0 - red.a) * green;
    return Seen(color, color * light);
}
