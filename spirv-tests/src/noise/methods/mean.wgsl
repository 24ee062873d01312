// The color of the filtered noise: its mean over the pixel, as a mip level would hold it, the color map being read as
// if it were linear.

fn shown(position: Place, dpdx: Place, dpdy: Place) -> vec3f {
    // 0.5: the deviation of the pixel filter.
    return map_color(surface_statistics(position, 0.5 * dpdx, 0.5 * dpdy).x);
}
