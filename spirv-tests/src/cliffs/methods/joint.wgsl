// The mean of color times light, over what is seen.

fn radiance(k: Known) -> vec3f {
    return cliffs_lit(
        k.mean, k.deviation, k.slope, k.covariance, k.view, east, north, up,
        a, a_sampler, b, b_sampler, c, c_sampler, d, d_sampler,
    ) / pi;
}
