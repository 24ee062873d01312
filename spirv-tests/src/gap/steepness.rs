//! The lengths of the slopes in sight of fields against those of visible slopes, D_s.
//!
//! The fields and directions are those of [`slopes`](super::slopes), on the lines midway between their rows: there the
//! surface of bilinear cells is straight between nodes, and the slope across in the middle of a segment is that of its
//! cell. `cargo run -p spirv-tests --bin slope_gap -- --out docs` writes `docs/steepness_gap.csv`.
//! The largest errors of a step from 0 to 85 degrees off the normal:
//!
//! | spectrum | D_s | its distribution of Rice | all slopes alike |
//! |---|---|---|---|
//! | gaussian | 0.021 | 0.030 | 0.197 |
//! | band | 0.019 | 0.028 | 0.163 |
//! | k^-4 | 0.039 | 0.044 | 0.213 |
//! | k^-3 | 0.046 | 0.050 | 0.223 |
//!
//! What the model costs is less than for the component along the view, and more than what one distribution of Rice
//! adds: closer ones are for slopes that do not vary alike in all directions.

use std::f64::consts::SQRT_2;
use std::fmt::Write;

use prefilter::reference::slopes::Visible;
use prefilter::reference::steepness::{below, moments};

use super::field::{Field, Spectrum};
use super::figure::{over_seeds, Figure};
use super::histogram::Histogram;
use super::sight::{in_sight, OVERHEAD};
use super::study::Extent;

/// What a direction sees of the lengths of slopes, in deviations of all slopes.
#[derive(Clone, Copy, Debug)]
pub struct Steep {
    /// Mean of the lengths in sight, by projected area.
    pub mean: Figure,
    /// The largest error of a step over all edges by D_s.
    pub step_model: Figure,
    /// The same by the distribution of Rice with the moments of D_s.
    pub step_rice: Figure,
    /// The same when all slopes count alike.
    pub step_unweighted: Figure,
}

/// The lengths of the slopes that the far end of a field's rows sees, in deviations of its slopes, by projected area.
pub fn lengths(field: &Field, parameter: f64) -> Histogram {
    let (middle, size) = (field.between_rows(), field.size);
    let (deviation, across) = (middle.slope_deviation(), field.turned().between_rows().slope_deviation());
    let mut lengths = Histogram::default();
    for (number, row) in middle.rows().enumerate() {
        let at = |row: usize, column: usize| field.heights[row % size * size + column % size];
        let rise = |column: usize| at(number + 1, column) - at(number, column);
        in_sight(row, SQRT_2 * parameter * deviation, |column, area| {
            let along = (row[(column + 1) % size] - row[column]) / deviation;
            let aside = 0.5 * (rise(column) + rise(column + 1)) / across;
            lengths.add_height(along.hypot(aside), area);
        });
    }
    lengths
}

/// Looks at the lengths of slopes of fields of a spectrum with each visibility parameter, cot θ / (√2 σ_s).
pub fn steep(spectrum: Spectrum, extent: Extent, parameters: &[f64], done: &(dyn Fn() + Sync)) -> Vec<Steep> {
    let sights: Vec<Vec<Histogram>> = over_seeds(extent.seeds, |seed| {
        let views = extent.views(spectrum, seed);
        let all = parameters.iter().chain([&OVERHEAD]).map(|parameter| {
            views.iter().fold(Histogram::default(), |mut sum, field| {
                sum.add(&lengths(field, *parameter));
                sum
            })
        });
        let all = all.collect();
        done();
        all
    });
    parameters.iter().enumerate().map(|(index, parameter)| judge(&sights, index, SQRT_2 * parameter)).collect()
}

/// The shares of lengths below the upper ends of the bins that hold positive ones.
fn shares(visible: &Visible) -> Vec<f64> {
    (1..=1200).map(|bin| below(visible, 0.005 * f64::from(bin))).collect()
}

fn judge(sights: &[Vec<Histogram>], index: usize, parameter: f64) -> Steep {
    let length = parameter.hypot(1.0);
    let unit = [1.0, 0.0, 1.0];
    let visible = Visible { view: [1.0 / length, 0.0, parameter / length], covariance: unit, mean: [0.0; 2] };
    let [square, part] = moments(&visible);
    let center = square * (1.0 - part).max(0.0).sqrt();
    let variance = 0.5 * (square - center);
    let overhead = [0.0, 0.0, 1.0];
    let rice = Visible { view: overhead, covariance: [variance, 0.0, variance], mean: [center.sqrt(), 0.0] };
    let all = Visible { view: overhead, covariance: unit, mean: [0.0; 2] };
    let [visible, rice, alike] = [visible, rice, all].map(|slopes| shares(&slopes));
    let read = |shares: &[f64], length: f64| match (200.0 * length).round() as usize {
        0 => 0.0,
        bin => shares[bin.min(shares.len()) - 1],
    };
    let [mean, step_model, step_rice, step_unweighted] = Figure::jackknife(sights, |seeds| {
        let (mut sight, mut all) = (Histogram::default(), Histogram::default());
        for seed in seeds {
            sight.add(&seed[index]);
            all.add(&seed[seed.len() - 1]);
        }
        let ideal = |length: f64| read(&alike, length.max(0.0));
        let step = |shares: &[f64]| sight.step_error_of(&all, ideal, |length| read(shares, length.max(0.0)));
        [sight.moments()[0], step(&visible), step(&rice), step(&alike)]
    });
    Steep { mean, step_model, step_rice, step_unweighted }
}

/// The columns of [`row`].
pub const HEADER: &str = "spectrum,slope_deviation,degrees,mean,mean_se,step_model,step_model_se,step_rice,\
    step_rice_se,step_unweighted,step_unweighted_se";

/// One direction: every figure with its standard error, empty where that is not below a third of it.
pub fn row(name: &str, [slope_deviation, degrees]: [f64; 2], steep: &Steep) -> String {
    let mut row = format!("{name},{slope_deviation},{degrees}");
    // Writing to a String cannot fail.
    for figure in [steep.mean, steep.step_model, steep.step_rice, steep.step_unweighted] {
        let _ = write!(row, ",{figure:.5},{:.1e}", figure.error);
    }
    row
}
