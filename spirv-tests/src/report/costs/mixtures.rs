//! Mixtures of normal distributions against tables, each filter with a map of six stops.

use super::kernels::times;
use crate::maps::random;
use crate::report::document::{Cell, Item, Table};
use crate::report::{Bench, Error};
use prefilter::{
    ColorMap, HeightTier, HeightTransfer, Irradiance, IrradianceTier, Kernel, Module, Ranges, Scene, SlopeDomain,
    SlopeMap, SlopeTaps, SlopeTier, Tier, TransferTier,
};

/// Kernels, and times.
pub const STEPS: u64 = 2;

const FAST: Tier = Tier::ClosedForm(Kernel::Fast);

/// What is compared: the filter, what stands for what is seen, and the module.
type Entry = (&'static str, String, Module);

fn slopes(map: &ColorMap) -> Result<Vec<Entry>, Error> {
    let mut entries = Vec::new();
    let scene = || Scene::new("judged").slope(map.clone()).ranges(Ranges::default());
    for tier in [FAST, Tier::Table] {
        for slopes in [SlopeTier::Gaussian, SlopeTier::Pair] {
            entries.push(("slope", format!("{slopes} over {tier}"), scene().slope_tier(slopes).tier(tier).module()?));
        }
    }
    for nodes in [TransferTier::TwoNodes, TransferTier::ThreeNodes, TransferTier::FourNodes] {
        let scene = scene().slope_tier(SlopeTier::Gaussian).tier(FAST).transfer(HeightTransfer::smoothstep(0.0, 1.2)?);
        entries.push(("slope of a curve", nodes.to_string(), scene.transfer_tier(nodes).module()?));
    }
    for (tier, label) in [(SlopeTier::Gaussian, "one distribution of Rice"), (SlopeTier::Pair, "ten")] {
        let scene = Scene::new("judged").steepness(map.clone()).slope_tier(tier);
        entries.push(("steepness", format!("{label}, a table"), scene.module()?));
    }
    let snow = SlopeMap::from_function(16, SlopeDomain::Within(0.5), |[x, y]| [0.5 + x, 0.5 - y, 0.25])?;
    for (tier, taps) in [
        (SlopeTier::Gaussian, SlopeTaps::One),
        (SlopeTier::Gaussian, SlopeTaps::Three),
        (SlopeTier::Pair, SlopeTaps::Five),
        (SlopeTier::Pair, SlopeTaps::Seven),
        (SlopeTier::Pair, SlopeTaps::Eleven),
    ] {
        let scene = Scene::new("judged").slope_map(snow.clone()).slope_tier(tier).slope_taps(taps);
        entries.push(("map of slopes", format!("{tier} by {taps}, a table"), scene.module()?));
    }
    Ok(entries)
}

fn others(map: &ColorMap) -> Result<Vec<Entry>, Error> {
    let mut entries = Vec::new();
    let heights = || Scene::new("judged").height(map.clone());
    for tier in [FAST, Tier::Table] {
        let module = heights().height_tier(HeightTier::Gaussian).tier(tier).module()?;
        entries.push(("height", format!("{} over {tier}", HeightTier::Gaussian), module));
    }
    for tier in [HeightTier::Skewed, HeightTier::ClosedForm] {
        entries.push(("height", tier.to_string(), heights().height_tier(tier).module()?));
    }
    let sky = Irradiance::from_harmonics([[0.9, 1.1, 1.4]; 9])?;
    for tier in [IrradianceTier::Points, IrradianceTier::ThreeGaussians, IrradianceTier::FourGaussians] {
        let module = Scene::new("judged").irradiance(sky).irradiance_tier(tier).module()?;
        entries.push(("irradiance", tier.to_string(), module));
    }
    Ok(entries)
}

/// The times of all.
pub fn items(bench: &Bench<'_>) -> Result<Vec<Item>, Error> {
    let map = random(6, false, 7)?;
    let entries = [slopes(&map)?, others(&map)?].concat();
    let modules: Vec<Module> = entries.iter().map(|(_, _, module)| module.clone()).collect();
    let times = times(bench, &modules)?;
    let row = |((filter, label, module), time): (&Entry, f64)| -> Vec<Cell> {
        let cost = module.cost();
        let counts = [cost.operations, cost.fetches, cost.table_bytes, cost.weight()].map(Cell::from);
        let words = [Cell::from(*filter), label.as_str().into(), time.into()];
        let each = Cell::Number(1e3 * time / cost.weight() as f64);
        words.into_iter().chain(counts).chain([each]).collect()
    };
    let columns =
        ["filter", "what is seen", "ms a megapixel", "operations", "fetches", "table bytes", "weight", "ps a weight"];
    Ok(vec![Item::Table(Table {
        stem: "costs_mixtures".to_owned(),
        caption: "Mixtures of normal distributions and tables, under maps of six stops.".to_owned(),
        columns: columns.map(str::to_owned).to_vec(),
        rows: entries.iter().zip(times).map(row).collect(),
    })])
}
