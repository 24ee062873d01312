//! Octaves folded at 0: what a point tells of their footprints, and what their values are taken for.

use prefilter::gpu::Device;
use prefilter::{Distribution, Driver, Kernel, Noise, NoiseBasis, NoiseFold, Scene, Taps, Tier};
use spirv_tests::horizon::{colors, square};
use spirv_tests::maps::named;
use spirv_tests::random::Random;

use crate::plane::{filtered, Plane, Truth};
use crate::{at, octaves, Outcome};

/// Means of |n| over the plane, over the deviations of the noises.
const SHARES: [(NoiseBasis, &str, f64); 3] = [
    (NoiseBasis::Perlin, "perlin", 0.8166),
    (NoiseBasis::Value, "value", 0.837),
    (NoiseBasis::Simplex, "simplex", 0.8667),
];

/// A function `truth_noise(position: vec2f) -> f32`: the definition of the folded noise, from that of the one that is
/// not folded, for a mean of 0.5 and a deviation of 0.18.
fn folded(noise: &Noise, share: f64) -> String {
    let Noise { octaves: count, gain, .. } = *noise;
    let sum = |power: i32| -> f64 { (0..count).map(|octave| f64::from(gain).powi(power * octave as i32)).sum() };
    let sign = if noise.fold == NoiseFold::Ridged { -1.0 } else { 1.0 };
    // A sum of mean 0 and deviation 1 over the plane.
    let unit = Noise { fold: NoiseFold::None, mean: 0.0, deviation: sum(2).sqrt() as f32, ..*noise };
    let text = octaves(&unit);
    let start = text.find("sum += ").map_or(0, |at| at + "sum += ".len());
    let end = text[start..].find(";\n").map_or(start, |length| start + length);
    let (mean, scale) = (sum(1) * share, 0.18 / (sum(2) * (1.0 - share * share)).sqrt());
    let inner = format!("{}abs({}){}", &text[..start], &text[start..end], &text[end..]);
    inner.replace("return sum;", &format!("return 0.5 + {:?} * (sum - {mean:?});", sign * scale))
}

/// The mean and the variance of |n| over the plane are those that the driver has of it.
#[test]
fn folded_octaves_have_these_means() -> Outcome {
    let device = Device::new()?;
    let mut random = Random::new(17);
    for (basis, name, share) in SHARES {
        let place = |random: &mut Random| [0, 1].map(|_| f64::from((400.0 * random.unit() - 200.0) as f32));
        let point = |_| {
            let [x, y] = place(&mut random);
            let period: &[f64] = if basis == NoiseBasis::Simplex { &[] } else { &[0.0, 0.0] };
            [&[x, y], period, &[f64::from(random.word() % 1000)]].concat()
        };
        let points: Vec<Vec<f64>> = (0..1_000_000).map(point).collect();
        let found: Vec<f64> =
            at(&device, &format!("{name}_noise"), &points)?.into_iter().map(|noise| noise[0]).collect();
        let mean = |of: &dyn Fn(f64) -> f64| found.iter().map(|&noise| of(noise)).sum::<f64>() / found.len() as f64;
        let measured = mean(&f64::abs) / mean(&|noise| noise * noise).sqrt();
        println!("{name}: {measured:.4}, taken for {share}");
        // The standard error is 5e-4.
        assert!((measured - share).abs() < 1.5e-3, "{name}: {measured}");
    }
    Ok(())
}

#[test]
fn the_papers_method_knows_no_folds() {
    let noise = Noise { fold: NoiseFold::Ridged, method: prefilter::NoiseMethod::Stationary, ..Noise::default() };
    let map = named("terrain").unwrap();
    let error = Scene::new("rock").texture(map).driver(Driver::Noise(noise)).module().unwrap_err();
    assert!(matches!(error, prefilter::Error::Conflict(_)), "{error}");
}

/// A point has its value and no variance, the whole plane the mean and the deviation asked for.
#[test]
fn footprints_of_nothing_and_of_all() -> Outcome {
    let device = Device::new()?;
    for (basis, _, share) in SHARES {
        for fold in [NoiseFold::Turbulence, NoiseFold::Ridged] {
            let noise = Noise { basis, fold, seed: 5, ..Noise::default() };
            let map = named("terrain")?;
            let module = Scene::new("rock").texture(map).tier(Tier::Naive).driver(Driver::Noise(noise)).module()?;
            let statistics = "fn color(p: array<f32, 6>) -> vec3f {
    return rock_statistics(vec2f(p[0], p[1]), vec2f(p[2], p[3]), vec2f(p[4], p[5])).xyz;
}";
            let text = module.link(statistics)?.wgsl().to_owned();
            let definition = format!(
                "fn color(p: array<f32, 6>) -> vec3f {{ return vec3f(truth_noise(vec2f(p[0], p[1])), 0.0, 0.0); }}\n{}",
                folded(&noise, share)
            );
            let definition = module.link(&definition)?.wgsl().to_owned();
            let mut random = Random::new(3);
            let mut points = |size: f32| -> Vec<f32> {
                let place = |random: &mut Random| (40.0 * random.unit() - 20.0) as f32;
                (0..400).flat_map(|_| [place(&mut random), place(&mut random), size, 0.0, 0.0, size]).collect()
            };
            let near = points(0.0);
            for (found, truth) in colors(&device, &text, &near)?.iter().zip(colors(&device, &definition, &near)?) {
                assert!((found[0] - truth[0]).abs() < 2e-5 && found[1] < 1e-9, "{noise:?}: {found:?} {truth:?}");
            }
            for found in colors(&device, &text, &points(1e4))? {
                assert!((found[0] - 0.5).abs() < 1e-3 && (found[1].sqrt() - 0.18).abs() < 1e-3, "{found:?}");
            }
        }
    }
    Ok(())
}

