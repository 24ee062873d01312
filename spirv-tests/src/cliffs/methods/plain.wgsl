// No filter at all: the maps at the mean height and at the mean slope, and the light on the mean normal.

fn radiance(k: Known) -> vec3f {
    let steepness = length(k.slope);
    let ground = woods_texture(k.mean, 0.0) * bare_texture(steepness, 0.0) + rock_texture(steepness, 0.0);
    return ground * day_irradiance(k.slope, vec3f(), up, east, north, up) / pi;
}
