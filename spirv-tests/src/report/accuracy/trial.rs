//! One scene with one budget: what is chosen for it, and how far that is from the truth.

use prefilter::gpu::Device;
use prefilter::{Error, HeightTier, Kernel, Module, Scene, Tier};

use super::case::Case;
use super::filter::Filter;
use crate::exports::ExportKernel;
use crate::random::Random;
use crate::report::cache::Cache;
use std::convert::Infallible;

/// What came of a scene.
#[derive(Clone, Debug)]
pub struct Trial {
    /// The number that it was drawn by.
    pub number: u32,
    /// What it filters.
    pub filter: Filter,
    /// Whether the budget that was drawn first was refused.
    pub refused: bool,
    /// The largest error that it asked for.
    pub budget: f64,
    /// What was chosen, in words.
    pub label: String,
    /// Its bound.
    pub bound: f64,
    /// The largest error that was found.
    pub measured: f64,
    /// Whether it is cheaper than the finest tier, where any is that keeps the largest budget.
    pub cheaper: Option<bool>,
}

/// The largest budget.
pub const MOST: f64 = 0.3;

/// The smallest and the largest budget that is drawn first, between which they are even in their logarithm: half a step
/// of colors of eight bits is the least that anybody sees. Filters of values are asked for more.
fn budgets(filter: Filter) -> [f64; 2] {
    let least = if filter == Filter::Texture { 1e-4 } else { 1.0 / 510.0 };
    [least, MOST]
}

/// Draws and judges a scene, at so many times the usual count of pixels. Where no tier keeps the budget that is drawn
/// first, others are, from the bound of the closest on.
///
/// # Errors
/// What scenes are refused for but the accuracy, and what the device refuses.
pub fn trial(device: &Device, cache: &Cache, number: u32, density: f64) -> Result<Trial, Error> {
    let case = Case::new(number, density)?;
    let (mut random, [least, most]) = (Random::new(number ^ 0x5bd1_e995), budgets(case.filter));
    let (mut budget, mut refused) = (random.between(least, most), false);
    let module = loop {
        match case.within(budget) {
            // Of a combination it is the bound of a layer.
            Err(Error::Accuracy { bound, .. }) => {
                let closest = f64::from(bound).max(budget);
                budget = 1.000_01 * random.between(closest, most.max(2.0 * closest));
                refused = true;
            }
            chosen => break chosen?,
        }
    };
    Ok(Trial {
        number,
        filter: case.filter,
        refused,
        budget,
        label: label(&module),
        bound: module.bound().value().into(),
        measured: measured(device, &case, &module, &truths(cache, &case))?,
        cheaper: cheaper(&case, &module, budget)?,
    })
}

/// The integrals at the case's pixels, three channels each, kept under all that they are made of.
fn truths(cache: &Cache, case: &Case) -> Vec<f32> {
    let made_of = format!("{:?} {:?}", case.truth, case.pixels);
    let inputs = [made_of.as_str(), include_str!("truth.rs")];
    let Ok(truths) = cache.numbers::<Infallible>(&inputs, 3 * case.pixels.len(), || {
        let colors = case.pixels.iter().map(|pixel| case.truth.color(pixel));
        Ok(colors.flat_map(|color| [0, 1, 2].map(|channel| color[channel] as f32)).collect())
    });
    truths
}

/// The largest error of the first export over the case's pixels; infinite where a color is not finite.
///
/// # Errors
/// What the device refuses.
fn measured(device: &Device, case: &Case, module: &Module, truths: &[f32]) -> Result<f64, Error> {
    let export = &module.exports()[0];
    let parameters = export.parameters();
    let numbers: Vec<f32> = case.pixels.iter().flat_map(|pixel| pixel.numbers(&parameters)).collect();
    let colors = ExportKernel::new(device, module, export)?.run(&numbers)?;
    let mut worst = if colors.is_empty() || colors.len() != case.pixels.len() { f64::INFINITY } else { 0.0 };
    for (color, truth) in colors.iter().zip(truths.chunks_exact(3)) {
        for channel in 0..3 {
            let apart = (f64::from(color[channel]) - f64::from(truth[channel])).abs();
            // Written so that NaN is the worst.
            worst = if apart <= worst { worst } else { apart.max(worst) };
            if apart.is_nan() {
                worst = f64::INFINITY;
            }
        }
    }
    Ok(worst)
}

/// What was chosen, in words: those of the first line, and of layers their own.
fn label(module: &Module) -> String {
    let said = module.explain().lines().filter_map(|line| {
        let own = line.starts_with(module.name()) || line.trim_start().starts_with("layer ");
        let (_, by) = line.split_once(" by ").filter(|_| own)?;
        Some(by.split_once(": error").map_or(by, |(by, _)| by).to_owned())
    });
    said.collect::<Vec<_>>().join("; ")
}

/// Whether the module weighs less than that of the finest tier, or as much with fewer bytes of tables; nothing where
/// none does that keeps the largest budget.
fn cheaper(case: &Case, module: &Module, budget: f64) -> Result<Option<bool>, Error> {
    let Some(finest) = &case.finest else { return Ok(None) };
    let cost = |module: &Module| (module.cost().weight(), module.cost().table_bytes);
    let finest = cost(&finest.module()?);
    if cost(module) < finest {
        return Ok(Some(true));
    }
    let most = budget.max(MOST);
    if cost(&case.within(most)?) >= finest {
        return Ok(None);
    }
    // C0 at the mean may be lighter, and filters nothing.
    let keeps = |module: &Module| f64::from(module.bound().value()) <= most;
    let lighter = |scene: Scene| scene.module().is_ok_and(|module| keeps(&module) && cost(&module) < finest);
    let (scene, fast) = (|| case.scene.clone(), Tier::ClosedForm(Kernel::Fast));
    let gaussian = || scene().height_tier(HeightTier::Gaussian);
    let any = match case.filter {
        Filter::Texture => lighter(scene().tier(fast)) || lighter(scene().tier(Tier::Table)),
        Filter::Height => lighter(gaussian().tier(fast)) || lighter(scene().height_tier(HeightTier::Skewed)),
        _ => true,
    };
    Ok(any.then_some(false))
}
