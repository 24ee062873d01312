//! Figures that the README and `Module::explain` quote are those of the tables in `docs`, which the demo and
//! `visibility_gap` wrote.

use std::collections::BTreeMap;

use prefilter::{ColorMap, Cost, Driver, Irradiance, IrradianceTier, Kernel, Microsurface, Moments, Scene, Taps, Tier};

/// A line of a table by its columns.
type Row<'a> = BTreeMap<&'a str, &'a str>;

type Outcome<T = ()> = Result<T, Box<dyn std::error::Error + Send + Sync>>;

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

#[test]
fn the_filter_quotes_the_gap_of_visibility() {
    let sight = rows(include_str!("../../docs/visibility_gap.csv"));
    let light = rows(include_str!("../../docs/shadowing_gap.csv"));
    let near = |row: &Row<'_>| row["azimuth"] == "0";
    let of = |column: &str, other, near_view: bool| largest(&light, column, other, |row| near(row) == near_view);
    let text = include_str!("../../src/filter/height.rs").replace("\n//!", "");
    let quoted = [
        format!("up to {:.2} for one direction", largest(&sight, "step_model", None, |_| true)),
        format!("{:.2} with a light and {:.2}", of("step_sum", None, false), of("step_sum", None, true)),
        format!(
            "up to {:.2}, near the view {:.2}",
            of("lit_sum", Some("lit"), false),
            of("lit_sum", Some("lit"), true)
        ),
        format!(
            "by {:.2}, near the view {:.2}",
            of("lit_corrected", Some("lit"), false),
            of("lit_corrected", Some("lit"), true)
        ),
    ];
    for quoted in quoted {
        assert!(text.contains(&quoted), "{quoted} is not in the documentation of heights");
    }
}

/// The columns of a table by their names, row by row.
fn rows(table: &str) -> Vec<Row<'_>> {
    let names: Vec<&str> = table.lines().next().unwrap_or("").split(',').collect();
    table.lines().skip(1).map(|line| names.iter().copied().zip(line.split(',')).collect()).collect()
}

/// The largest difference of two columns, or of one from 0, over the rows that hold both and pass.
fn largest(rows: &[Row<'_>], column: &str, other: Option<&str>, pass: impl Fn(&Row<'_>) -> bool) -> f64 {
    let number = |row: &Row<'_>, name: &str| row[name].parse::<f64>().ok();
    let difference = |row| Some((number(row, column)? - other.map_or(Some(0.0), |other| number(row, other))?).abs());
    rows.iter().filter(|row| pass(row)).filter_map(difference).fold(f64::NAN, f64::max)
}

#[test]
fn the_readme_quotes_the_rough_surface() -> Outcome {
    let table = rows(include_str!("../../docs/rough.csv"));
    let figure = |view: &str, method: &str, quantity: &str, region: &str| -> Result<f64, String> {
        let wanted = [("view", view), ("sun", "behind"), ("method", method), ("quantity", quantity)];
        let row = table.iter().find(|row| wanted.iter().all(|(column, value)| row[column] == *value));
        let row = row.ok_or_else(|| format!("rough.csv has no row {wanted:?}"))?;
        row[region].parse().map_err(|error| format!("{region} of {wanted:?}: {error}"))
    };
    let three = |view, region| -> Result<String, String> {
        let [texture, paper, ours] =
            ["view-independent", "paper", "ours"].map(|method| figure(view, method, "lit", region));
        Ok(format!("{:.3}, {:.3} and {:.3}", texture?, paper?, ours?))
    };
    let text = README.split_whitespace().collect::<Vec<_>>().join(" ");
    for quoted in [
        format!("{} near the horizon", three("grazing", "far")?),
        format!("{} from overhead", three("overhead", "far")?),
        format!("{} over all of the grazing view", three("grazing", "rms")?),
    ] {
        assert!(text.contains(&quoted), "the README lacks: {quoted}");
    }
    Ok(())
}

