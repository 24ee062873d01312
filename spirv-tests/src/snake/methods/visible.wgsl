// Over the slopes that are seen. Colors are by slopes of the skin over the body, the light is on both.

fn seen(k: Known) -> Seen {
    let green = skin_color(k.position, k.dpdx, k.dpdy, moments, moments_sampler);
    let s = slopes_of(k);
    let red = blush_slope(s.mean, s.covariance, k.view, k.direction);
    let light = day_irradiance(s.mean, s.covariance + bent(k), k.view, k.x, k.y, k.z);
    return Seen(red.rgb + (1.0 - red.a) * green, light);
}
