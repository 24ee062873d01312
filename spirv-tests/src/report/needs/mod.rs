//! What modules consist of, scene by scene, and what each feature adds to one.

pub mod calls;
pub mod features;
pub mod scenes;

use std::collections::BTreeSet;

use super::document::{Cell, Item, Section, Table};
use super::{Bench, Error, Extent};
use prefilter::{Export, Module};

/// Steps of this part.
pub fn steps(_: Extent) -> u64 {
    3
}

/// Measures it.
///
/// # Errors
/// Those of scenes.
pub fn section(bench: &Bench<'_>) -> Result<Section, Error> {
    let scenes = scenes_table()?;
    (bench.done)(1);
    let features = features_table()?;
    (bench.done)(1);
    let mut items = vec![Item::Table(scenes), Item::Table(features)];
    let text = "What a fragment shader calls, and the signatures of what it may call, for the paper's three cases.";
    items.push(Item::Text(text.into()));
    for calls::Call { name, lines, module, .. } in calls::all()? {
        let signatures: Vec<&str> = module.exports().iter().map(|export| export.signature.as_str()).collect();
        items.push(Item::Lines(format!("// {name}\n{lines}\n\n// {}", signatures.join("\n// "))));
    }
    (bench.done)(1);
    Ok(Section { stem: "needs".into(), title: "Only what is needed".into(), items })
}

/// What a module consists of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Need {
    /// Lines of code, without comments and empty lines.
    pub lines: usize,
    /// Operations of the most expensive export.
    pub operations: usize,
    /// Its texture reads.
    pub fetches: usize,
    /// Numbers that the exports take: components of scalars and vectors, those of one name once.
    pub numbers: usize,
    /// Textures that they take.
    pub textures: usize,
    /// Bytes of the module's own tables.
    pub table_bytes: usize,
}

impl Need {
    /// That of a module.
    pub fn of(module: &Module) -> Self {
        let parameters: BTreeSet<(&str, &str)> = module.exports().iter().flat_map(Export::parameters).collect();
        let numbers = |(_, kind): &(&str, &str)| match *kind {
            "f32" | "i32" | "u32" => 1,
            vector => ["vec2", "vec3", "vec4"].iter().position(|name| vector.starts_with(name)).map_or(0, |at| at + 2),
        };
        let cost = module.cost();
        Self {
            lines: code(module.wgsl()).lines().count(),
            operations: cost.operations,
            fetches: cost.fetches,
            numbers: parameters.iter().map(numbers).sum(),
            textures: parameters.iter().filter(|(_, kind)| kind.starts_with("texture")).count(),
            table_bytes: cost.table_bytes,
        }
    }

    fn list(self) -> [usize; 6] {
        let Self { lines, operations, fetches, numbers, textures, table_bytes } = self;
        [lines, operations, fetches, numbers, textures, table_bytes]
    }
}

/// A text's code: without comments and empty lines.
pub fn code(text: &str) -> String {
    let lines = text.lines().map(|line| line.split("//").next().unwrap_or_default().trim_end());
    lines.filter(|line| !line.is_empty()).map(|line| format!("{line}\n")).collect()
}

const COLUMNS: [&str; 6] = ["lines of code", "operations", "fetches", "numbers", "textures", "table bytes"];

fn scenes_table() -> Result<Table, Error> {
    let mut rows = Vec::new();
    for (name, scene) in scenes::all()? {
        let need = Need::of(&scene.module()?).list();
        rows.push([name.into()].into_iter().chain(need.map(Cell::from)).collect());
    }
    Ok(Table {
        stem: "needs_scenes".into(),
        caption:
            "What the modules of twenty scenes consist of: lines without comments, the operations and texture reads \
                  of the most expensive export, the numbers and textures that exports take, and the bytes of the \
                  module's own tables, without those of images."
                .into(),
        columns: ["scene"].into_iter().chain(COLUMNS).map(Into::into).collect(),
        rows,
    })
}

fn features_table() -> Result<Table, Error> {
    let mut rows = Vec::new();
    for feature in features::all()? {
        let [on, off] = [Need::of(&feature.on.module()?).list(), Need::of(&feature.never.module()?).list()];
        let differences = on.into_iter().zip(off).map(|(on, off)| Cell::Text(format!("{:+}", on as i64 - off as i64)));
        rows.push([feature.name.into()].into_iter().chain(differences).collect());
    }
    Ok(Table {
        stem: "needs_features".into(),
        caption:
            "What a feature adds to a scene that is without it. Switched off, where it can be, the text is that of \
                  a scene that never had it."
                .into(),
        columns: ["feature"].into_iter().chain(COLUMNS).map(Into::into).collect(),
        rows,
    })
}
