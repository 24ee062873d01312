// The generated module: one call.

fn shown(position: Place, dpdx: Place, dpdy: Place) -> vec3f {
    return surface_color(position, dpdx, dpdy);
}
