// The generated module with its table. From the zenith everything is lit.

@group(1) @binding(0) var table: texture_3d<f32>;
@group(1) @binding(1) var table_sampler: sampler;

fn seen_color(k: Known) -> vec3f {
    let up = vec3f(0.0, 0.0, 1.0);
    return surface_height(k.mean, k.deviation, k.slope, k.covariance, k.view, up, table, table_sampler);
}

fn lit_color(k: Known) -> vec3f {
    return surface_height(k.mean, k.deviation, k.slope, k.covariance, k.view, k.light, table, table_sampler);
}

fn lit_share(k: Known) -> f32 {
    return surface_visibility(k.slope, k.covariance, k.view, k.light);
}
