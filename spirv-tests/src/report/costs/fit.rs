//! What an operation and a fetch take, fitted to the times of many modules.

/// Times as `base + operation · operations + fetch · fetches`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fit {
    /// What a pixel takes besides.
    pub base: f64,
    /// What an operation takes.
    pub operation: f64,
    /// What a fetch takes.
    pub fetch: f64,
}

/// The fit with the least sum of squares of errors relative to the times, from operations, fetches and times.
pub fn fit(modules: &[[f64; 3]]) -> Fit {
    let mut rows = [[0.0; 4]; 3];
    for [operations, fetches, time] in modules {
        let terms = [1.0 / time, operations / time, fetches / time, 1.0];
        for (row, factor) in rows.iter_mut().zip(terms) {
            row.iter_mut().zip(terms).for_each(|(sum, term)| *sum += factor * term);
        }
    }
    for pivot in 0..3 {
        let own = rows[pivot].map(|value| value / rows[pivot][pivot]);
        for (number, row) in rows.iter_mut().enumerate() {
            let factor = if number == pivot { 0.0 } else { row[pivot] };
            row.iter_mut().zip(own).for_each(|(value, own)| *value -= factor * own);
        }
        rows[pivot] = own;
    }
    let [base, operation, fetch] = rows.map(|row| row[3]);
    Fit { base, operation, fetch }
}

/// How well two lists agree in their order, from −1 to 1: Spearman's coefficient, ties in the order that they have.
pub fn rank_correlation(pairs: &[[f64; 2]]) -> f64 {
    let ranks = |of: usize| -> Vec<f64> {
        let mut order: Vec<usize> = (0..pairs.len()).collect();
        order.sort_by(|&a, &b| pairs[a][of].total_cmp(&pairs[b][of]));
        let mut ranks = vec![0.0; pairs.len()];
        order.into_iter().enumerate().for_each(|(rank, index)| ranks[index] = rank as f64);
        ranks
    };
    let (first, second) = (ranks(0), ranks(1));
    let count = pairs.len() as f64;
    let squares: f64 = first.iter().zip(second).map(|(one, other)| (one - other).powi(2)).sum();
    1.0 - 6.0 * squares / (count * (count * count - 1.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn orders_agree_or_not() {
        let of = |second: [f64; 4]| rank_correlation(&[0, 1, 2, 3].map(|at| [f64::from(at), second[at as usize]]));
        assert_eq!(of([0.1, 0.2, 3.0, 40.0]), 1.0);
        assert_eq!(of([4.0, 3.0, 2.0, 1.0]), -1.0);
        assert!((of([2.0, 1.0, 4.0, 3.0]) - 0.6).abs() < 1e-12);
    }

    #[test]
    fn fits_find_what_times_are_made_of() {
        let module = |operations: f64, fetches: f64| [operations, fetches, 5.0 + 0.02 * operations + 3.0 * fetches];
        let found = fit(&[module(40.0, 1.0), module(200.0, 0.0), module(900.0, 4.0), module(3000.0, 1.0)]);
        let near = |a: f64, b: f64| (a - b).abs() < 1e-9 * b;
        assert!(near(found.base, 5.0) && near(found.operation, 0.02) && near(found.fetch, 3.0), "{found:?}");
    }
}
