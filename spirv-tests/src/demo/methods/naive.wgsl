// The color of the height at the pixel's center: no filter at all.

@group(1) @binding(0) var heights: texture_2d<f32>;
@group(1) @binding(1) var heights_sampler: sampler;

fn shown(position: vec2f, dpdx: vec2f, dpdy: vec2f) -> vec3f {
    return surface_texture(textureSampleLevel(heights, heights_sampler, position, 0.0).x, 0.0);
}
