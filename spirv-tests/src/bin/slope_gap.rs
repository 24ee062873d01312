//! Measures how far the distribution of visible slopes is from what is in sight of Gaussian height fields.
#![deny(missing_docs)]

use clap::Parser;
use spirv_tests::gap::field::Spectrum;
use spirv_tests::gap::slopes::{row, sloped, HEADER};
use spirv_tests::gap::steepness::{self, steep};
use spirv_tests::gap::study::Extent;
use spirv_tests::gap::table::directions;
use spirv_tests::program::bar;
use std::path::PathBuf;
use std::{fs, io};

/// Measures how far the distribution of visible slopes is from what is in sight of Gaussian height fields.
#[derive(Parser)]
struct Arguments {
    #[command(flatten)]
    extent: Extent,
    /// The folder of `slope_gap.csv` and `steepness_gap.csv`.
    #[arg(long, value_name = "DIR", default_value = "target/gap")]
    out: PathBuf,
}

fn main() -> io::Result<()> {
    let Arguments { extent, out } = Arguments::parse();
    let bar = bar((2 * Spectrum::ALL.len() * extent.seeds) as u64, "");
    // Other deviations of slopes sample the same curve.
    let directions: Vec<[f64; 3]> = directions().into_iter().filter(|direction| direction[0] == 0.7).collect();
    let parameters: Vec<f64> = directions.iter().map(|[_, _, parameter]| *parameter).collect();
    let (mut rows, mut lengths) = (vec![HEADER.to_owned()], vec![steepness::HEADER.to_owned()]);
    for spectrum in Spectrum::ALL {
        bar.set_message(spectrum.name());
        let seen = sloped(spectrum, extent, &parameters, &|| bar.inc(1));
        let named = seen.iter().zip(&directions);
        rows.extend(named.map(|(seen, [deviation, degrees, _])| row(spectrum.name(), [*deviation, *degrees], seen)));
        let steep = steep(spectrum, extent, &parameters, &|| bar.inc(1));
        let named = steep.iter().zip(&directions);
        lengths.extend(
            named.map(|(seen, [deviation, degrees, _])| steepness::row(spectrum.name(), [*deviation, *degrees], seen)),
        );
    }
    bar.finish_and_clear();
    fs::create_dir_all(&out)?;
    for (name, rows) in [("slope_gap.csv", rows), ("steepness_gap.csv", lengths)] {
        let text = rows.join("\n") + "\n";
        print!("{text}");
        fs::write(out.join(name), text)?;
    }
    Ok(())
}
