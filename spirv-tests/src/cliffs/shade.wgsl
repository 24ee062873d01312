// Host side of every method: one invocation a tap. The method declares `radiance(k)`, the mean light that reaches the
// eye of what the tap sees.

struct Known {
    mean: f32,
    deviation: f32,
    slope: vec2f,
    covariance: vec3f,
    view: vec3f,
}

const numbers = 10u;
const up = vec3f(0.0, 0.0, 1.0);

@group(0) @binding(0) var<storage, read_write> colors: array<vec4f>;
@group(0) @binding(1) var<storage, read> known: array<f32>;
@group(1) @binding(0) var bare_table: texture_2d<f32>;
@group(1) @binding(1) var bare_sampler: sampler;
@group(1) @binding(2) var rock_table: texture_2d<f32>;
@group(1) @binding(3) var rock_sampler: sampler;

// Irradiance over pi, of the slopes that a view sees.
fn irradiance(slope: vec2f, covariance: vec3f, view: vec3f) -> vec3f {
    return sky_irradiance(slope, covariance, view, vec3f(1.0, 0.0, 0.0), vec3f(0.0, 1.0, 0.0), up) / 3.14159265;
}

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u, @builtin(num_workgroups) groups: vec3u) {
    let index = id.x + id.y * groups.x * 64u;
    if index >= arrayLength(&colors) {
        return;
    }
    let at = numbers * index;
    let slope = vec2f(known[at + 2u], known[at + 3u]);
    let covariance = vec3f(known[at + 4u], known[at + 5u], known[at + 6u]);
    let view = vec3f(known[at + 7u], known[at + 8u], known[at + 9u]);
    colors[index] = vec4f(radiance(Known(known[at], known[at + 1u], slope, covariance, view)), 1.0);
}
