// Host side of every method: one invocation a tap. The method declares `seen(k)`: the mean color of what the tap sees,
// and the mean of color times irradiance.

struct Known {
    position: vec2f,
    dpdx: vec2f,
    dpdy: vec2f,
    // How much longer along the body a texel is than around it.
    stretch: f32,
    // Screen derivatives of the base surface's normal.
    dndx: vec3f,
    dndy: vec3f,
    view: vec3f,
    x: vec3f,
    y: vec3f,
    z: vec3f,
    direction: vec2f,
}

struct Seen {
    color: vec3f,
    lit: vec3f,
}

const numbers = 27u;

@group(0) @binding(0) var<storage, read_write> colors: array<vec4f>;
@group(0) @binding(1) var<storage, read> known: array<f32>;
@group(1) @binding(0) var moments: texture_2d<f32>;
@group(1) @binding(1) var moments_sampler: sampler;
@group(1) @binding(2) var slopes: texture_2d<f32>;
@group(1) @binding(3) var slopes_sampler: sampler;
@group(1) @binding(4) var slopes_cross: texture_2d<f32>;
@group(1) @binding(5) var slopes_cross_sampler: sampler;

fn two(at: u32) -> vec2f {
    return vec2f(known[at], known[at + 1u]);
}

fn three(at: u32) -> vec3f {
    return vec3f(known[at], known[at + 1u], known[at + 2u]);
}

fn known_of(tap: u32) -> Known {
    let at = numbers * tap;
    return Known(
        two(at), two(at + 2u), two(at + 4u), known[at + 6u], three(at + 7u), three(at + 10u), three(at + 13u),
        three(at + 16u), three(at + 19u), three(at + 22u), two(at + 25u),
    );
}

fn footprint_of(k: Known) -> vec3f {
    let size = vec2f(textureDimensions(moments, 0));
    return footprint_covariance_round(k.dpdx * size, k.dpdy * size, tap_deviation);
}

// Mean and deviation of the pattern's values over a tap.
fn values_of(k: Known) -> vec2f {
    return moments_read(moments, moments_sampler, k.position, footprint_of(k));
}

// Mean and covariance of the slopes over a tap, on the surface: where the map is stretched along the body, its slopes
// along it are less.
fn slopes_of(k: Known) -> slope_moments {
    let read = slope_moments_read(slopes, slopes_cross, slopes_sampler, k.position, footprint_of(k));
    let s = vec2f(1.0 / k.stretch, 1.0);
    return slope_moments(read.mean * s, read.covariance * s.xxy * s.xyy);
}

// Covariance of the slopes of the base surface over a tap.
fn bent(k: Known) -> vec3f {
    return curvature_covariance_round(k.dndx, k.dndy, k.x, k.y, tap_deviation);
}

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u, @builtin(num_workgroups) groups: vec3u) {
    let tap = id.x + id.y * groups.x * 64u;
    if 2u * tap >= arrayLength(&colors) {
        return;
    }
    let seen = seen(known_of(tap));
    colors[2u * tap] = vec4f(seen.color, 1.0);
    colors[2u * tap + 1u] = vec4f(seen.lit, 1.0);
}
