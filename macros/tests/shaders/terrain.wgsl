// A fragment of a terrain whose snow line is a hard edge, filtered over the footprint.
const SNOW_LINE = 0.7;

@fragment
fn terrain(@location(0) height: vec2f) -> @location(0) vec4f {
    let snow = texture_step(height.x - SNOW_LINE, sqrt(height.y));
    return vec4f(mix(vec3f(0.21, 0.24, 0.10), vec3f(0.9), snow), 1.0);
}