/// Root mean square errors in thousandths, one map and fold: as normal distributions by one, two, four and eight taps,
/// and as Beta distributions from the fold to five deviations beyond the mean by one; and the naive map's.
fn errors(device: &Device, map: &str, fold: NoiseFold) -> Result<[f64; 6], Box<dyn std::error::Error + Send + Sync>> {
    let share = SHARES[0].2;
    let noise = |seed, taps| Noise { fold, seed, taps, ..Noise::default() };
    let mut squares = [0.0; 6];
    let seeds = [1, 2, 3, 4];
    for seed in seeds {
        let plane = Plane::new(seed);
        let halves = [17, 4711].map(|jitter| Truth::new(map, &folded(&noise(seed, Taps::One), share), 24, jitter));
        let [first, second] = halves;
        let (first, second) = (first?, second?);
        let (one, two) = (first.mean(device, &plane)?, second.mean(device, &plane)?);
        let truth: Vec<[f64; 3]> = one.iter().zip(&two).map(|(a, b)| [0, 1, 2].map(|c| 0.5 * (a[c] + b[c]))).collect();
        let scene = |taps| Ok::<_, prefilter::Error>(Scene::new("rock").driver(Driver::Noise(noise(seed, taps))));
        for (taps, square_of) in [Taps::One, Taps::Two, Taps::Four, Taps::Eight].into_iter().zip(&mut squares) {
            let module = scene(taps)?.texture(named(map)?).tier(Tier::ClosedForm(Kernel::Exact)).module()?;
            *square_of += square(&filtered(device, &module, &plane)?, &truth);
        }
        // Where all octaves are 0, and the other way.
        let octaves = |power: i32| -> f64 { (0..6).map(|octave| 0.5f64.powi(power * octave)).sum() };
        let fold_at = 0.18 * octaves(1) * share / (octaves(2) * (1.0 - share * share)).sqrt();
        let [low, high] = match fold {
            NoiseFold::Ridged => [0.5 - 0.9, 0.5 + fold_at],
            _ => [0.5 - fold_at, 0.5 + 0.9],
        };
        let bounded = Distribution::Beta { low: low as f32, high: high as f32 };
        let module = scene(Taps::One)?.texture(named(map)?).distribution(bounded).module()?;
        squares[4] += square(&tabled(device, &module, &plane)?, &truth);
        squares[5] += square(&first.naive(device, &plane)?, &truth);
        assert!(square(&one, &two) / 4.0 < 3e-5, "the truth is not known well enough");
    }
    Ok(squares.map(|sum| 1e3 * (sum / seeds.len() as f64).sqrt()))
}

/// The colors of a `NAME_color` that reads a table.
fn tabled(
    device: &Device,
    module: &prefilter::Module,
    plane: &Plane,
) -> Result<Vec<[f64; 3]>, Box<dyn std::error::Error + Send + Sync>> {
    let export = module.exports().iter().find(|export| export.name.ends_with("_color")).ok_or("no color")?;
    let found = spirv_tests::exports::ExportKernel::new(device, module, export)?.run(&plane.points())?;
    Ok(found.into_iter().map(|color| [0, 1, 2].map(|channel| f64::from(color[channel]))).collect())
}

/// The table of `NoiseFold`'s documentation, in thousandths.
fn documented(line: &str) -> Option<Vec<f64>> {
    let text = include_str!("../../../src/driver/fold.rs");
    let row = text.lines().find_map(|row| row.strip_prefix(&format!("/// | {line} | ")))?;
    row.trim_end_matches(" |").split(" | ").map(|number| number.parse().ok()).collect()
}

#[test]
fn folded_noise_keeps_its_figures() -> Outcome {
    let device = Device::new()?;
    let mut far = Vec::new();
    for (fold, name) in [(NoiseFold::Turbulence, "turbulence"), (NoiseFold::Ridged, "ridged")] {
        for map in ["terrain", "steps6"] {
            let found = errors(&device, map, fold)?;
            println!("{name}, {map}: 1, 2, 4, 8 taps, Beta by 1, naive: {found:.1?}");
            let figures = documented(&format!("{name}, {map}")).unwrap_or_default();
            if figures.len() != 6 || found.iter().zip(&figures).any(|(found, figure)| !((found - figure).abs() <= 1.0))
            {
                far.push(format!("{name}, {map}: {found:.1?} {figures:?}"));
            }
            for (figure, taps) in figures.iter().zip([Taps::One, Taps::Two, Taps::Four, Taps::Eight]) {
                let noise = Noise { fold, taps, ..Noise::default() };
                let module = Scene::new("rock").texture(named(map)?).tier(Tier::Naive).driver(Driver::Noise(noise));
                let said = format!("{:.3}", figure / 1e3);
                assert!(module.module()?.explain().contains(&said), "{name}, {map}: {said} is not said");
            }
        }
    }
    assert!(far.is_empty(), "{}", far.join("\n"));
    Ok(())
}
