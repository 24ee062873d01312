// Host side of every method: one invocation a pixel of a plane in perspective. The method declares
// `shown(position, dpdx, dpdy)`: the color of a pixel whose center sees `position` in texture coordinates, which
// changes by dpdx over a pixel to the right and by dpdy over a pixel down.

struct Plane {
    width: f32,
    height: f32,
    // The first pixel's place: right of the middle and below the horizon.
    first: vec2f,
    focal: f32,
    turn: f32,
    periods: vec2f,
    origin: vec2f,
}

@group(0) @binding(0) var<storage, read_write> colors: array<vec4f>;
@group(0) @binding(1) var<storage, read> plane: Plane;

fn turned(ground: vec2f) -> vec2f {
    let c = cos(plane.turn);
    let s = sin(plane.turn);
    return plane.periods * vec2f(c * ground.x - s * ground.y, s * ground.x + c * ground.y);
}

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u, @builtin(num_workgroups) groups: vec3u) {
    let index = id.x + id.y * groups.x * 64u;
    if index >= arrayLength(&colors) {
        return;
    }
    let width = u32(plane.width);
    let pixel = plane.first + vec2f(f32(index % width), f32(index / width));
    let near = 1.0 / pixel.y;
    let position = plane.origin + turned(near * vec2f(pixel.x, plane.focal));
    let dpdx = turned(vec2f(near, 0.0));
    let dpdy = turned(-near * near * vec2f(pixel.x, plane.focal));
    colors[index] = vec4f(shown(position, dpdx, dpdy), 1.0);
}

// The level of a pyramid whose texels are as wide as the longer side of the pixel: what hardware picks without
// anisotropic filtering.
fn isotropic_level(size: vec2f, dpdx: vec2f, dpdy: vec2f) -> f32 {
    let x = dpdx * size;
    let y = dpdy * size;
    return 0.5 * log2(max(dot(x, x), dot(y, y)));
}
