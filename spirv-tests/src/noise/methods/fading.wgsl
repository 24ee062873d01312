// Global fading (Bruneton and Neyret 2012, section 6.1.1): from where a pixel is longer than the smallest features of
// the noise to where it is longer than the largest, the color fades to that of all noise.

fn shown(position: Place, dpdx: Place, dpdy: Place) -> vec3f {
    let sizes = log2(noise_features);
    let faded = smoothstep(sizes.x, sizes.y, log2(longer(dpdx, dpdy)));
    return mix(map_color(noise_value(position)), surface_texture(noise_mean, noise_deviation), faded);
}
