// What every kernel of the demo knows: the frame of the picture, where it is in the noise, and the color map.

struct Shot {
    // Pixels a row and rows.
    size: vec2f,
    // The first pixel's place: right of the line of sight and below the horizon.
    corner: vec2f,
    focal: f32,
    // Units of the noise a unit of the world.
    density: f32,
    // Where the eye, or the ground below it, is in the noise.
    origin: vec3f,
}

// What a ray through the picture sees: a position in the noise, and how that changes over a pixel to the right and
// over a pixel down.
struct Seen {
    position: Place,
    dpdx: Place,
    dpdy: Place,
    // Whether there is anything.
    there: bool,
    // How much light falls on it.
    light: f32,
}

struct Knot {
    // Color to the left of the knot, and its position.
    left: vec4f,
    // Color to the right.
    right: vec4f,
}

@group(0) @binding(1) var<storage, read> shot: Shot;
@group(0) @binding(2) var<storage, read> knots: array<Knot>;

// The place of a pixel's center.
fn pixel(index: u32) -> vec2f {
    let width = u32(shot.size.x);
    return shot.corner + vec2f(f32(index % width), f32(index / width));
}
