//! Slopes of a transferred height: moments of the products of two independent variables.

/// Mean and covariance (xx, xy, yy) of k s, where k has a mean and a variance, and s, independent of it, a mean and a
/// covariance. Only these matter: here k has two values, each half of the time.
pub fn slopes(factor: [f64; 2], slope: [f64; 2], covariance: [f64; 3]) -> [f64; 5] {
    let [mean, variance] = factor;
    let values = [-1.0, 1.0].map(|side| mean + side * variance.max(0.0).sqrt());
    let half = |of: &dyn Fn(f64) -> f64| 0.5 * (of(values[0]) + of(values[1]));
    let means = slope.map(|component| half(&|k| k * component));
    // Each value's own covariance, and that of the two means.
    let within = covariance.map(|part| half(&|k| k * k * part));
    let between =
        [(0, 0), (0, 1), (1, 1)].map(|(a, b)| half(&|k| (k * slope[a] - means[a]) * (k * slope[b] - means[b])));
    [means[0], means[1], within[0] + between[0], within[1] + between[1], within[2] + between[2]]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn known_products() {
        let covariance = [0.4, 0.1, 0.3];
        assert_eq!(slopes([1.0, 0.0], [0.5, -0.25], covariance), [0.5, -0.25, 0.4, 0.1, 0.3]);
        assert_eq!(slopes([0.0, 0.0], [0.5, -0.25], covariance), [0.0; 5]);
        // A sign that is as often 1 as −1 takes the mean slope into the covariance.
        assert_eq!(slopes([0.0, 1.0], [0.5, -0.25], [0.5, 0.25, 0.25]), [0.0, 0.0, 0.75, 0.125, 0.3125]);
    }
}
