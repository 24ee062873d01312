fn snow(mean: f32, deviation: f32) -> vec3f {
    return texture_step(mean - 0.7, deviation);
}
