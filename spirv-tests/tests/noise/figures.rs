//! Question 3: colors of noise on a plane up to the horizon, by one evaluation and by several taps.

use prefilter::gpu::Device;
use prefilter::{Driver, Kernel, Module, Noise, NoiseMethod, Scene, Taps, Tier};
use spirv_tests::horizon::square;
use spirv_tests::maps::named;

use crate::plane::{filtered, Plane, Truth};
use crate::{octaves, Found, Outcome};

const SEEDS: [u32; 4] = [1, 2, 3, 4];

/// A module of six octaves of Perlin's noise under a map.
fn module(map: &str, tier: Tier, noise: Noise) -> Found<Module> {
    Ok(Scene::new("rock").texture(named(map)?).tier(tier).driver(Driver::Noise(noise)).module()?)
}

/// Root mean square errors in thousandths by six ways, with their standard errors over the seeds, and that of the
/// truth.
fn errors(device: &Device, map: &str) -> Found<Vec<(&'static str, f64, f64)>> {
    let exact = Tier::ClosedForm(Kernel::Exact);
    let taps = |taps| (exact, Noise { taps, ..Noise::default() });
    let bent = |taps| (exact, Noise { taps, method: NoiseMethod::Curvature, ..Noise::default() });
    let ways = [
        ("C(f̄)", (Tier::Naive, Noise::default())),
        ("paper", (exact, Noise { method: NoiseMethod::Stationary, ..Noise::default() })),
        ("1 tap", taps(Taps::One)),
        ("2 taps", taps(Taps::Two)),
        ("4 taps", taps(Taps::Four)),
        ("8 taps", taps(Taps::Eight)),
        ("curvature", bent(Taps::One)),
        ("curvature, 2 taps", bent(Taps::Two)),
        ("curvature, 4 taps", bent(Taps::Four)),
        ("curvature, 8 taps", bent(Taps::Eight)),
    ];
    let mut squares = vec![Vec::new(); ways.len() + 2];
    for seed in SEEDS {
        let (plane, noise) = (Plane::new(seed), Noise { seed, ..Noise::default() });
        let halves = [17, 4711].map(|jitter| Truth::new(map, &octaves(&noise), 32, jitter));
        let [first, second] = halves;
        let (first, second) = (first?, second?);
        let (one, two) = (first.mean(device, &plane)?, second.mean(device, &plane)?);
        let truth: Vec<[f64; 3]> = one.iter().zip(&two).map(|(a, b)| [0, 1, 2].map(|c| 0.5 * (a[c] + b[c]))).collect();
        // Half the difference of two halves is the standard error of their mean.
        squares[0].push(square(&one, &two) / 4.0);
        squares[1].push(square(&first.naive(device, &plane)?, &truth));
        for (way, (_, (tier, of))) in ways.iter().enumerate() {
            let module = module(map, *tier, Noise { seed, ..*of })?;
            squares[2 + way].push(square(&filtered(device, &module, &plane)?, &truth));
        }
    }
    let names = ["truth", "C(f)"].into_iter().chain(ways.iter().map(|way| way.0));
    let figure = |(name, squares): (&'static str, Vec<f64>)| {
        let count = squares.len() as f64;
        let mean = squares.iter().sum::<f64>() / count;
        let spread = squares.iter().map(|square| (square - mean).powi(2)).sum::<f64>() / (count - 1.0);
        (name, 1e3 * mean.sqrt(), 1e3 * (spread / count).sqrt() / (2.0 * mean.sqrt()))
    };
    Ok(names.zip(squares).map(figure).collect())
}

/// What `explain` says of the errors under a terrain map and under hard steps, in thousandths.
fn said(noise: Noise) -> Found<[f64; 2]> {
    let module = module("terrain", Tier::Naive, noise)?;
    let explained = module.explain();
    let (_, gap) = explained.split_once("RMS of").ok_or("no figure")?;
    let numbers: Vec<f64> = gap.split_whitespace().filter_map(|word| word.parse().ok()).take(2).collect();
    Ok([1e3 * numbers[0], 1e3 * numbers[1]])
}

/// Largest errors of a channel, root mean square over the pixels of four planes, against 2048 stratified samples a
/// pixel.
#[test]
fn one_evaluation_tells_most_of_a_footprint() -> Outcome {
    let device = Device::new()?;
    for (map, [one, four, eight]) in [("terrain", [55.0, 36.0, 29.0]), ("steps6", [60.0, 40.0, 32.0])] {
        let found = errors(&device, map)?;
        println!(
            "{map}, thousandths: {}",
            found.iter().map(|(n, e, s)| format!("{n} {e:.1} ± {s:.1}")).collect::<Vec<_>>().join(", ")
        );
        let of = |name: &str| found.iter().find(|figure| figure.0 == name).map_or(f64::NAN, |figure| figure.1);
        for (name, limit) in [("1 tap", one), ("4 taps", four), ("8 taps", eight)] {
            let error = found.iter().find(|figure| figure.0 == name).map_or(f64::NAN, |figure| figure.2);
            assert!(of(name) <= limit, "{map} {name}: {}", of(name));
            assert!(error < of(name) / 3.0 && of("truth") < of(name) / 3.0, "{map} {name}: not measured well enough");
        }
        let column = usize::from(map == "steps6");
        for (method, names) in [
            (NoiseMethod::Gradient, ["1 tap", "2 taps", "4 taps", "8 taps"]),
            (NoiseMethod::Curvature, ["curvature", "curvature, 2 taps", "curvature, 4 taps", "curvature, 8 taps"]),
        ] {
            for (name, taps) in names.into_iter().zip([Taps::One, Taps::Two, Taps::Four, Taps::Eight]) {
                let said = said(Noise { taps, method, ..Noise::default() })?[column];
                assert!((said / of(name) - 1.0).abs() < 0.06, "{map} {name}: said is {said}, found {}", of(name));
            }
        }
        let said = said(Noise { method: NoiseMethod::Stationary, ..Noise::default() })?[column];
        assert!((said / of("paper") - 1.0).abs() < 0.06, "{map} paper: said is {said}, found {}", of("paper"));
        assert!(of("curvature") < 0.87 * of("1 tap") && of("curvature, 2 taps") < 0.87 * of("2 taps"));
        assert!(of("1 tap") < 0.8 * of("paper") && of("paper") < 0.5 * of("C(f)") && of("paper") < 0.5 * of("C(f̄)"));
    }
    Ok(())
}
