//! What is left by several Λ at once.

/// The most that there may be.
pub(super) const MOST: usize = 16;

/// Smith's Λ for which colors are wanted: 0, three of a rising row, and from there on those that are four times the
/// third before and a number more, so that a power of four is all that it takes.
pub(super) struct Hiding {
    lambdas: [f64; MOST],
    more: f64,
    count: usize,
}

impl Hiding {
    /// `count` of them, 16 at most, from the first three after 0 on: with `more` = 3/c, c Λ + 1 grows by fours.
    pub(super) fn new(first: [f64; 3], more: f64, count: usize) -> Self {
        let mut lambdas = [0.0; MOST];
        lambdas[1..4].copy_from_slice(&first);
        for index in 4..MOST {
            lambdas[index] = 4.0 * lambdas[index - 3] + more;
        }
        Self { lambdas, more, count }
    }

    /// The Λ.
    pub(super) fn lambdas(&self) -> &[f64] {
        &self.lambdas[..self.count]
    }

    /// e^(−Λ depth) for so many of the Λ.
    pub(super) fn left(&self, depth: f64, count: usize) -> [f64; MOST] {
        let mut left = [1.0; MOST];
        if depth == 0.0 {
            return left;
        }
        let first = 1..count.clamp(1, 4);
        for (left, lambda) in left[first.clone()].iter_mut().zip(&self.lambdas[first]) {
            *left = (-lambda * depth).exp();
        }
        if count > 4 {
            let rest = (-self.more * depth).exp();
            for index in 4..count {
                let square = left[index - 3] * left[index - 3];
                left[index] = square * square * rest;
            }
        }
        left
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_left_falls_with_every_lambda() {
        assert_eq!(Hiding::new([0.6, 1.5, 3.0], 3.0, MOST).lambdas()[4..7], [5.4, 9.0, 15.0]);
        for more in [3.0, 0.75] {
            let hiding = Hiding::new([0.6, 1.5, 3.0], more, MOST);
            for depth in [0.0, 1e-9, 0.03, 1.0, 40.0, 1e4] {
                let found = hiding.left(depth, MOST);
                for (found, lambda) in found.into_iter().zip(hiding.lambdas()) {
                    let truth = (-lambda * depth).exp();
                    let apart = (found - truth).abs();
                    assert!(apart <= 1e-12 * truth.max(f64::MIN_POSITIVE), "{lambda}, {depth}: {found:e}");
                }
            }
        }
    }
}
