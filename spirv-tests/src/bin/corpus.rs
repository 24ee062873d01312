//! Writes every module that other validators must accept into a folder: `NAME.wgsl` with its SPIR-V.
//!
//! `NAME.module.spv` is SPIR-V without an entry point, for a linker (`spirv-val --target-env spv1.3`); `NAME.spv` is a
//! Vulkan shader (`--target-env vulkan1.1`).
#![deny(missing_docs)]

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};

use clap::Parser;
use naga::back::spv;
use naga::valid::{Capabilities, ValidationFlags, Validator};

/// Write every module that other validators must accept into a folder.
#[derive(Parser)]
struct Arguments {
    /// The folder, made where it is missing.
    folder: PathBuf,
}

fn main() -> Result<(), Box<dyn Error>> {
    let Arguments { folder } = Arguments::parse();
    fs::create_dir_all(&folder)?;
    let mut count = 0;
    for file in prefilter_wgsl::FILES {
        let name = format!("shelf.{}", file.path.trim_end_matches(".wgsl").replace('/', "."));
        write(&folder, &format!("{name}.module"), &linked(file))?;
        count += 1;
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

/// Writes a text and its SPIR-V.
fn write(folder: &Path, name: &str, text: &str) -> Result<(), Box<dyn Error>> {
    let path = folder.join(format!("{name}.wgsl"));
    fs::write(&path, text)?;
    let module = naga::front::wgsl::parse_str(text)
        .map_err(|error| error.emit_to_string_with_path(text, &path.to_string_lossy()))?;
    let info = Validator::new(ValidationFlags::all(), Capabilities::empty())
        .validate(&module)
        .map_err(|error| error.emit_to_string_with_path(text, &path.to_string_lossy()))?;
    let words = spv::write_vec(&module, &info, &spv::Options::default(), None)?;
    let bytes: Vec<u8> = words.iter().flat_map(|word| word.to_le_bytes()).collect();
    Ok(fs::write(folder.join(format!("{name}.spv")), bytes)?)
}
