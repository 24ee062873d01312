//! Mean and deviation of visible heights that the model and the paper expect.

use prefilter::reference::heights::moments;

/// Mean and deviation of the model's distribution D_h.
pub fn exact(lambda: f64) -> [f64; 2] {
    let [mean, deviation, ..] = moments(lambda);
    [mean, deviation]
}

/// Mean and deviation by the paper's fits.
///
/// Source: Heitz et al. 2014, "Filtering Non-Linear Transfer Functions on Surfaces", equations 16 and 17, with the
/// natural logarithm.
pub fn paper(lambda: f64) -> [f64; 2] {
    [0.39 * (4.75 * lambda + 1.0).ln(), 1.0 / (1.0 + 0.26 * (1.13 * lambda + 1.0).ln())]
}
