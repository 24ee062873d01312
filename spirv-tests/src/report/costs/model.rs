//! The cost model against time, over the modules of all snapshots.

use super::fit::{fit, rank_correlation, Fit};
use crate::exports::ExportKernel;
use crate::random::Random;
use crate::report::document::{Axis, Cell, Item, Plot, Series, Table};
use crate::report::markdown::rounded;
use crate::report::timing::{fastest, filling, repeated, SHORT};
use crate::report::{Bench, Error};
use crate::scenes;
use prefilter::{Export, Module};

/// Kernels, and times.
pub const STEPS: u64 = 2;

/// Random pixels, whose time is taken over and over where a device holds more.
const PIXELS: usize = 1 << 12;

/// A module's most expensive export, where it reads no tables but the module's own: with a driver what finds the
/// statistics and filters, whose loops turn, otherwise the one with the most operations in its text.
fn heaviest(module: &Module) -> Option<Export> {
    let own = |name: &str| module.tables().iter().any(|table| table.name == name);
    let weight = |export: &Export| {
        let shader = prefilter::link(&[module], "").ok();
        let weight = shader.and_then(|shader| shader.cost(&export.name)).map_or(0, prefilter::Cost::weight);
        (export.name == format!("{}_color", module.name()), weight)
    };
    let export = module.exports().iter().max_by_key(|export| weight(export))?;
    let textures =
        export.parameters().into_iter().filter(|(_, kind)| kind.starts_with("texture")).all(|(name, _)| own(name));
    textures.then(|| export.clone())
}

/// Random arguments: unit vectors where directions are, positive definite covariances, small footprints.
fn points(export: &Export) -> Vec<f32> {
    let mut random = Random::new(0x90d);
    let mut point = || {
        let mut numbers: Vec<f64> = Vec::new();
        for (name, kind) in export.parameters() {
            let unit = random.unit();
            match (name, kind) {
                ("view" | "light", _) => {
                    let z: f64 = 0.1 + 0.9 * unit;
                    numbers.extend([(1.0 - z * z).sqrt(), 0.0, z]);
                }
                ("slope_covariance", _) => numbers.extend([0.01 + 0.2 * unit, 0.02 * unit, 0.01 + 0.1 * unit]),
                ("dpdx", kind) => numbers.extend([0.2 * unit, 0.02, 0.01].iter().take(width(kind))),
                ("dpdy", kind) => numbers.extend([0.01, 0.1 * unit, 0.02].iter().take(width(kind))),
                ("position", kind) => numbers.extend([20.0 * unit, 7.0, 3.0].iter().take(width(kind))),
                ("direction", _) => numbers.extend([0.8, 0.6]),
                ("x", _) => numbers.extend([1.0, 0.0, 0.0]),
                ("y", _) => numbers.extend([0.0, 1.0, 0.0]),
                ("z", _) => numbers.extend([0.0, 0.0, 1.0]),
                (name, "f32") if name.ends_with("deviation") => numbers.push(0.01 + 0.3 * unit),
                (_, kind) => numbers.extend([unit, 0.3, 0.2, 0.1].iter().take(width(kind))),
            }
        }
        numbers
    };
    (0..PIXELS).flat_map(|_| point()).map(|number| number as f32).collect()
}

/// Numbers of a parameter.
fn width(kind: &str) -> usize {
    match kind {
        "vec2f" => 2,
        "vec3f" => 3,
        "vec4f" => 4,
        "f32" => 1,
        _ => 0,
    }
}

/// Weights against times.
pub fn items(bench: &Bench<'_>) -> Result<Vec<Item>, Error> {
    let scenes = scenes::all().map_err(|error| Error::Map(error.to_string()))?;
    let mut kept: Vec<(&str, Module)> = Vec::new();
    let (mut dispatches, mut counts) = (Vec::new(), Vec::new());
    for (name, scene) in scenes.into_iter().step_by(bench.extent.pick(4, 1)) {
        let module = scene.module()?;
        let Some(export) = heaviest(&module) else { continue };
        let (kernel, numbers) = (ExportKernel::new(bench.timed, &module, &export)?, points(&export));
        let (dispatch, count) = filling(PIXELS, SHORT, |count| kernel.prepare(&repeated(&numbers, PIXELS, count)))?;
        dispatches.push(dispatch);
        counts.push(count);
        kept.push((name, module));
    }
    (bench.done)(1);
    let seconds = fastest(&dispatches, bench.extent)?;
    (bench.done)(1);
    let pairs: Vec<[f64; 2]> = kept
        .iter()
        .zip(seconds.iter().zip(counts))
        .map(|((_, module), (seconds, count))| [module.cost().weight() as f64, 1e9 * seconds / count as f64])
        .collect();
    let row = |((name, module), pair): (&(&str, Module), &[f64; 2])| -> Vec<Cell> {
        let cost = module.cost();
        let counts = [cost.operations, cost.fetches, cost.weight()].map(Cell::from);
        [Cell::from(*name)].into_iter().chain(counts).chain([Cell::Number(pair[1])]).collect()
    };
    let columns = ["scene", "operations", "fetches", "weight", "ms a megapixel"].map(str::to_owned).to_vec();
    let rows = kept.iter().zip(&pairs).map(row).collect();
    Ok(vec![
        Item::Text(said(&kept, &pairs)),
        Item::Plot(Plot {
            stem: "costs_model".to_owned(),
            caption: "The weight of a module against the time that it takes.".to_owned(),
            x: Axis { label: "weight".to_owned(), logarithmic: true },
            y: Axis { label: "milliseconds a megapixel".to_owned(), logarithmic: true },
            series: vec![Series { label: "modules of the snapshots".to_owned(), points: pairs.clone(), joined: false }],
        }),
        Item::Table(Table {
            stem: "costs_modules".to_owned(),
            caption: "The weight of modules and the time that their most expensive function takes.".to_owned(),
            columns,
            rows,
        }),
    ])
}

/// How well weights and times agree, and what the times are made of.
fn said(modules: &[(&str, Module)], pairs: &[[f64; 2]]) -> String {
    let of = |((_, module), pair): (&(&str, Module), &[f64; 2])| {
        let cost = module.cost();
        [cost.operations as f64, cost.fetches as f64, pair[1]]
    };
    let all: Vec<[f64; 3]> = modules.iter().zip(pairs).map(of).collect();
    let Fit { base, operation, fetch } = fit(&all);
    let [base, picoseconds, each] = [base, 1e3 * operation, fetch].map(|time| rounded(time, 2));
    format!(
        "Of {} modules weights and times have a rank correlation of {:.3}. Weights take the longer side of every \
         branch and all turns of a loop, times those that pixels take. The fit with the least relative errors has \
         {base} ns a pixel, {picoseconds} ps an operation and {each} ns a fetch, as much as {:.0} operations.",
        pairs.len(),
        rank_correlation(pairs),
        fetch / operation
    )
}
