fn snow(mean: f32, deviation: f32) -> vec3f {
    return mean / deviation;
}