#[test]
fn the_readme_quotes_the_mountains() -> Outcome {
    let table = rows(include_str!("../../docs/cliffs.csv"));
    let cell = |view: &str, method: &str, column: &str| -> Result<&str, String> {
        let wanted = [("view", view), ("sun", "ahead"), ("method", method), ("region", "far")];
        let row = table.iter().find(|row| wanted.iter().all(|(column, value)| row[column] == *value));
        row.map(|row| row[column]).ok_or_else(|| format!("cliffs.csv has no row {wanted:?}"))
    };
    let three = |view| -> Outcome<String> {
        let [naive, alike, ours] = ["naive", "view-independent", "factored"].map(|method| cell(view, method, "rms"));
        let [naive, alike, ours] = [naive?.parse::<f64>()?, alike?.parse()?, ours?.parse()?];
        Ok(format!("{naive:.3}, {alike:.3} and {ours:.3}"))
    };
    let [near, over] = ["grazing", "overhead"].map(|view| cell(view, "joint", "rms"));
    let [near, over] = [near?.parse::<f64>()?, over?.parse::<f64>()?];
    let models = rows(include_str!("../../docs/cliffs_model.csv"));
    let times = |row: &Row<'_>| -> Outcome<f64> { Ok(row["factored"].parse::<f64>()? / row["joint"].parse::<f64>()?) };
    let times = models.iter().filter(|row| row["taps"] == "correlated").map(times).collect::<Outcome<Vec<f64>>>()?;
    let [least, most] = [times.iter().copied().reduce(f64::min), times.iter().copied().reduce(f64::max)];
    let text = README.split_whitespace().collect::<Vec<_>>().join(" ");
    for quoted in [
        format!("{} near the horizon", three("grazing")?),
        format!("takes {} samples", cell("grazing", "factored", "samples")?),
        format!("errs by {}", three("overhead")?),
        format!("is {:.1} to {:.1} times as near", least.unwrap_or(f64::NAN), most.unwrap_or(f64::NAN)),
        format!("errs by {near:.3} and {over:.3} in these two views"),
    ] {
        assert!(text.contains(&quoted), "the README lacks: {quoted}");
    }
    Ok(())
}

#[test]
fn the_readme_quotes_the_snake() -> Outcome {
    let table = rows(include_str!("../../docs/snake.csv"));
    let figure = |view: &str, method: &str, quantity: &str, column: &str| -> Result<f64, String> {
        let wanted = [("view", view), ("method", method), ("quantity", quantity)];
        let row = table.iter().find(|row| wanted.iter().all(|(column, value)| row[column] == *value));
        let row = row.ok_or_else(|| format!("snake.csv has no row {wanted:?}"))?;
        row[column].parse().map_err(|error| format!("{column} of {wanted:?}: {error}"))
    };
    let three = |view| -> Result<String, String> {
        let [naive, all, ours] =
            ["naive", "view-independent", "ours"].map(|method| figure(view, method, "color", "rms"));
        Ok(format!("{:.3}, {:.3} and {:.3}", naive?, all?, ours?))
    };
    let text = README.split_whitespace().collect::<Vec<_>>().join(" ");
    for quoted in [
        format!("errs, RMS, by {} at the mean", three("far")?),
        format!("{} where pixels are a quarter", three("whole")?),
        format!("{} near", three("near")?),
        format!("takes {:.0} samples a pixel", figure("far", "ours", "color", "samples")?),
        format!(
            "by {:.4} averaged together and by {:.4} apart",
            figure("far", "ours", "lit", "rms")?,
            figure("far", "light apart", "lit", "rms")?
        ),
    ] {
        assert!(text.contains(&quoted), "the README lacks: {quoted}");
    }
    Ok(())
}

#[test]
fn the_readme_quotes_the_noise() -> Outcome {
    let table = rows(include_str!("../../docs/noise.csv"));
    let of = |input: &'static str| table.iter().filter(move |row| row["input"] == input && row["region"] == "all");
    for terrain in of("terrain") {
        let mut line = format!("| {} |", terrain["method"]);
        for input in ["terrain", "steps6", "blocks"] {
            let Some(row) = of(input).find(|row| row["method"] == terrain["method"]) else {
                assert!(input == "blocks" && terrain["method"] == "ours by curvature", "{line} lacks {input}");
                line += " – | – | – |";
                continue;
            };
            let number = |name: &str| row[name].parse::<f64>();
            line += &format!(" {:.3} | {} | {:.3} |", number("rms")?, row["samples"], number("shimmer_zoom")?);
        }
        assert!(README.lines().any(|readme| readme == line), "the README lacks {line}");
    }
    Ok(())
}

