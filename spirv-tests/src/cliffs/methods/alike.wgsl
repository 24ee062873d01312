// The mean color times the mean light, over all heights and slopes, whichever are seen.

fn radiance(k: Known) -> vec3f {
    return color(k.mean, k.deviation, k.slope, k.covariance, up) * light(k.slope, k.covariance, up);
}
