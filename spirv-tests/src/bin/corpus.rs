//! Writes every module that other validators must accept into a folder: `NAME.wgsl` with its SPIR-V.
//!
//! Those are the files of the shelf, each with what it needs of the others, the modules of the snapshot scenes, with
//! probes that call every export from a fragment and from a compute shader, and the passes that build pyramids.
//!
//! `NAME.module.spv` is SPIR-V without an entry point, for a linker (`spirv-val --target-env spv1.3`); `NAME.spv` is a
//! Vulkan shader (`--target-env vulkan1.1`).
#![deny(missing_docs)]

use std::error::Error;
use std::fs;
use std::path::PathBuf;

use clap::Parser;
use naga::back::spv;
use naga::valid::{Capabilities, ValidationFlags, Validator};
use prefilter::gpu::MomentPass;
use prefilter::table::Format;
use prefilter::{Edge, Stage};

/// Write every module that other validators must accept into a folder.
#[derive(Parser)]
struct Arguments {
    /// The folder, made where it is missing.
    folder: PathBuf,
}

fn main() -> Result<(), Box<dyn Error + Send + Sync>> {
    let Arguments { folder } = Arguments::parse();
    fs::create_dir_all(&folder)?;
    let mut count = 0;
    let mut write = |name: &str, text: &str, words: Vec<u32>| -> std::io::Result<()> {
        count += 1;
        fs::write(folder.join(format!("{name}.wgsl")), text)?;
        let bytes: Vec<u8> = words.into_iter().flat_map(u32::to_le_bytes).collect();
        fs::write(folder.join(format!("{name}.spv")), bytes)
    };
    for file in prefilter_wgsl::FILES {
        let text = linked(file);
        let name = format!("shelf.{}", file.path.trim_end_matches(".wgsl").replace('/', "."));
        write(&format!("{name}.module"), &text, library(file.path, &text)?)?;
    }
    for (name, scene) in spirv_tests::scenes::all()? {
        let module = scene.module()?;
        write(&format!("{name}.module"), module.wgsl(), module.spirv()?)?;
        for (stage, entry) in [("fragment", Stage::Fragment), ("compute", Stage::Compute)] {
            let shader = module.link(&module.probe(entry))?;
            write(&format!("{name}.{stage}"), shader.wgsl(), shader.spirv()?)?;
        }
    }
    for format in [Format::Rg32Float, Format::Rgba32Float, Format::Rgba16Float] {
        let shader = MomentPass::shader(Edge::Repeat, format)?;
        write(&format!("pass.moments.{format:?}"), shader.wgsl(), shader.spirv()?)?;
    }
    println!("{count} modules in {}", folder.display());
    Ok(())
}

/// A shelf file behind which stands what it needs of the others.
fn linked(file: &prefilter_wgsl::File) -> String {
    let own: Vec<&str> = prefilter_wgsl::declarations(file.text).iter().map(|declaration| declaration.name).collect();
    let needed = prefilter_wgsl::mentioned(file.text).into_iter();
    let others = needed.filter(|(_, declaration)| !own.contains(&declaration.name));
    others.fold(file.text.to_owned(), |text, (_, declaration)| text + "\n" + declaration.text + "\n")
}

/// The SPIR-V of a text without entry points.
fn library(path: &str, text: &str) -> Result<Vec<u32>, Box<dyn Error + Send + Sync>> {
    let module = naga::front::wgsl::parse_str(text).map_err(|error| error.emit_to_string_with_path(text, path))?;
    let info = Validator::new(ValidationFlags::all(), Capabilities::empty())
        .validate(&module)
        .map_err(|error| error.emit_to_string_with_path(text, path))?;
    Ok(spv::write_vec(&module, &info, &spv::Options::default(), None)?)
}
