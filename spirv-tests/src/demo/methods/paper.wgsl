// Heitz et al. 2014, section 4.2: the mean and the variance from trilinear mip levels of f and f², and one fetch of the
// table of filtered colors.

@group(1) @binding(0) var heights: texture_2d<f32>;
@group(1) @binding(1) var heights_sampler: sampler;
@group(1) @binding(2) var table: texture_2d<f32>;
@group(1) @binding(3) var table_sampler: sampler;

fn shown(position: vec2f, dpdx: vec2f, dpdy: vec2f) -> vec3f {
    let level = isotropic_level(vec2f(textureDimensions(heights)), dpdx, dpdy);
    let moments = textureSampleLevel(heights, heights_sampler, position, level).xy;
    let deviation = sqrt(max(moments.y - moments.x * moments.x, 0.0));
    return surface_texture(moments.x, deviation, table, table_sampler);
}
