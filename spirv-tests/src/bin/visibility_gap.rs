//! Measures how far Smith's visibility model is from Gaussian height fields, and writes the tables of it.
#![deny(missing_docs)]

use clap::Parser;
use spirv_tests::gap::field::Spectrum;
use spirv_tests::gap::study::{seen, shadowed, Extent};
use spirv_tests::gap::table::{directions, seen_row, shadowed_row, SEEN_HEADER, SHADOWED_HEADER};
use spirv_tests::program::bar;
use std::path::PathBuf;
use std::{fs, io};

/// Measures how far Smith's visibility model is from Gaussian height fields, and writes the tables of it.
#[derive(Parser)]
struct Arguments {
    #[command(flatten)]
    extent: Extent,
    /// The folder of `visibility_gap.csv` and `shadowing_gap.csv`.
    #[arg(long, value_name = "DIR", default_value = "target/gap")]
    out: PathBuf,
}

fn main() -> io::Result<()> {
    let Arguments { extent, out } = Arguments::parse();
    let bar = bar((2 * Spectrum::ALL.len() * extent.seeds) as u64, "");
    let done = || bar.inc(1);
    let directions = directions();
    let parameters: Vec<f64> = directions.iter().map(|[_, _, parameter]| *parameter).collect();
    let (mut sights, mut shadows) = (vec![SEEN_HEADER.to_owned()], vec![SHADOWED_HEADER.to_owned()]);
    for spectrum in Spectrum::ALL {
        bar.set_message(spectrum.name());
        for (seen, [deviation, degrees, _]) in seen(spectrum, extent, &parameters, &done).iter().zip(&directions) {
            sights.push(seen_row(spectrum.name(), [*deviation, *degrees], seen));
        }
        shadows.extend(shadowed(spectrum, extent, &done).iter().map(|row| shadowed_row(spectrum.name(), row)));
    }
    bar.finish_and_clear();
    fs::create_dir_all(&out)?;
    for (name, rows) in [("visibility_gap.csv", sights), ("shadowing_gap.csv", shadows)] {
        let text = rows.join("\n") + "\n";
        print!("{text}");
        fs::write(out.join(name), text)?;
    }
    Ok(())
}
