fn snow(mean: f32, deviation: f32) -> f32 {
    return texture_setp(mean - 0.7, deviation);
}
