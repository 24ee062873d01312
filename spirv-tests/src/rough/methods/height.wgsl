// The generated module. From the zenith everything is lit.

fn seen_color(k: Known) -> vec3f {
    return surface_height(k.mean, k.deviation, k.slope, k.covariance, k.view, vec3f(0.0, 0.0, 1.0));
}

fn lit_color(k: Known) -> vec3f {
    return surface_height(k.mean, k.deviation, k.slope, k.covariance, k.view, k.light);
}

fn lit_share(k: Known) -> f32 {
    return surface_visibility(k.slope, k.covariance, k.view, k.light);
}
