// Color over what is seen times irradiance over what is seen.

fn radiance(k: Known) -> vec3f {
    return tinted(k.mean, k.deviation, k.slope, k.covariance, k.view) * irradiance(k.slope, k.covariance, k.view);
}
