// Irradiance over visible normals: light of order 2, and Lambert's cosine of one light.
//
// Both are functions of the means of n and n nᵀ over the normals that the view sees (`normals_means`).

/// The means in another frame, whose axes the columns are: from the tangent frame to the world.
///
/// Source: the definition, F E[n] and F E[n nᵀ] Fᵀ.
/// Domain: means.first in [-1, 1], means.level in [-1, 1], means.upright in [-1, 1], x unit, y unit, z unit.
/// Error: 1e-6 absolute; f32 rounding.
fn irradiance_turned(means: normals_means, x: vec3f, y: vec3f, z: vec3f) -> normals_means {
    let frame = mat3x3f(x, y, z);
    let m = means;
    let square = mat3x3f(vec3f(m.level.xy, m.upright.x), vec3f(m.level.yz, m.upright.y), m.upright);
    let turned = frame * square * transpose(frame);
    return normals_means(frame * m.first, vec3f(turned[0].xy, turned[1].y), turned[2]);
}

/// The means where all facets have one slope, in another frame.
///
/// Source: the definition, the normal n = F (−s, 1) / √(1 + |s|²) and n nᵀ.
/// Domain: slope in [-3, 3], x unit, y unit, z unit.
/// Error: 1e-6 absolute; f32 rounding.
fn irradiance_facet(slope: vec2f, x: vec3f, y: vec3f, z: vec3f) -> normals_means {
    let s = clamp(slope, vec2f(-1e9), vec2f(1e9));
    let n = (z - s.x * x - s.y * y) * inverseSqrt(1.0 + dot(s, s));
    return normals_means(n, n.xxy * n.xyy, n * n.z);
}

/// Lambert's cosine on a facet of the given slope, in the tangent frame.
///
/// Source: the definition, max(n · l, 0) with n = (−s, 1) / √(1 + |s|²).
/// Domain: slope in [-3, 3], light unit.
/// Error: 3e-7 absolute; f32 rounding.
fn irradiance_cosine(slope: vec2f, light: vec3f) -> f32 {
    let s = clamp(slope, vec2f(-1e9), vec2f(1e9));
    return max((light.z - dot(light.xy, s)) * inverseSqrt(1.0 + dot(s, s)), 0.0);
}

/// Mean irradiance from an environment: the texels of one row are the colors of the polynomial 1, n.x, n.y, n.z,
/// n.x n.x, n.x n.y, n.y n.y, n.x n.z and n.y n.z that the irradiance of order 2 is; what n.z n.z has is in those of
/// the other squares and the constant.
///
/// Source: Ramamoorthi and Hanrahan 2001, "An Efficient Representation for Irradiance Environment Maps", equation 12.
/// Domain: means.first in [-1, 1], means.level in [-1, 1], means.upright in [-1, 1].
/// Error: 2e-6 absolute; f32 rounding of nine terms up to 1.
fn irradiance_read(means: normals_means, environment: texture_2d<f32>) -> vec3f {
    let m = means;
    var sum = textureLoad(environment, vec2i(0, 0), 0);
    sum += m.first.x * textureLoad(environment, vec2i(1, 0), 0);
    sum += m.first.y * textureLoad(environment, vec2i(2, 0), 0);
    sum += m.first.z * textureLoad(environment, vec2i(3, 0), 0);
    sum += m.level.x * textureLoad(environment, vec2i(4, 0), 0);
    sum += m.level.y * textureLoad(environment, vec2i(5, 0), 0);
    sum += m.level.z * textureLoad(environment, vec2i(6, 0), 0);
    sum += m.upright.x * textureLoad(environment, vec2i(7, 0), 0);
    sum += m.upright.y * textureLoad(environment, vec2i(8, 0), 0);
    return max(sum.xyz, vec3f());
}

/// Mean of Lambert's cosine max(n · l, 0) of a directional light, n · l taken for normal with the mean and the variance
/// that the means of n and n nᵀ give it; 1 at most.
///
/// Source: a normal variable above 0; by visible slopes the cosine itself is off by up to 0.03.
/// Domain: means.first in [-0.5, 0.5], means.level in [-1, 1], means.upright in [-1, 1], light unit.
/// Error: 5e-7 absolute; f32 rounding.
fn irradiance_lambert(means: normals_means, light: vec3f) -> f32 {
    let m = means;
    let mean = dot(m.first, light);
    let square = mat3x3f(vec3f(m.level.xy, m.upright.x), vec3f(m.level.yz, m.upright.y), m.upright);
    let deviation = sqrt(max(dot(light, square * light) - mean * mean, 1e-12));
    return min(max(mean, 0.0) + deviation * normal_excess(abs(mean / deviation)), 1.0);
}
