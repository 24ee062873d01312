//! Footprints of nothing are points, and the widest ones, singular ones among them, stay colors of the map: patterns,
//! and sums of cosines beside them.

use prefilter::driver::cosines::Wave;
use prefilter::driver::pattern::Motif;
use prefilter::gpu::Device;
use prefilter::reference::pattern::{checker_at, grid_at};
use prefilter::{ColorMap, Cosines, Driver, Kernel, Pattern, Scene, Taps, Tier};
use spirv_tests::exports::ExportKernel;

type Outcome = Result<(), Box<dyn std::error::Error + Send + Sync>>;

const POSITION: [f32; 2] = [0.7, 2.96];

/// Positions near and far with derivatives of every size.
fn points() -> Vec<f32> {
    let ends = [0.0, 1e-45, 1e-30, 1e-3, 1.0, -1e9, 1e30, f32::MAX];
    let steps = ends.into_iter().flat_map(|x| ends.map(|y| [[x, 0.0], [0.0, y], [x, y], [y, -x]]));
    let steps: Vec<[f32; 2]> = steps.flatten().collect();
    let places = [POSITION, [1e4, -3.7e6], [-1e30, 0.5], [f32::MAX, -1e-45]];
    let pairs = steps.iter().flat_map(|x| steps.iter().map(move |y| (x, y)));
    pairs.flat_map(|(x, y)| places.iter().flat_map(move |at| [&at[..], x, y].concat())).collect()
}

#[test]
fn any_derivatives_give_colors_of_the_map() -> Outcome {
    let device = Device::new()?;
    let map = ColorMap::gradient([(0.0, [0.25, 0.0, 0.5]), (1.0, [0.75, 1.0, 0.5])])?;
    let at = POSITION.map(f64::from);
    let wave = |x: f32, y: f32, amplitude: f32| Wave { frequency: [x, y], amplitude, phase: 0.3 };
    let waves = vec![wave(0.8, 0.1, 0.2), wave(-3.0, 1e6, 0.1), wave(0.0, 0.0, 0.05)];
    let sum: f64 = waves
        .iter()
        .map(|wave| {
            let [x, y] = wave.frequency.map(f64::from);
            f64::from(wave.amplitude) * (std::f64::consts::TAU * (x * at[0] + y * at[1] + 0.3)).cos()
        })
        .sum();
    // One wave is so short that f32 does not hold its phase.
    let drivers = [
        (Motif::Stripes { duty: 0.3 }, 0.0, 1e-6),
        (Motif::Checker, f64::from(u8::from(checker_at(at))), 1e-6),
        (Motif::Grid { widths: [0.1, 0.2] }, f64::from(u8::from(grid_at(at, [0.1, 0.2]))), 1e-6),
    ]
    .map(|(motif, value, allowed)| (Driver::Pattern(Pattern { motif, ..Pattern::default() }), value, allowed));
    let sums = (Driver::Cosines(Cosines { waves, mean: 0.5, ..Cosines::default() }), 0.5 + sum, 0.2);
    let points = points();
    for (driver, value, allowed) in drivers.into_iter().chain([sums]) {
        for taps in [Taps::One, Taps::Four] {
            let driver = match driver.clone() {
                Driver::Pattern(pattern) => Driver::Pattern(Pattern { taps, ..pattern }),
                Driver::Cosines(cosines) => Driver::Cosines(Cosines { taps, ..cosines }),
                other => other,
            };
            let scene = Scene::new("moss").texture(map.clone()).tier(Tier::ClosedForm(Kernel::Exact));
            let module = scene.driver(driver.clone()).module()?;
            let export = module.exports().iter().find(|export| export.name == "moss_color").unwrap();
            let found = ExportKernel::new(&device, &module, export)?.run(&points)?;
            assert_eq!(6 * found.len(), points.len());
            for (place, color) in points.chunks_exact(6).zip(&found) {
                let inside = (0.25..=0.75).contains(&color[0]) && (0.0..=1.0).contains(&color[1]) && color[2] == 0.5;
                assert!(inside, "{driver:?} at {place:?}: {color:?}");
                if place[..2] == POSITION && place[2..].iter().all(|part| part.abs() < 1e-20) {
                    let error = (f64::from(color[1]) - value).abs();
                    assert!(error <= allowed, "{driver:?} at {place:?}: {color:?} is not {value}");
                }
            }
        }
    }
    Ok(())
}
