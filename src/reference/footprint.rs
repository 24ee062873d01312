//! Footprints of pixels: the image of the pixel's filter under the derivative of a position, and its axes.

/// J P Jᵀ, entry by entry of the matrix product: xx, xy, yy.
pub fn covariance(dpdx: [f64; 2], dpdy: [f64; 2], pixel: [f64; 3]) -> [f64; 3] {
    let jacobian = [[dpdx[0], dpdy[0]], [dpdx[1], dpdy[1]]];
    let pixel = [[pixel[0], pixel[1]], [pixel[1], pixel[2]]];
    let entry = |row: usize, column: usize| {
        let mut sum = 0.0;
        for (i, line) in pixel.iter().enumerate() {
            for (j, value) in line.iter().enumerate() {
                sum += jacobian[row][i] * value * jacobian[column][j];
            }
        }
        sum
    };
    [entry(0, 0), entry(0, 1), entry(1, 1)]
}

/// Variance of a covariance's normal distribution along a unit vector.
pub fn variance_along(covariance: [f64; 3], direction: [f64; 2]) -> f64 {
    let [xx, xy, yy] = covariance;
    let [x, y] = direction;
    x * (xx * x + xy * y) + y * (xy * x + yy * y)
}

/// The angle of the major axis, which one Jacobi rotation turns onto x.
pub fn major_angle(covariance: [f64; 3]) -> f64 {
    let [xx, xy, yy] = covariance;
    0.5 * libm::atan2(2.0 * xy, xx - yy)
}

/// Unit vectors along the major and the minor axis.
pub fn axes(covariance: [f64; 3]) -> [[f64; 2]; 2] {
    let (sin, cos) = libm::sincos(major_angle(covariance));
    [[cos, sin], [-sin, cos]]
}

/// Deviations along the major and the minor axis.
pub fn deviations(covariance: [f64; 3]) -> [f64; 2] {
    axes(covariance).map(|axis| variance_along(covariance, axis).max(0.0).sqrt())
}
