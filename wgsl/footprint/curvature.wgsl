// Curvature of a mesh over a pixel, as the covariance of its slopes there: added to that of a map of slopes on the mesh
// it is the covariance of both, and as roughness it keeps highlights of bent edges from sparkling.
//
// With the mesh's unit normal N at the pixel's center and N + dN next to it, the slopes in the tangent frame of N are
// −dN · x and −dN · y, x and y being that frame's axes: dN is in the tangent plane, and N · (N + dN) is 1 to first
// order. They are linear in the pixel's offsets, of which the pixel's filter has a covariance. What bends over the
// pixel, too, is of second order: with differences between pixels for derivatives, pixels of a hundredth of a mesh's
// radius, up to 53 degrees off its normal, have a covariance within 2 % of its trace, ten times smaller ones within
// 0.2 %.

/// Covariance (xx, xy, yy) of the slopes of a curved mesh over a pixel, in the tangent frame with the axes `x` and `y`.
///
/// `dndx` and `dndy` are the screen derivatives of the mesh's normal, of length 1 before they are taken; the axes are
/// of length 1, at right angles to it and to each other. `pixel_covariance` is that of the pixel's filter, in pixels².
///
/// Source: the image of a Gaussian under the derivative of the slopes, as `footprint_covariance`.
/// Domain: dndx in [-1, 1], dndy in [-1, 1], x unit, y unit, pixel_covariance psd(0.1, 2, 0.99).
/// Error: 6e-6 absolute; f32 rounding of variances up to 50.
fn curvature_covariance(dndx: vec3f, dndy: vec3f, x: vec3f, y: vec3f, pixel_covariance: vec3f) -> vec3f {
    let right = vec2f(dot(dndx, x), dot(dndx, y));
    let down = vec2f(dot(dndy, x), dot(dndy, y));
    return footprint_covariance(right, down, pixel_covariance);
}

/// The same for a pixel with a round filter of the given deviation, in pixels: box 0.289, tent 0.408, Gaussian resolve
/// 0.5.
///
/// Source: as `curvature_covariance`.
/// Domain: dndx in [-1, 1], dndy in [-1, 1], x unit, y unit, pixel_deviation log in [0.1, 2].
/// Error: 6e-6 absolute; f32 rounding of variances up to 24.
fn curvature_covariance_round(dndx: vec3f, dndy: vec3f, x: vec3f, y: vec3f, pixel_deviation: f32) -> vec3f {
    let right = vec2f(dot(dndx, x), dot(dndx, y));
    let down = vec2f(dot(dndy, x), dot(dndy, y));
    return footprint_covariance_round(right, down, pixel_deviation);
}
