// A cut-out whose edge is filtered: alpha is the share of the pixel in which the height is above the threshold.

@group(0) @binding(0) var<uniform> threshold: f32;

@fragment
fn main(@location(0) height: vec2f) -> @location(0) vec4f {
    let coverage = texture_step(height.x - threshold, height.y);
    return vec4f(vec3f(coverage), coverage);
}
