// Color and irradiance over all heights and slopes, whichever are seen.

fn radiance(k: Known) -> vec3f {
    return tinted(k.mean, k.deviation, k.slope, k.covariance, up) * irradiance(k.slope, k.covariance, up);
}
