// Fractional Brownian motion by its definition: six octaves of Perlin's noise, each twice as fine and half as high as
// the one before, turned by half a radian and moved against it, scaled to `plane_scene` of
// examples/data/colormaps.json.

const noise_mean = 0.5;
const noise_deviation = 0.18;
// Sizes of a cell of the finest and of the coarsest octave.
const noise_features = vec2f(0.03125, 1.0);

// Height of the first octave: 0.18 over the root of the sum of ¼ⁱ, i below 6, and of the variance of one octave,
// 181/231 · 535/9009.
const first_height = 0.72274361;

// From an octave to the next: twice the cosine and the sine of a half, and a move.
const finer = mat2x2f(1.75516512, 0.958851077, -0.958851077, 1.75516512);
const move_on = vec2f(0.618033989, 0.414213562);

// One octave and its gradient: the lines of four lattice points, each times its weight. The random words of lattice
// points are the shelf's.
fn octave(position: vec2f, seed: u32) -> vec3f {
    let corner = floor(position);
    var sum = vec3f();
    for (var point = 0u; point < 4u; point++) {
        let place = corner + vec2f(f32(point & 1u), f32(point >> 1u));
        let apart = position - place;
        let t = abs(apart);
        let weight = 1.0 - t * t * t * (10.0 - t * (15.0 - 6.0 * t));
        let steep = -30.0 * apart * t * (1.0 - t) * (1.0 - t);
        // One of 16 directions.
        let angle = 0.392699082 * f32(lattice_word(place, seed) >> 28u);
        let slope = vec2f(cos(angle), sin(angle));
        let line = dot(slope, apart);
        sum += vec3f(
            weight.x * weight.y * line,
            weight.x * weight.y * slope + line * vec2f(steep.x * weight.y, weight.x * steep.y),
        );
    }
    return sum;
}

// The noise and its gradient.
fn octaves(position: vec2f) -> vec3f {
    var sum = vec3f(noise_mean, 0.0, 0.0);
    var at = position;
    var turned = mat2x2f(1.0, 0.0, 0.0, 1.0);
    var height = first_height;
    for (var number = 0u; number < 6u; number++) {
        let noise = octave(at, number);
        sum += height * vec3f(noise.x, noise.yz * turned);
        at = finer * at + move_on;
        turned = finer * turned;
        height *= 0.5;
    }
    return sum;
}

fn noise_value(position: vec2f) -> f32 {
    return octaves(position).x;
}

fn noise_gradient(position: vec2f) -> vec2f {
    return octaves(position).yz;
}

// The noise without what is too fine for a width.
//
// The fade is that of Apodaca and Gritz 1999, "Advanced RenderMan", `filteredsnoise`.
fn noise_clamped(position: vec2f, width: f32) -> f32 {
    var sum = noise_mean;
    var at = position;
    var cells = width;
    var height = first_height;
    for (var number = 0u; number < 6u; number++) {
        sum += height * (1.0 - smoothstep(0.2, 0.75, cells)) * octave(at, number).x;
        at = finer * at + move_on;
        cells *= 2.0;
        height *= 0.5;
    }
    return sum;
}
