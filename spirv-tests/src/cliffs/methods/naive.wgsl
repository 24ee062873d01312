// Color and irradiance of the mean height and the mean slope.

fn radiance(k: Known) -> vec3f {
    return tinted(k.mean, 0.0, k.slope, vec3f(), up) * irradiance(k.slope, vec3f(), up);
}
