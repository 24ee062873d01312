// Host side of every method: one invocation a pixel. The method declares `shown(position, dpdx, dpdy)`: the color of a
// pixel whose center sees a position. Written are the color and the length of the pixel's longer side, 0 for nothing.

@group(0) @binding(0) var<storage, read_write> colors: array<vec4f>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u, @builtin(num_workgroups) groups: vec3u) {
    let index = id.x + id.y * groups.x * 64u;
    if index >= arrayLength(&colors) {
        return;
    }
    let seen = seen(pixel(index));
    if !seen.there {
        colors[index] = vec4f();
        return;
    }
    let color = shown(seen.position, seen.dpdx, seen.dpdy);
    colors[index] = vec4f(color, longer(seen.dpdx, seen.dpdy));
}

// The length of the longer side of a pixel.
fn longer(dpdx: Place, dpdy: Place) -> f32 {
    return sqrt(max(dot(dpdx, dpdx), dot(dpdy, dpdy)));
}
