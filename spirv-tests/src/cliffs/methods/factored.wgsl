// The mean color times the mean light, over what is seen.

fn radiance(k: Known) -> vec3f {
    return color(k.mean, k.deviation, k.slope, k.covariance, k.view) * light(k.slope, k.covariance, k.view);
}