#[test]
fn modules_quote_the_gap_of_visibility() -> Outcome {
    let sight = rows(include_str!("../../docs/visibility_gap.csv"));
    let light = rows(include_str!("../../docs/shadowing_gap.csv"));
    let map = ColorMap::gradient([(0.0, [0.0; 3]), (1.0, [1.0; 3])])?;
    for (hotspot, column) in [(false, "sum"), (true, "corrected")] {
        let surface = Microsurface { hotspot, ..Microsurface::default() };
        let module = Scene::new("quoting").height(map.clone()).microsurface(surface).module()?;
        let near = |row: &Row<'_>| row["azimuth"] == "0";
        let (step, lit) = (format!("step_{column}"), format!("lit_{column}"));
        let quoted = [
            format!(
                "up to {:.2} with a Gaussian",
                largest(&sight, "step_model", None, |row| row["spectrum"] == "gaussian")
            ),
            format!("{:.2} with others", largest(&sight, "step_model", None, |_| true)),
            format!("up to {:.2}, near", largest(&light, &step, None, |row| !near(row))),
            format!("near the view {:.2}, and", largest(&light, &step, None, near)),
            format!("lit by {:.2}", largest(&light, &lit, Some("lit"), |row| !near(row))),
            format!("near the view {:.2}\n", largest(&light, &lit, Some("lit"), near)),
        ];
        for quoted in quoted {
            assert!(module.explain().contains(&quoted), "{quoted} is not in {}", module.explain());
        }
    }
    Ok(())
}

#[test]
fn modules_quote_the_gap_of_visible_slopes() -> Outcome {
    let slopes = rows(include_str!("../../docs/slope_gap.csv"));
    let map = ColorMap::gradient([(0.0, [0.0; 3]), (1.0, [1.0; 3])])?;
    let module = Scene::new("quoting").slope(map).module()?;
    let gaussian = largest(&slopes, "step_model", None, |row| row["spectrum"] == "gaussian");
    let all = largest(&slopes, "step_model", None, |_| true);
    let quoted = format!("up to {gaussian:.2} with a Gaussian autocorrelation, {all:.2} with others");
    assert!(module.explain().contains(&quoted), "{quoted} is not in {}", module.explain());
    let lengths = rows(include_str!("../../docs/steepness_gap.csv"));
    let of_gaussian = largest(&lengths, "step_model", None, |row| row["spectrum"] == "gaussian");
    let of_all = largest(&lengths, "step_model", None, |_| true);
    let map = ColorMap::gradient([(0.0, [0.0; 3]), (1.0, [1.0; 3])])?;
    let module = Scene::new("quoting").steepness(map).module()?;
    let quoted = format!("{of_gaussian:.2} with a Gaussian autocorrelation, {of_all:.2} with others");
    assert!(module.explain().contains(&quoted), "{quoted} is not in {}", module.explain());
    let quoted =
        format!("Of the slopes that are seen, steps err by up to {all:.2}, of their lengths by up to {of_all:.2}.");
    assert!(README.split_whitespace().collect::<Vec<_>>().join(" ").contains(&quoted), "{quoted}");
    Ok(())
}

/// Costs are those that modules count, of the terrain of the tables and of an environment with every term.
#[test]
fn the_readme_quotes_costs() -> Outcome {
    let map = spirv_tests::maps::named("terrain")?;
    let counted = |scene: Scene| scene.module().map(|module| module.cost());
    let texture = |tier| counted(Scene::new("quoting").texture(map.clone()).tier(tier));
    for (label, tier) in [
        ("closed form, exact", Tier::ClosedForm(Kernel::Exact)),
        ("closed form, fast", Tier::ClosedForm(Kernel::Fast)),
        ("table, 512 × 16", Tier::Table),
        ("the paper's table, 256 × 256", Tier::Paper),
    ] {
        let Cost { operations, fetches, table_bytes } = texture(tier)?;
        let read = format!(", {fetches} fetch, {} KiB", table_bytes / 1024);
        let cost = format!("{operations} operations{} |", if fetches == 0 { "" } else { &read });
        let row = README.lines().find(|line| line.starts_with(&format!("| {label} |")));
        assert!(row.is_some_and(|row| row.ends_with(&cost)), "{label} costs {cost}, the README has {row:?}");
    }
    let light =
        Irradiance::from_harmonics(std::array::from_fn(|term| [0.9, 0.1, 0.2].map(|color| color + term as f32)))?;
    for (label, tier) in [
        ("four Gaussians", IrradianceTier::FourGaussians),
        ("three Gaussians", IrradianceTier::ThreeGaussians),
        ("five slopes", IrradianceTier::Points),
        ("the normal of the mean slope", IrradianceTier::Normal),
    ] {
        let cost = counted(Scene::new("quoting").irradiance(light).irradiance_tier(tier))?;
        let cost = format!("{} operations |", cost.operations);
        let row = README.lines().find(|line| line.starts_with(&format!("| {label} |")));
        assert!(row.is_some_and(|row| row.ends_with(&cost)), "{label} costs {cost}, the README has {row:?}");
    }
    Ok(())
}
