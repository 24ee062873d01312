// Over all slopes alike, whichever are seen: from straight above every slope counts the same.

fn seen(k: Known) -> Seen {
    let m = values_of(k);
    let green = skin_texture(m.x, m.y);
    let s = slopes_of(k);
    let red = blush_slope(s.mean, s.covariance, k.direction);
    let light = day_irradiance(s.mean, s.covariance + bent(k), vec3f(0.0, 0.0, 1.0), k.x, k.y, k.z);
    let color = red.rgb + (1.0 - red.a) * green;
    return Seen(color, color * light);
}
