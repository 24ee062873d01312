//! How long scenes take to become modules with their tables, and modules to become one shader.

#[path = "../../../benches/link/filters.rs"]
mod filters;
#[path = "../../../benches/link/one_core.rs"]
mod one_core;

use super::document::{Cell, Item, Section, Table};
use super::{Bench, Error, Extent};
use crate::scenes;
use one_core::{on_one_core, processor};
use prefilter::{Module, Scene, Table as Texture};

/// Runs of modules with their tables, and of links, of which the fastest counts: what nothing disturbed. What is over
/// soon is soon disturbed.
const RUNS: [usize; 2] = [3, 31];

/// Scenes that have one filter each, at most.
fn singles(extent: Extent) -> Result<Vec<(&'static str, Scene)>, Error> {
    let all = scenes::all().map_err(|error| Error::Map(error.to_string()))?;
    Ok(all.into_iter().step_by(extent.pick(9, 1)).collect())
}

/// Steps of this part.
pub fn steps(extent: Extent) -> u64 {
    singles(extent).map_or(0, |all| all.len() as u64) + 1
}

/// Measures it.
///
/// # Errors
/// Those of scenes, and that of a system that keeps its cores to itself.
pub fn section(bench: &Bench<'_>) -> Result<Section, Error> {
    on_one_core(|| measured(bench)).map_err(|error| Error::Measured(format!("one core: {error}")))?
}

fn measured(bench: &Bench<'_>) -> Result<Section, Error> {
    let scenes = filters::scenes()?;
    let together = Table {
        stem: "generation_all_filters".into(),
        caption:
            "A scene with all filters: one module of each, linked behind a fragment shader that calls every export. \
                  Milliseconds of one core, the fastest of three runs, of links and SPIR-V of 31; the tables that \
                  scenes try and do not take are baked, too."
                .into(),
        columns: COLUMNS.map(Into::into).to_vec(),
        rows: together(&scenes)?,
    };
    (bench.done)(1);
    let mut rows = Vec::new();
    for (name, scene) in singles(bench.extent)? {
        rows.push(alone(name, &scene)?.0);
        (bench.done)(1);
    }
    let single = Table {
        stem: "generation_scenes".into(),
        caption: "The same of each of the scenes whose modules the tests take for snapshots.".into(),
        columns: COLUMNS.map(Into::into).to_vec(),
        rows,
    };
    let facts = format!(
        "Built with{} debug assertions. A closed form of some dozen knots needs no table; the time of naga, which \
         parses and validates the text, is in `module` and in `link, validate`.",
        if cfg!(debug_assertions) { "" } else { "out" }
    );
    let items = vec![Item::Text(facts), Item::Table(together), Item::Table(single)];
    Ok(Section { stem: "generation".into(), title: "Generation".into(), items })
}

const COLUMNS: [&str; 6] = ["scene", "module, tables ms", "link, validate ms", "SPIR-V ms", "tables", "table bytes"];

/// A row for each scene, and one for all of their modules together.
fn together(scenes: &[(&'static str, Scene)]) -> Result<Vec<Vec<Cell>>, Error> {
    let (mut rows, mut modules, mut sum) = (Vec::new(), Vec::new(), 0.0);
    for (name, scene) in scenes {
        let (row, module, time) = alone(name, scene)?;
        rows.push(row);
        modules.push(module);
        sum += time;
    }
    let [link, spirv] = linked(&modules)?;
    let tables: Vec<&Texture> = modules.iter().flat_map(Module::tables).collect();
    let bytes: usize = tables.iter().map(|table| table.bytes()).sum();
    rows.push(vec!["all together".into(), sum.into(), link.into(), spirv.into(), tables.len().into(), bytes.into()]);
    Ok(rows)
}

/// A scene's row, its module, and how long that took to make.
fn alone(name: &str, scene: &Scene) -> Result<(Vec<Cell>, Module, f64), Error> {
    let module = scene.module()?;
    let made = fastest(RUNS[0], || scene.module().map(|_| ()))?;
    let [link, spirv] = linked(std::slice::from_ref(&module))?;
    let (count, bytes) = (module.tables().len(), module.tables().iter().map(Texture::bytes).sum::<usize>());
    let row = vec![name.into(), made.into(), link.into(), spirv.into(), count.into(), bytes.into()];
    Ok((row, module, made))
}

/// How long modules take to link and to be validated behind a shader that calls them, and that to be written.
fn linked(modules: &[Module]) -> Result<[f64; 2], Error> {
    let (list, entry): (Vec<&Module>, String) = (modules.iter().collect(), filters::entry(modules));
    let link = fastest(RUNS[1], || prefilter::link(&list, &entry).map(|_| ()))?;
    let shader = prefilter::link(&list, &entry)?;
    Ok([link, fastest(RUNS[1], || shader.spirv().map(|_| ()))?])
}

/// Milliseconds that the process takes, in the fastest of so many runs.
fn fastest(runs: usize, mut run: impl FnMut() -> Result<(), prefilter::Error>) -> Result<f64, prefilter::Error> {
    let mut fastest = f64::INFINITY;
    for _ in 0..runs {
        let start = processor();
        run()?;
        fastest = fastest.min(processor() - start);
    }
    Ok(1e3 * fastest)
}
