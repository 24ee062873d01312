//! Means over visible normals n = (−s.x, −s.y, 1) / √(1 + |s|²), by quadrature over the slopes that a view sees.

use super::quadrature::integrate;
use super::slopes::Visible;

/// Steps of the trapezoidal rule across the view, in deviations: less than 1e-9 of a smooth function is left.
const STEP: f64 = 0.4;

/// The last of these steps.
const LAST: i32 = 17;

/// The mean of a function over the visible slopes: by Gauss–Legendre panels along the first vector of the covariance's
/// factor, where the weight ends, and the trapezoidal rule along the second. An eighth of the work of
/// [`Visible::average`], for functions that are smooth over a deviation.
pub fn average<const N: usize>(visible: &Visible, function: impl Fn([f64; 2]) -> [f64; N]) -> [f64; N] {
    let [ex, ey, fx, fy] = visible.factor();
    let (mean, from) = (visible.mean, (-visible.parameter()).max(-9.0));
    let to = (from.max(0.0).powi(2) + 80.0).sqrt();
    let sum = |weighted: bool| {
        integrate(from, to, (to - from) / 5.0, |u| {
            // Where all slopes weigh the same the parameter is infinite.
            let rise = if visible.parameter().is_finite() { u + visible.parameter() } else { 1.0 };
            let weight = rise * (-0.5 * (u * u - from.max(0.0).powi(2))).exp();
            let mut row = [0.0; N];
            for step in if weighted { -LAST..=LAST } else { 0..=0 } {
                let w = STEP * f64::from(step);
                let slope = [mean[0] + ex * u + fx * w, mean[1] + ey * u + fy * w];
                let value = if weighted { function(slope) } else { [1.0; N] };
                let share = if weighted { (-0.5 * w * w).exp() } else { 1.0 };
                row.iter_mut().zip(value).for_each(|(total, value)| *total += share * value);
            }
            row.map(|value| weight * value)
        })
    };
    let across: f64 = (-LAST..=LAST).map(|step| (-0.5 * (STEP * f64::from(step)).powi(2)).exp()).sum();
    let (whole, values) = (sum(false), sum(true));
    std::array::from_fn(|index| values[index] / (whole[index] * across))
}

/// Of a slope's normal n: n, then n.x n.x, n.x n.y and n.y n.y, then n.x n.z, n.y n.z and n.z n.z.
pub fn of_slope([sx, sy]: [f64; 2]) -> [f64; 9] {
    let length = (1.0 + sx * sx + sy * sy).sqrt();
    let [x, y, z] = [-sx / length, -sy / length, 1.0 / length];
    [x, y, z, x * x, x * y, y * y, x * z, y * z, z * z]
}

/// The means of [`of_slope`] over the visible slopes.
pub fn means(visible: &Visible) -> [f64; 9] {
    average(visible, of_slope)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Against the quadrature over the principal axes; squares of a unit vector sum to 1.
    #[test]
    fn quadratures_agree() {
        for (view, mean, covariance) in [
            ([0.0, 0.0, 1.0], [0.1, -0.2], [0.3, 0.1, 0.2]),
            ([0.6, 0.0, 0.8], [0.4, 0.3], [1.0, -0.3, 0.25]),
            ([0.8, 0.6, 0.0], [0.5, 0.1], [0.04, 0.01, 0.01]),
            ([-0.28, 0.0, -0.96], [0.0, 0.2], [0.5, 0.0, 0.5]),
        ] {
            let visible = Visible { view, covariance, mean };
            let (one, other) = (means(&visible), visible.average(of_slope));
            assert!(one.iter().zip(other).all(|(one, other)| (one - other).abs() < 1e-8), "{one:?} {other:?}");
            assert!((one[3] + one[5] + one[8] - 1.0).abs() < 1e-12);
        }
    }
}
