// The color of the filtered height: the height map has mip levels, the color map is read as if it were linear.

@group(1) @binding(0) var heights: texture_2d<f32>;
@group(1) @binding(1) var heights_sampler: sampler;

fn shown(position: vec2f, dpdx: vec2f, dpdy: vec2f) -> vec3f {
    let level = isotropic_level(vec2f(textureDimensions(heights)), dpdx, dpdy);
    return surface_texture(textureSampleLevel(heights, heights_sampler, position, level).x, 0.0);
}
