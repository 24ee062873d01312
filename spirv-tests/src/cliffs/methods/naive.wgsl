// Color and light of the mean height and the mean slope.

fn radiance(k: Known) -> vec3f {
    return color(k.mean, 0.0, k.slope, vec3f(), up) * light(k.slope, vec3f(), up);
}
