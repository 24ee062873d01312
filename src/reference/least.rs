//! Numbers with the least sum of eighth powers of errors: nearly the least largest error, of errors of several kinds.

/// Steps at most.
const STEPS: u32 = 80;

/// By how much a number is changed to see what errors do.
const CHANGE: f64 = 1e-5;

/// The solution of a system of equations by elimination, with the right side in the last column; none where it has
/// no single one.
pub(super) fn solved(mut rows: Vec<Vec<f64>>) -> Option<Vec<f64>> {
    let count = rows.len();
    for column in 0..count {
        let pivot = (column..count).max_by(|&a, &b| rows[a][column].abs().total_cmp(&rows[b][column].abs()))?;
        rows.swap(column, pivot);
        if rows[column][column].abs() < 1e-300 {
            return None;
        }
        let taken = rows[column].clone();
        for (_, row) in rows.iter_mut().enumerate().filter(|(row, _)| *row != column) {
            let share = row[column] / taken[column];
            for (entry, taken) in row.iter_mut().zip(&taken) {
                *entry -= share * taken;
            }
        }
    }
    Some((0..count).map(|row| rows[row][count] / rows[row][row]).collect())
}

/// From numbers near them, by Levenberg's and Marquardt's steps for the fourth powers of the errors.
pub fn least<const N: usize>(from: [f64; N], errors: impl Fn([f64; N]) -> Vec<f64>) -> [f64; N] {
    let (mut at, mut damping) = (from, 1e-3);
    for _ in 0..STEPS {
        let here = errors(at);
        let scale = here.iter().fold(0.0, |most: f64, error| most.max(error.abs()));
        let sum = |errors: &[f64]| errors.iter().map(|error| (error / scale).powi(8)).sum::<f64>();
        let beside = |number: usize, by: f64| {
            let mut beside = at;
            beside[number] += by;
            errors(beside)
        };
        let gradient = |number: usize| -> Vec<f64> {
            let (more, less) = (beside(number, CHANGE), beside(number, -CHANGE));
            let changes = more.iter().zip(less).map(|(more, less)| (more - less) / (2.0 * CHANGE * scale));
            changes.zip(&here).map(|(change, error)| 4.0 * (error / scale).powi(3) * change).collect()
        };
        let gradients: Vec<Vec<f64>> = (0..N).map(gradient).collect();
        let fourth: Vec<f64> = here.iter().map(|error| (error / scale).powi(4)).collect();
        let product = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let row = |number: usize| -> Vec<f64> {
            let own = &gradients[number];
            let mut row: Vec<f64> = gradients.iter().map(|other| product(own, other)).collect();
            row[number] *= 1.0 + damping;
            row.push(-product(own, &fourth));
            row
        };
        let Some(change) = solved((0..N).map(row).collect()) else { break };
        let next: [f64; N] = std::array::from_fn(|number| at[number] + change[number]);
        let (before, after) = (sum(&here), sum(&errors(next)));
        if after < before {
            (at, damping) = (next, 0.2 * damping);
            if after > before * (1.0 - 1e-9) {
                break;
            }
        } else if damping > 1e6 {
            break;
        } else {
            damping *= 5.0;
        }
    }
    at
}
