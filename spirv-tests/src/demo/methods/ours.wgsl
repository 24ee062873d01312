// The generated module: one call.

@group(1) @binding(0) var moments: texture_2d<f32>;
@group(1) @binding(1) var moments_sampler: sampler;

fn shown(position: vec2f, dpdx: vec2f, dpdy: vec2f) -> vec3f {
    return surface_color(position, dpdx, dpdy, moments, moments_sampler);
}
