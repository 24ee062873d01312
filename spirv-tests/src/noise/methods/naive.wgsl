// The color of the noise at the pixel's center: no filter at all.

fn shown(position: Place, dpdx: Place, dpdy: Place) -> vec3f {
    return map_color(noise_value(position));
}
