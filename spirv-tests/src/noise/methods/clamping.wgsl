// Frequency clamping (Norton, Rockwood and Skolmoski 1982; Bruneton and Neyret 2012, section 6.1.3): what is too fine
// for the pixel's longer side fades out before it is colored.

fn shown(position: Place, dpdx: Place, dpdy: Place) -> vec3f {
    return map_color(noise_clamped(position, longer(dpdx, dpdy)));
}
