//! Visible normals: means by quadrature over the visible slopes, and frames by sums over indices.

use prefilter::reference::footprint::deviations;
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

/// The view is 5 degrees or more above the plane and above the mean surface, and slopes deviate by no more than `most`
/// along any axis.
fn covered(x: &[f64], most: f64) -> bool {
    let visible = seen(x);
    let [sx, sy] = visible.mean;
    let above = visible.rise() / (1.0 + sx * sx + sy * sy).sqrt();
    x[2].min(above) >= 0.0872 && deviations(visible.covariance)[0] <= most
}

/// Views 5 degrees above the plane: of round and of long slopes with next to the largest deviation, along and aslant,
/// over level surfaces and such that lean away.
fn ends(most: f64) -> [[f64; 8]; 6] {
    // Less than the rounding of numbers beside, which are judged, too.
    let v = 0.999_998 * most * most;
    let [long, both] = [v / 1.9, 0.9 * v / 1.9];
    let (far, low) = (0.99618, 0.0873);
    [
        [far, 0.0, low, 0.0, 0.0, v, 0.0, v],
        [far, 0.0, low, 0.0, 0.0, v, 0.0, 0.0025],
        [far, 0.0, low, 0.0, 0.0, 0.0025, 0.0, v],
        [far, 0.0, low, -0.3, 0.3, long, both, long],
        [0.6 * far, 0.8 * far, low, -0.3, -0.3, long, both, long],
        [0.6 * far, 0.8 * far, low, 0.0, -0.3, long, -both, long],
    ]
}

/// Where a search over all that is covered found the largest errors of a component by four and by three Gaussians and
/// by five slopes: `spirv-tests/tests/slopes/normals.rs` searches for those of other measures.
const WORST: [[f64; 8]; 3] = [
    [0.021_167_7, -0.240_980_4, 0.970_299_1, -0.297_281_8, -0.298_735_6, 0.747_482_6, -0.068_030_2, 0.927_885_1],
    [0.830_776_6, -0.297_142_1, 0.470_655_8, -0.3, -0.3, 0.999_988_8, -1.578_38e-5, 0.999_971],
    [-0.003_427_1, -0.013_785_5, 0.999_899_1, 5.155e-5, -0.001_674_0, 0.087_572_2, -0.014_534_7, 0.002_978_2],
];

pub(super) fn rows() -> Vec<Row> {
    let [four, three, points] = WORST;
    vec![
        Row::new("normals_plus", |x| plus(x, parts([x[9], x[10]]), x[11], x[12])),
        Row::new("normals_plus_one", |x| {
            let normal = of_slope([x[9], x[10]]);
            std::array::from_fn::<_, 9, _>(|at| x[at] + x[11] * normal[at])
        }),
        Row::new("normals_gaussian", gaussian),
        Row::new("normals_visible", |x| means(&seen(x))).at(ends(1.0)).at([four]).only_where(|x| covered(x, 1.0)),
        Row::new("normals_visible_fast", |x| means(&seen(x))).at(ends(1.0)).at([three]).only_where(|x| covered(x, 1.0)),
        Row::new("normals_visible_points", |x| means(&seen(x)))
            .at(ends(0.3))
            .at([points])
            .only_where(|x| covered(x, 0.3)),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ends_are_judged() {
        for most in [1.0, 0.3] {
            let worst = WORST.into_iter().filter(|end| most == 1.0 || end[5] < 0.09);
            let ends = ends(most).into_iter().chain(worst);
            let rounded: Vec<_> = ends.map(|end| end.map(|number| f64::from(number as f32))).collect();
            assert!(rounded.iter().all(|end| covered(end, most)), "{most}: {rounded:?}");
        }
    }
}
