// Host side of every method: one invocation a pixel. The method declares `seen_color` and `lit_color`, the mean colors
// over what is seen and over what of it is lit, and `lit_share`, the part that is lit of what faces the light.

struct Known {
    mean: f32,
    deviation: f32,
    slope: vec2f,
    covariance: vec3f,
    view: vec3f,
    light: vec3f,
    facing: f32,
}

const numbers = 14u;

@group(0) @binding(0) var<storage, read_write> colors: array<vec4f>;
@group(0) @binding(1) var<storage, read> known: array<f32>;

fn known_of(pixel: u32) -> Known {
    let at = numbers * pixel;
    let slope = vec2f(known[at + 2u], known[at + 3u]);
    let covariance = vec3f(known[at + 4u], known[at + 5u], known[at + 6u]);
    let view = vec3f(known[at + 7u], known[at + 8u], known[at + 9u]);
    let light = vec3f(known[at + 10u], known[at + 11u], known[at + 12u]);
    return Known(known[at], known[at + 1u], slope, covariance, view, light, known[at + 13u]);
}

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u, @builtin(num_workgroups) groups: vec3u) {
    let pixel = id.x + id.y * groups.x * 64u;
    if 2u * pixel >= arrayLength(&colors) {
        return;
    }
    let k = known_of(pixel);
    colors[2u * pixel] = vec4f(seen_color(k), k.facing * lit_share(k));
    colors[2u * pixel + 1u] = vec4f(lit_color(k), 0.0);
}
