// What a pixel should be: rays through places of a Gaussian pixel filter, each to the noise's value and to the map's
// color there. No footprint, no filter and no table is involved.

// Of every pixel two vectors: sums of colors over what is seen and the number of rays that see something, and their
// sum of light in the first number of the other.
@group(0) @binding(0) var<storage, read_write> sums: array<vec4f>;
// Equally probable offsets from the pixel's middle along an axis, from the lowest up, in pixels.
@group(0) @binding(3) var<storage, read> offsets: array<f32>;
// The logarithm to the base of 2 of the strata an axis, the first stratum of this pass and the one after its last, the
// seed: unsigned.
@group(0) @binding(4) var<storage, read> pass_numbers: array<u32>;

// PCG's output function (O'Neill 2014, RXS-M-XS).
fn stirred(word: u32) -> u32 {
    let state = word * 747796405u + 2891336453u;
    let mixed = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
    return (mixed >> 22u) ^ mixed;
}

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u, @builtin(num_workgroups) groups: vec3u) {
    let index = id.x + id.y * groups.x * 64u;
    if 2u * index >= arrayLength(&sums) {
        return;
    }
    let middle = pixel(index);
    // Offsets and strata are powers of two, and divisions of integers are slow.
    let row = pass_numbers[0];
    let cell = firstTrailingBit(arrayLength(&offsets)) - row;
    var color = vec4f();
    var light = 0.0;
    for (var stratum = pass_numbers[1]; stratum < pass_numbers[2]; stratum++) {
        let drawn = stirred(stratum ^ stirred(index ^ stirred(pass_numbers[3])));
        let within = (1u << cell) - 1u;
        let across = offsets[((stratum & ((1u << row) - 1u)) << cell) + (drawn & within)];
        let down = offsets[((stratum >> row) << cell) + ((drawn >> 16u) & within)];
        let seen = seen(middle + vec2f(across, down));
        if seen.there {
            color += vec4f(map_color(noise_value(seen.position)), 1.0);
            light += seen.light;
        }
    }
    sums[2u * index] = color;
    sums[2u * index + 1u] = vec4f(light);
}
