// Heitz et al. 2014, section 4.2: the filtered noise, the deviation that pixels of such a size hide of it on average,
// and one fetch of the table of filtered colors.

@group(1) @binding(0) var table: texture_2d<f32>;
@group(1) @binding(1) var table_sampler: sampler;

fn shown(position: Place, dpdx: Place, dpdy: Place) -> vec3f {
    return surface_color(position, dpdx, dpdy, table, table_sampler);
}
