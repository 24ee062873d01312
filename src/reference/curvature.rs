//! Curvature of a mesh over a pixel: slopes of the mesh's normal about the pixel's center.

use super::footprint::{axes, deviations};

/// The covariance of slopes that change linearly over a pixel: the mean over the four points one deviation off the
/// center along both axes of the pixel's filter, times two, for each axis has half of them.
pub fn covariance(normal_changes: [[f64; 3]; 2], frame: [[f64; 3]; 2], pixel: [f64; 3]) -> [f64; 3] {
    let mut sum = [0.0; 3];
    for (axis, deviation) in axes(pixel).into_iter().zip(deviations(pixel)) {
        for side in [-1.0, 1.0] {
            let [right, down] = axis.map(|part| side * part * deviation);
            let change: [f64; 3] =
                std::array::from_fn(|part| right * normal_changes[0][part] + down * normal_changes[1][part]);
            let slope = frame.map(|axis| -(0..3).map(|part| axis[part] * change[part]).sum::<f64>());
            let products = [slope[0] * slope[0], slope[0] * slope[1], slope[1] * slope[1]];
            sum.iter_mut().zip(products).for_each(|(sum, product)| *sum += 0.5 * product);
        }
    }
    sum
}
