// Three blocks with cut corners, each five times as far as the one before and as many times as large. The eye looks
// along y, z is up.

alias Place = vec3f;

// Half of the size of a block a unit of distance.
const half_size = 0.1;
// Distance of the cut corners from the middle, of half the size: those of a cube are at √3.
const cut = 1.28;

const block_azimuths = vec3f(-0.262, 0.0, 0.262);
const block_distances = vec3f(10.0, 50.0, 250.0);
const block_turns = vec3f(0.5, 0.9, 0.2);
const block_tilts = vec3f(0.35, 0.5, 0.62);

const sun = vec3f(-0.55, -0.5, 0.669);

// The axes of a block.
fn axes(number: u32) -> mat3x3f {
    let turn = vec2f(cos(block_turns[number]), sin(block_turns[number]));
    let tilt = vec2f(cos(block_tilts[number]), sin(block_tilts[number]));
    let ahead = vec3f(-turn.y, turn.x, 0.0);
    let up = vec3f(0.0, 0.0, 1.0);
    return mat3x3f(vec3f(turn, 0.0), tilt.x * ahead + tilt.y * up, tilt.x * up - tilt.y * ahead);
}

// The direction of a pair of faces: three of the cube, four of its corners.
fn face(axes: mat3x3f, number: u32) -> vec3f {
    if number < 3u {
        return axes[number];
    }
    let corner = number - 3u;
    let signs = vec3f(1.0, select(-1.0, 1.0, (corner & 1u) == 0u), select(-1.0, 1.0, (corner & 2u) == 0u));
    return axes * signs * 0.577350269; // 1/√3
}

// How far along `way` a block is hit, and the face that is: between the nearer and the farther of all pairs.
fn hit(number: u32, way: vec3f) -> vec4f {
    let distance = block_distances[number];
    let middle = distance * vec3f(sin(block_azimuths[number]), cos(block_azimuths[number]), 0.0);
    let axes = axes(number);
    var enter = 0.0;
    var leave = 1e9;
    var normal = vec3f();
    for (var pair = 0u; pair < 7u; pair++) {
        let direction = face(axes, pair);
        let reach = half_size * distance * select(1.0, cut, pair >= 3u);
        let approach = dot(direction, way);
        let toward = select(approach, 1e-12, abs(approach) < 1e-12);
        let center = dot(direction, middle);
        let near = (center - sign(toward) * reach) / toward;
        leave = min(leave, (center + sign(toward) * reach) / toward);
        if near > enter {
            enter = near;
            normal = -sign(toward) * direction;
        }
    }
    return vec4f(normal, select(1e9, enter, enter < leave));
}

fn seen(pixel: vec2f) -> Seen {
    let way = vec3f(pixel.x, shot.focal, -pixel.y);
    var nearest = vec4f(0.0, 0.0, 0.0, 1e9);
    for (var number = 0u; number < 3u; number++) {
        let found = hit(number, way);
        if found.w < nearest.w {
            nearest = found;
        }
    }
    // A ray's end slides over the face, in the plane that it lies in.
    let normal = nearest.xyz;
    let along = shot.density * nearest.w;
    let slide = way / min(dot(normal, way), -1e-12);
    let right = vec3f(1.0, 0.0, 0.0);
    let down = vec3f(0.0, 0.0, -1.0);
    return Seen(
        shot.origin + along * way,
        along * (right - slide * dot(normal, right)),
        along * (down - slide * dot(normal, down)),
        nearest.w < 1e9,
        0.3 + 0.75 * max(dot(normal, sun), 0.0),
    );
}
