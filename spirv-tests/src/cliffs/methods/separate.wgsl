// The mean color times the mean irradiance, of heights and slopes by modules of one filter each.

fn tinted(mean: f32, deviation: f32, slope: vec2f, covariance: vec3f, view: vec3f) -> vec3f {
    let ground = ground_height(mean, deviation, slope, covariance, view);
    let bare = bare_steepness(slope, covariance, view, bare_table, bare_sampler);
    return ground * bare + rock_steepness(slope, covariance, view, rock_table, rock_sampler);
}
