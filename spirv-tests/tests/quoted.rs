//! Figures that the README and `Module::explain` quote are those of `docs/demo.csv`, which the demo wrote.

use prefilter::{ColorMap, Driver, Moments, Scene, Taps};

type Outcome = Result<(), Box<dyn std::error::Error + Send + Sync>>;

const TABLE: &str = include_str!("../../docs/demo.csv");
const README: &str = include_str!("../../README.md");

/// A number of the table by its input, method and column.
fn figure(input: &str, method: &str, column: &str) -> Result<f64, String> {
    let columns = TABLE.lines().next().unwrap_or("").split(',').collect::<Vec<_>>();
    // Methods are quoted, for some hold a comma; what follows holds none.
    let row = TABLE.lines().find_map(|line| line.strip_prefix(&format!("{input},\"{method}\",")));
    let row = row.ok_or_else(|| format!("demo.csv has no row {input}, {method}"))?;
    let at = columns.iter().position(|name| *name == column).ok_or_else(|| format!("no column {column}"))?;
    let number = row.split(',').nth(at - 2).ok_or_else(|| format!("no number in column {column}"))?;
    number.parse().map_err(|error| format!("{number}: {error}"))
}

#[test]
fn modules_quote_the_gap_of_their_taps() -> Outcome {
    let map = ColorMap::gradient([(0.0, [0.0; 3]), (1.0, [1.0; 3])])?;
    for (taps, method) in [
        (Taps::One, "ours, 1 tap"),
        (Taps::Two, "ours, 2 taps"),
        (Taps::Four, "ours, 4 taps"),
        (Taps::Eight, "ours, 8 taps"),
    ] {
        let driver = Driver::Moments(Moments { taps, ..Moments::default() });
        let module = Scene::new("quoting").texture(map.clone()).driver(driver).module()?;
        let of = |input| figure(input, method, "rms");
        let quoted = format!("RMS of {:.3} on a terrain and {:.3} on", of("terrain")?, of("gravel")?);
        assert!(module.explain().contains(&quoted), "{quoted} is not in {}", module.explain());
        let naive = [figure("terrain", "naive", "rms")?, figure("gravel", "naive", "rms")?];
        assert!(module.explain().contains(&format!("{:.2} and {:.2}", naive[0], naive[1])), "{}", module.explain());
    }
    Ok(())
}

#[test]
fn the_readme_quotes_the_table() -> Outcome {
    for (label, method) in [
        ("naive", "naive"),
        ("pre-colored mipmap", "pre-colored mips"),
        ("pre-colored, 8 anisotropic taps", "pre-colored, aniso 8"),
        ("the paper's recipe", "paper"),
        ("ours, 1 tap", "ours, 1 tap"),
        ("ours, 2 taps", "ours, 2 taps"),
        ("ours, 4 taps", "ours, 4 taps"),
        ("ours, 8 taps", "ours, 8 taps"),
    ] {
        let mut row = format!("| {label} |");
        for input in ["terrain", "gravel"] {
            let of = |column| figure(input, method, column);
            let (rms, samples) = (of("rms")?, of("samples")?);
            let (shimmer, milliseconds) = (of("shimmer_zoom")?, of("milliseconds")?);
            row += &format!(" {rms:.3} | {samples:.0} | {shimmer:.3} | {milliseconds:.1} |");
        }
        assert!(README.lines().any(|line| line == row), "the README lacks {row}");
    }
    Ok(())
}
