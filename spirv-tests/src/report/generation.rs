//! How long scenes take to become modules.

use super::document::{Item, Section, Table};
use super::{Bench, Error, Extent};
use crate::scenes;
use std::time::Instant;

/// Steps of this part.
pub fn steps(_: Extent) -> u64 {
    1
}

/// Measures it.
///
/// # Errors
/// Those of scenes.
pub fn section(bench: &Bench<'_>) -> Result<Section, Error> {
    let scenes = scenes::textures().map_err(|error| Error::Map(error.to_string()))?;
    let mut rows = Vec::new();
    for (name, scene) in scenes.iter().take(bench.extent.pick(3, 20)) {
        let start = Instant::now();
        let module = scene.module()?;
        let seconds = start.elapsed().as_secs_f64();
        rows.push(vec![(*name).into(), (1e3 * seconds).into(), module.cost().table_bytes.into()]);
    }
    (bench.done)(1);
    let table = Table {
        stem: "generation_scenes".into(),
        caption: "Milliseconds from a scene to its validated module, tables included.".into(),
        columns: ["scene", "ms", "table bytes"].map(Into::into).to_vec(),
        rows,
    };
    Ok(Section { stem: "generation".into(), title: "Generation".into(), items: vec![Item::Table(table)] })
}
