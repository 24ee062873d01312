//! The slopes in sight of fields against the distribution of visible slopes, D_s.
//!
//! D_s weighs all facets by their area in the picture and takes it for independent of their slopes which of them others
//! hide. `cargo run -p spirv-tests --bin slope_gap -- --out docs` writes `docs/slope_gap.csv`, from the same fields as
//! the other tables. The largest errors of a step from 0 to 85 degrees off the normal, for slopes along the view:
//!
//! | spectrum | D_s | one normal distribution | all slopes alike |
//! |---|---|---|---|
//! | gaussian | 0.026 | 0.035 | 0.553 |
//! | band | 0.022 | 0.064 | 0.539 |
//! | k^-4 | 0.054 | 0.041 | 0.570 |
//! | k^-3 | 0.061 | 0.041 | 0.572 |
//!
//! What is in sight faces the viewer more than D_s says, but for ripples from 70 degrees on. From 60 degrees on a
//! normal distribution with the mean and deviation of D_s is nearer to the fractals than D_s itself.

use std::f64::consts::SQRT_2;
use std::fmt::Write;

use prefilter::reference::normal::cumulative as normal_cumulative;
use prefilter::reference::slopes::standard::{cumulative, moments};

use super::field::Spectrum;
use super::figure::Figure;
use super::sight::Sight;
use super::study::Extent;

/// What a direction sees of the slopes towards it, in deviations of all slopes; negative ones face the viewer.
#[derive(Clone, Copy, Debug)]
pub struct Sloped {
    /// Mean of the slopes in sight, by projected area.
    pub mean: Figure,
    /// Their deviation.
    pub deviation: Figure,
    /// Mean and deviation by D_s.
    pub model: [f64; 2],
    /// The largest error of a step over all edges by D_s.
    pub step_model: Figure,
    /// The same by a normal distribution with the mean and deviation of D_s.
    pub step_normal: Figure,
    /// The same when all slopes count alike.
    pub step_unweighted: Figure,
}

/// Edges of the bins of histograms, of which each holds a range of 0.005.
fn edge(index: usize) -> f64 {
    0.005 * index as f64 - 6.0
}

/// Looks at the slopes of fields of a spectrum with each visibility parameter, cot θ / (√2 σ_s).
pub fn sloped(spectrum: Spectrum, extent: Extent, parameters: &[f64], done: &(dyn Fn() + Sync)) -> Vec<Sloped> {
    let sights = extent.sights(spectrum, parameters, done);
    parameters.iter().enumerate().map(|(index, parameter)| judge(&sights, index, SQRT_2 * parameter)).collect()
}

fn judge(sights: &[Vec<Sight>], index: usize, parameter: f64) -> Sloped {
    let [against, variance, _] = moments(parameter);
    let model = [-against, variance.sqrt()];
    // A slope towards the view is −u: it lies below an edge where u lies above the opposite one.
    let edges: Vec<f64> = (0..=2400).map(edge).collect();
    let rising = cumulative(parameter, &edges);
    let below = |slope: f64| 1.0 - rising[(200.0 * (6.0 - slope)).round().clamp(0.0, 2400.0) as usize];
    let figures = Figure::jackknife(sights, |seeds| {
        let (mut sight, mut all) = (Sight::default(), Sight::default());
        for seed in seeds {
            sight.add(&seed[index]);
            all.add(&seed[seed.len() - 1]);
        }
        let ([mean, deviation, _], everything) = (sight.slopes.moments(), all.slopes.moments());
        [
            (mean - everything[0]) / everything[1],
            deviation / everything[1],
            sight.slopes.step_error(&all.slopes, below),
            sight.slopes.step_error(&all.slopes, |slope| normal_cumulative((slope - model[0]) / model[1])),
            sight.slopes.step_error(&all.slopes, normal_cumulative),
        ]
    });
    let [mean, deviation, step_model, step_normal, step_unweighted] = figures;
    Sloped { mean, deviation, model, step_model, step_normal, step_unweighted }
}

/// The columns of [`row`].
pub const HEADER: &str = "spectrum,slope_deviation,degrees,mean,mean_se,mean_model,deviation,deviation_se,\
    deviation_model,step_model,step_model_se,step_normal,step_normal_se,step_unweighted,step_unweighted_se";

/// One direction: every figure with its standard error, empty where that is not below a third of it.
pub fn row(name: &str, [slope_deviation, degrees]: [f64; 2], sloped: &Sloped) -> String {
    let mut row = format!("{name},{slope_deviation},{degrees}");
    // Writing to a String cannot fail.
    for (figure, model) in [sloped.mean, sloped.deviation].into_iter().zip(sloped.model) {
        let _ = write!(row, ",{figure:.5},{:.1e},{model:.5}", figure.error);
    }
    for figure in [sloped.step_model, sloped.step_normal, sloped.step_unweighted] {
        let _ = write!(row, ",{figure:.5},{:.1e}", figure.error);
    }
    row
}
