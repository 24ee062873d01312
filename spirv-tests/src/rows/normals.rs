//! Visible normals: means by quadrature over the visible slopes, and frames by sums over indices.

use prefilter::reference::normals::{average, means, of_slope};
use prefilter::reference::slopes::{standard, Visible};

use super::Row;

/// A view of slopes: the numbers are view, mean slope and covariance.
fn seen(x: &[f64]) -> Visible {
    let &[vx, vy, vz, sx, sy, xx, xy, yy, ..] = x else {
        return Visible { view: [f64::NAN; 3], covariance: [f64::NAN; 3], mean: [f64::NAN; 2] };
    };
    Visible { view: [vx, vy, vz], covariance: [xx, xy, yy], mean: [sx, sy] }
}

/// What a slope adds to means, before its weights.
fn parts([sx, sy]: [f64; 2]) -> [f64; 9] {
    [-sx, -sy, 1.0, sx * sx, sx * sy, sy * sy, -sx, -sy, 1.0]
}

/// The means in front, with what is added to the first and to the others.
fn plus(x: &[f64], added: [f64; 9], weight: f64, square_weight: f64) -> [f64; 9] {
    std::array::from_fn(|at| x[at] + if at < 3 { weight } else { square_weight } * added[at])
}

/// The area in the picture: the quadrature over one variable, or where nothing faces away that of the mean plane.
fn shown(visible: &Visible) -> f64 {
    let ([vx, vy, vz], [sx, sy], parameter) = (visible.view, visible.mean, visible.parameter());
    if parameter > 30.0 {
        return vz - vx * sx - vy * sy;
    }
    visible.reach() * standard::weight(parameter)
}

fn gaussian(x: &[f64]) -> [f64; 9] {
    let visible = seen(&x[9..]);
    let &[area, rate, weight, square_weight] = &x[17..] else { return [f64::NAN; 9] };
    let added = average(&visible, |slope| {
        let share = (-rate * (slope[0] * slope[0] + slope[1] * slope[1])).exp();
        parts(slope).map(|part| share * part)
    });
    let share = shown(&visible) / area;
    plus(x, added, share * weight, share * square_weight)
}

/// The view is 5 degrees or more above the mean plane.
fn elevated(x: &[f64]) -> bool {
    x[2] >= 0.0872
}

pub(super) fn rows() -> Vec<Row> {
    vec![
        Row::new("normals_plus", |x| plus(x, parts([x[9], x[10]]), x[11], x[12])),
        Row::new("normals_plus_one", |x| {
            let normal = of_slope([x[9], x[10]]);
            std::array::from_fn::<_, 9, _>(|at| x[at] + x[11] * normal[at])
        }),
        Row::new("normals_gaussian", gaussian),
        Row::new("normals_visible", |x| means(&seen(x))).only_where(elevated),
        Row::new("normals_visible_fast", |x| means(&seen(x))).only_where(elevated),
        Row::new("normals_visible_points", |x| means(&seen(x))).only_where(elevated),
    ]
}
