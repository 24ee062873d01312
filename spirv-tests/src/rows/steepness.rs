//! Steepness: moments of squared lengths by quadrature over the visible slopes, the distribution of Rice by bisection.

use prefilter::reference::slopes::standard::kurtosis;
use prefilter::reference::slopes::Visible;
use prefilter::reference::steepness::moments;

use super::Row;

fn visible(x: &[f64]) -> Visible {
    let &[vx, vy, vz, sx, sy, xx, xy, yy] = x else {
        return Visible { view: [f64::NAN; 3], covariance: [f64::NAN; 3], mean: [f64::NAN; 2] };
    };
    Visible { view: [vx, vy, vz], covariance: [xx, xy, yy], mean: [sx, sy] }
}

/// Some of the surface is in the picture.
fn seen(x: &[f64]) -> bool {
    visible(x).parameter() > -9.0
}

/// ν and σ of the distribution of Rice whose squared length has a mean and a variance: 1 less the variance over the
/// square of the mean rises with k = ν²/σ².
fn rice(mean: f64, part: f64) -> [f64; 2] {
    let (mut low, mut high) = (0.0f64, 1e9f64);
    for _ in 0..200 {
        let k = 0.5 * (low + high);
        if (k / (2.0 + k)).powi(2) < 1.0 - part {
            low = k;
        } else {
            high = k;
        }
    }
    let variance = mean / (2.0 + low);
    [(low * variance).sqrt(), variance.sqrt()]
}

pub(super) fn rows() -> Vec<Row> {
    vec![
        Row::new("steepness_spread", |x| [kurtosis(x[0]) - 1.0]).at([[0.0], [1.0], [-1.0], [8.0], [-8.0], [12.0]]),
        Row::new("steepness_moments", |x| moments(&visible(x)))
            .at([[0.0, 0.0, 1.0, 0.3, -0.2, 0.25, 0.1, 0.16], [0.0, -1.0, 0.0, 0.0, 0.0, 0.25, 0.0, 0.25]])
            .only_where(seen),
        Row::new("steepness_rice", |x| rice(x[0], x[1])).at([[1.0, 0.5], [0.01, 0.99]]),
    ]
}
