fn snow(mean: f32, deviation: f32) -> f32 {
    let distance = mean - 0.7
    return texture_step(distance, deviation);
}
