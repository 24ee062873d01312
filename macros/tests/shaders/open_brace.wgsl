fn snow(mean: f32, deviation: f32) -> f32 {
    if deviation > 0.0 {
        return texture_step(mean - 0.7, deviation);
    return 0.0;
}
