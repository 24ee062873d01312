//! Footprints of displaced positions: matrices multiplied out, and Cholesky's factor by its definition.

/// A matrix of two rows.
type Matrix = [[f64; 2]; 2];

/// The covariance of positions whose footprint has two vectors, displaced by a function with these derivatives of its
/// components along them, and with a variance of either component besides: xx, xy, yy.
pub fn covariance(vectors: Matrix, derivatives: Matrix, rest: f64) -> [f64; 3] {
    // Column by column: a vector moves by both components' derivatives along it.
    let moved = |vector: usize, axis: usize| vectors[vector][axis] + derivatives[axis][vector];
    let entry = |i: usize, j: usize| moved(0, i) * moved(0, j) + moved(1, i) * moved(1, j);
    [entry(0, 0) + rest, entry(0, 1), entry(1, 1) + rest]
}

/// The lower triangular factor of a covariance, column by column.
pub fn factor([xx, xy, yy]: [f64; 3]) -> [f64; 4] {
    if xx > 0.0 {
        let first = xx.sqrt();
        return [first, xy / first, 0.0, (yy - xy * xy / xx).max(0.0).sqrt()];
    }
    [0.0, yy.sqrt(), 0.0, 0.0]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_factor_squares_to_the_covariance() {
        let covariance = covariance([[0.3, -0.2], [0.1, 0.5]], [[0.2, 0.4], [-0.1, 0.7]], 0.05);
        let [a, b, zero, d] = factor(covariance);
        let squares = [a * a, a * b, b * b + d * d];
        assert!(zero == 0.0 && (0..3).all(|at| (squares[at] - covariance[at]).abs() < 1e-14), "{squares:?}");
        // By hand: (0.3 + 0.2, −0.2 − 0.1) and (0.1 + 0.4, 0.5 + 0.7).
        let expected = [0.5 * 0.5 + 0.5 * 0.5 + 0.05, 0.5 * -0.3 + 0.5 * 1.2, 0.3 * 0.3 + 1.2 * 1.2 + 0.05];
        assert!((0..3).all(|at| (covariance[at] - expected[at]).abs() < 1e-14), "{covariance:?}");
    }
}
