// The colored pyramid with the anisotropic filtering of hardware, by its specification
// (EXT_texture_filter_anisotropic): up to 8 trilinear taps along the longer side of the pixel.

@group(1) @binding(0) var colored: texture_2d<f32>;
@group(1) @binding(1) var colored_sampler: sampler;

fn shown(position: vec2f, dpdx: vec2f, dpdy: vec2f) -> vec3f {
    let size = vec2f(textureDimensions(colored));
    let x = length(dpdx * size);
    let y = length(dpdy * size);
    let longer = max(x, y);
    let taps = clamp(ceil(longer / min(x, y)), 1.0, 8.0);
    let level = log2(longer / taps);
    let along = select(dpdy, dpdx, x > y);
    var sum = vec3f();
    for (var tap = 0.0; tap < taps; tap += 1.0) {
        let place = position + along * ((tap + 0.5) / taps - 0.5);
        sum += textureSampleLevel(colored, colored_sampler, place, level).rgb;
    }
    return sum / taps;
}
