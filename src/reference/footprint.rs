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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn axes_turn_the_covariance_into_a_diagonal() {
        // A turn by 30° of deviations 3 and 0.5: cos² = 3/4, sin cos = √3/4.
        let covariance = [9.0 * 0.75 + 0.25 * 0.25, 8.75 * 3f64.sqrt() / 4.0, 9.0 * 0.25 + 0.25 * 0.75];
        let [long, short] = deviations(covariance);
        assert!((long - 3.0).abs() < 1e-14 && (short - 0.5).abs() < 1e-14, "{long} {short}");
        assert!((major_angle(covariance) - std::f64::consts::FRAC_PI_6).abs() < 1e-14);
        assert_eq!(deviations([0.0; 3]), [0.0; 2]);
        assert_eq!(deviations([1.0, 0.0, 4.0]), [2.0, 1.0]);
    }

    #[test]
    fn a_footprint_is_the_image_of_the_filter() {
        // Deviations 1 and 2 along x and y of the pixel, x twice as wide on the surface, y sheared by one.
        let covariance = covariance([2.0, 0.0], [1.0, 1.0], [1.0, 0.0, 4.0]);
        assert_eq!(covariance, [2.0 * 2.0 + 4.0, 4.0, 4.0]);
    }
}
