//! Fields against the model: one direction, and two.

use super::field::{Field, Spectrum};
use super::figure::{over_seeds, Figure};
use super::histogram::Histogram;
use super::light::{Lighting, AZIMUTHS, PARAMETERS};
use super::model;
use super::sight::{Sight, OVERHEAD};
use prefilter::reference::heights::cumulative;
use prefilter::reference::normal::cumulative as normal_cumulative;
use prefilter::reference::smith::lambda;
use prefilter::reference::visibility::independence;

/// How much is looked at.
#[derive(Clone, Copy, Debug, clap::Args)]
pub struct Extent {
    /// Nodes a side of a field.
    #[arg(long, default_value_t = 2048)]
    pub size: usize,
    /// The grain of the fields in texels.
    #[arg(long, default_value_t = 32.0)]
    pub grain: f64,
    /// Seeds, of two fields each, seen along rows and along columns.
    #[arg(long, default_value_t = 8)]
    pub seeds: usize,
}

impl Extent {
    pub(super) fn views(self, spectrum: Spectrum, seed: u64) -> [Field; 4] {
        let [first, second] = Field::pair(spectrum, self.size, self.grain, seed);
        let [third, fourth] = [first.turned(), second.turned()];
        [first, second, third, fourth]
    }

    /// What each visibility parameter sees of the fields, and what is seen overhead behind them: a list a seed.
    pub(super) fn sights(self, spectrum: Spectrum, parameters: &[f64], done: &(dyn Fn() + Sync)) -> Vec<Vec<Sight>> {
        over_seeds(self.seeds, |seed| {
            let views = self.views(spectrum, seed);
            let all = parameters.iter().chain([&OVERHEAD]).map(|parameter| {
                views.iter().fold(Sight::default(), |mut sum, field| {
                    sum.add(&Sight::along_rows(field, *parameter));
                    sum
                })
            });
            let all = all.collect();
            done();
            all
        })
    }
}

/// What a direction sees of a kind of field.
#[derive(Clone, Copy, Debug)]
pub struct Seen {
    /// The visibility parameter.
    pub parameter: f64,
    /// Smith's Λ for it.
    pub lambda: f64,
    /// Mean of the visible heights, in deviations of all heights, by projected area.
    pub mean: Figure,
    /// Their deviation.
    pub deviation: Figure,
    /// Their skewness.
    pub skewness: Figure,
    /// The share in sight of what faces the viewer, by length on the ground: the model's 1 / (1 + Λ).
    pub share: Figure,
    /// The projected area of what faces the viewer over that of the ground: 1 + Λ for normally distributed slopes.
    pub facing: Figure,
    /// The projected area in sight over that of the ground, which is 1.
    pub conserved: Figure,
    /// The largest error of a step over all edges, when visible heights are distributed as the model says.
    pub step_model: Figure,
    /// The same when they are normal, with the model's mean and deviation.
    pub step_normal: Figure,
    /// The same when they are normal, with the paper's mean and deviation.
    pub step_paper: Figure,
}

/// Looks at fields of a spectrum with each visibility parameter.
pub fn seen(spectrum: Spectrum, extent: Extent, parameters: &[f64], done: &(dyn Fn() + Sync)) -> Vec<Seen> {
    let sights = extent.sights(spectrum, parameters, done);
    let judged = parameters.iter().enumerate().map(|(index, parameter)| judge(&sights, index, *parameter));
    judged.collect()
}

fn judge(sights: &[Vec<Sight>], index: usize, parameter: f64) -> Seen {
    let lambda = lambda(parameter);
    let [model, paper] = [model::exact(lambda), model::paper(lambda)];
    let normal = |moments: [f64; 2]| move |height: f64| normal_cumulative((height - moments[0]) / moments[1]);
    let figures = Figure::jackknife(sights, |seeds| {
        let (mut sight, mut all) = (Sight::default(), Sight::default());
        for seed in seeds {
            sight.add(&seed[index]);
            all.add(&seed[seed.len() - 1]);
        }
        let ([mean, deviation, skewness], everything) = (sight.heights.moments(), all.heights.moments());
        [
            (mean - everything[0]) / everything[1],
            deviation / everything[1],
            skewness - everything[2],
            sight.visible / sight.facing,
            sight.facing_area / sight.ground_area,
            sight.heights.weight() / sight.ground_area,
            sight.heights.step_error(&all.heights, |height| cumulative(height, lambda)),
            sight.heights.step_error(&all.heights, normal(model)),
            sight.heights.step_error(&all.heights, normal(paper)),
        ]
    });
    let [mean, deviation, skewness, share, facing, conserved, step_model, step_normal, step_paper] = figures;
    Seen { parameter, lambda, mean, deviation, skewness, share, facing, conserved, step_model, step_normal, step_paper }
}

/// What a light lets be seen of a kind of field.
#[derive(Clone, Copy, Debug)]
pub struct Shadowed {
    /// Degrees between the azimuths of view and light.
    pub azimuth: u32,
    /// Smith's Λ of view and light.
    pub lambdas: [f64; 2],
    /// The share that is lit of the visible area that faces the light.
    pub lit: Figure,
    /// That share by the paper, whose Λ is the sum of both, and with the correction for near azimuths.
    pub models: [f64; 2],
    /// The largest error of a step by D_h of the sum, and of the corrected Λ.
    pub steps: [Figure; 2],
}

/// Lights fields of a spectrum from every direction of [`PARAMETERS`] and [`AZIMUTHS`], for every view.
pub fn shadowed(spectrum: Spectrum, extent: Extent, done: &(dyn Fn() + Sync)) -> Vec<Shadowed> {
    let lightings: Vec<Lighting> = over_seeds(extent.seeds, |seed| {
        let views = extent.views(spectrum, seed);
        let lighting = views.iter().fold(Lighting::default(), |mut sum, field| {
            sum.add(&Lighting::along_rows(field));
            sum
        });
        done();
        lighting
    });
    let lambdas = PARAMETERS.map(lambda);
    let mut all = Vec::new();
    for (index, azimuth) in AZIMUTHS.into_iter().enumerate() {
        for (view, view_lambda) in lambdas.into_iter().enumerate() {
            for (light, light_lambda) in lambdas.into_iter().enumerate() {
                let bit = index * PARAMETERS.len() + light;
                all.push(shade(&lightings, [view, bit], azimuth, [view_lambda, light_lambda]));
            }
        }
    }
    all
}

fn shade(lightings: &[Lighting], [view, light]: [usize; 2], azimuth: u32, lambdas: [f64; 2]) -> Shadowed {
    let (low, high) = (lambdas[0].min(lambdas[1]), lambdas[0].max(lambdas[1]));
    let corrected = high + independence(f64::from(azimuth).to_radians()) * low;
    let joint = [lambdas[0] + lambdas[1], corrected];
    let [lit, sum, nearer] = Figure::jackknife(lightings, |seeds| {
        let (mut heights, mut all, mut facing) = (Histogram::default(), Histogram::default(), 0.0);
        for seed in seeds {
            heights.add(&seed.views[view].lit[light]);
            all.add(&seed.all);
            facing += seed.views[view].facing[light];
        }
        let step = |lambda: f64| heights.step_error(&all, |height| cumulative(height, lambda));
        [heights.weight() / facing, step(joint[0]), step(joint[1])]
    });
    let models = joint.map(|joint| (1.0 + lambdas[0]) / (1.0 + joint));
    Shadowed { azimuth, lambdas, lit, models, steps: [sum, nearer] }
}
