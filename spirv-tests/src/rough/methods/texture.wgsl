// View-independent texture filtering: the color map over all heights, whichever are seen. It is given the shadows of
// the others.

fn seen_color(k: Known) -> vec3f {
    return surface_texture(k.mean, k.deviation);
}

fn lit_color(k: Known) -> vec3f {
    return seen_color(k);
}

fn lit_share(k: Known) -> f32 {
    return surface_visibility(k.slope, k.covariance, k.view, k.light);
}
