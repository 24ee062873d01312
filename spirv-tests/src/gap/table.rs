//! The tables of the gap, as comma-separated values.

use super::figure::Figure;
use super::model;
use super::study::{Seen, Shadowed};
use std::fmt::Write;

/// Deviations of slopes and degrees from the normal, with the visibility parameter that they make.
pub fn directions() -> Vec<[f64; 3]> {
    let degrees = [0.0, 10.0, 20.0, 30.0, 40.0, 50.0, 60.0, 70.0, 75.0, 80.0, 85.0];
    let parameter = |deviation: f64, degrees: f64| {
        (1.0 / (f64::to_radians(degrees).tan() * std::f64::consts::SQRT_2 * deviation)).min(super::sight::OVERHEAD)
    };
    let all = [0.3, 0.7, 1.0].into_iter().flat_map(|deviation| degrees.map(|degrees| [deviation, degrees]));
    all.map(|[deviation, degrees]| [deviation, degrees, parameter(deviation, degrees)]).collect()
}

/// The columns of [`seen_row`].
pub const SEEN_HEADER: &str = "spectrum,slope_deviation,degrees,lambda,mean,mean_se,mean_gap,mean_model,mean_paper,\
    deviation,deviation_se,deviation_gap,deviation_model,deviation_paper,skewness,skewness_se,\
    share,share_se,share_gap,share_model,step_model,step_model_se,step_normal,step_normal_se,step_paper,step_paper_se,\
    facing,facing_se,facing_model";

/// One direction: every figure with its standard error and what the models expect.
///
/// A `gap` is the model less the figure. Cells whose error is not below a third of the figure are empty.
pub fn seen_row(name: &str, [slope_deviation, degrees]: [f64; 2], seen: &Seen) -> String {
    let lambda = seen.lambda;
    let ([mean, deviation], paper) = (model::exact(lambda), model::paper(lambda));
    let mut row = format!("{name},{slope_deviation},{degrees},{lambda:.6}");
    cell(&mut row, seen.mean);
    let _ = write!(row, ",{},{mean:.5},{:.5}", negative(seen.mean.minus(mean)), paper[0]);
    cell(&mut row, seen.deviation);
    let _ = write!(row, ",{},{deviation:.5},{:.5}", negative(seen.deviation.minus(deviation)), paper[1]);
    cell(&mut row, seen.skewness);
    let share = 1.0 / (1.0 + lambda);
    cell(&mut row, seen.share);
    let _ = write!(row, ",{},{share:.5}", negative(seen.share.minus(share)));
    for figure in [seen.step_model, seen.step_normal, seen.step_paper, seen.facing] {
        cell(&mut row, figure);
    }
    let _ = write!(row, ",{:.5}", 1.0 + lambda);
    row
}

/// The columns of [`shadowed_row`].
pub const SHADOWED_HEADER: &str = "spectrum,azimuth,view_lambda,light_lambda,lit,lit_se,lit_sum,lit_corrected,\
    step_sum,step_sum_se,step_corrected,step_corrected_se";

/// One view and one light.
pub fn shadowed_row(name: &str, shadowed: &Shadowed) -> String {
    let Shadowed { azimuth, lambdas, lit, models, steps } = shadowed;
    let mut row = format!("{name},{azimuth},{:.6},{:.6}", lambdas[0], lambdas[1]);
    cell(&mut row, *lit);
    let _ = write!(row, ",{:.5},{:.5}", models[0], models[1]);
    steps.iter().for_each(|step| cell(&mut row, *step));
    row
}

fn cell(row: &mut String, figure: Figure) {
    let _ = write!(row, ",{figure:.5},{:.1e}", figure.error);
}

fn negative(figure: Figure) -> Figure {
    Figure { value: -figure.value, ..figure }
}
