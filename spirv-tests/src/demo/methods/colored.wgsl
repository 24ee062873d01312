// The mean color of a pyramid whose first level is the colored height map: right for one map that never changes.

@group(1) @binding(0) var colored: texture_2d<f32>;
@group(1) @binding(1) var colored_sampler: sampler;

fn shown(position: vec2f, dpdx: vec2f, dpdy: vec2f) -> vec3f {
    let level = isotropic_level(vec2f(textureDimensions(colored)), dpdx, dpdy);
    return textureSampleLevel(colored, colored_sampler, position, level).rgb;
}
