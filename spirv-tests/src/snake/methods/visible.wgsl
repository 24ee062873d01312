// Over the slopes that are seen. Colors are by slopes of the skin over the body, the light is on both.

fn seen(k: Known) -> Seen {
    let m = values_of(k);
    let green = skin_texture(m.x, m.y);
    let s = slopes_of(k);
    let red = blush_slope(s.mean, s.covariance, k.view, k.direction);
    let light = day_irradiance(s.mean, s.covariance + bent(k), k.view, k.x, k.y, k.z);
    let color = red.rgb + (1.0 - red.a) * green;
    return Seen(color, color * light);
}
