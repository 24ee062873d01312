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
const pi = 3.14159265;
const east = vec3f(1.0, 0.0, 0.0);
const north = vec3f(0.0, 1.0, 0.0);
const up = vec3f(0.0, 0.0, 1.0);

@group(0) @binding(0) var<storage, read_write> colors: array<vec4f>;
@group(0) @binding(1) var<storage, read> known: array<f32>;
@group(1) @binding(0) var a: texture_2d<f32>;
@group(1) @binding(1) var a_sampler: sampler;
@group(1) @binding(2) var b: texture_2d<f32>;
@group(1) @binding(3) var b_sampler: sampler;
@group(1) @binding(4) var c: texture_2d<f32>;
@group(1) @binding(5) var c_sampler: sampler;
@group(1) @binding(6) var d: texture_2d<f32>;
@group(1) @binding(7) var d_sampler: sampler;

// The generated color, of the heights and slopes that a view sees.
fn color(mean: f32, deviation: f32, slope: vec2f, covariance: vec3f, view: vec3f) -> vec3f {
    return cliffs_combined(
        mean, deviation, slope, covariance, view,
        a, a_sampler, b, b_sampler, c, c_sampler, d, d_sampler,
    );
}

// The generated irradiance of the slopes that a view sees, over pi; the tangent frame is the world's.
fn light(slope: vec2f, covariance: vec3f, view: vec3f) -> vec3f {
    return sky_irradiance(slope, covariance, view, east, north, up) / pi;
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
