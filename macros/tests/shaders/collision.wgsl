// The shelf has a function of this name.
fn  normal_cdf(x: f32) -> f32 {
    return x;
}
