//! Patterns as drivers: the colors of a pixel are those of both values by the share of its footprint.

use prefilter::driver::pattern::Motif;
use prefilter::gpu::Device;
use prefilter::reference::pattern::{checker, grid};
use prefilter::reference::pulse::Footprint;
use prefilter::{Driver, HeightTier, Kernel, Pattern, Pixel, Scene, Taps, Tier};
use spirv_tests::exports::ExportKernel;
use spirv_tests::maps::named;
use spirv_tests::random::Random;

type Outcome = Result<(), Box<dyn std::error::Error + Send + Sync>>;

/// Position and derivatives of pixels that are up to a few periods long.
fn pixels(count: usize, seed: u32) -> Vec<[f32; 6]> {
    let mut next = Random::new(seed);
    (0..count)
        .map(|_| {
            let (size, turn) = (next.between(0.05, 3.0), std::f64::consts::TAU * next.unit());
            let (long, lean) = (size * next.between(1.0, 8.0), 0.6 * next.unit() - 0.3);
            let (sin, cos) = turn.sin_cos();
            let place = [20.0 * next.unit(), 20.0 * next.unit() - 10.0];
            let derivatives = [long * cos, long * sin, size * (lean * cos - sin), size * (lean * sin + cos)];
            [place[0], place[1], derivatives[0], derivatives[1], derivatives[2], derivatives[3]].map(|x| x as f32)
        })
        .collect()
}

fn share(motif: Motif, pixel: &[f32; 6], deviation: f64) -> f64 {
    let [x, y, a, b, c, d] = pixel.map(f64::from);
    let footprint = [a * a + c * c, a * b + c * d, b * b + d * d].map(|entry| deviation * deviation * entry);
    match motif {
        Motif::Stripes { duty } => Footprint::Gaussian(footprint[0].sqrt()).train(x, duty.into()),
        Motif::Checker => checker([x, y], footprint),
        Motif::Grid { widths } => grid([x, y], widths.map(f64::from), footprint),
    }
}

/// Any map is exact but for the share, at its own values too, where one normal distribution would be wrong.
#[test]
fn colors_are_mixed_from_those_of_both_values() -> Outcome {
    let device = Device::new()?;
    let motifs = [Motif::Stripes { duty: 0.3 }, Motif::Checker, Motif::Grid { widths: [0.2, 0.05] }];
    let map = named("terrain")?;
    let reference = map.reference();
    for (motif, (values, taps)) in motifs.into_iter().flat_map(|motif| {
        [([0.0, 1.0], Taps::One), ([0.8, 0.2], Taps::One), ([0.1, 0.6], Taps::Four)].map(|case| (motif, case))
    }) {
        let pattern = Pattern { motif, values, taps, pixel: Pixel::Round(0.4) };
        let scene = Scene::new("tiles").texture(map.clone()).tier(Tier::ClosedForm(Kernel::Exact));
        let module = scene.driver(Driver::Pattern(pattern)).module()?;
        let export = module.exports().iter().find(|export| export.name == "tiles_color").unwrap();
        let pixels = pixels(2000, 5);
        let points: Vec<f32> = pixels.iter().flatten().copied().collect();
        let colors = ExportKernel::new(&device, &module, export)?.run(&points)?;
        let ends = values.map(|value| reference.value(value.into()));
        let mut worst = 0.0f64;
        assert_eq!(colors.len(), pixels.len());
        for (pixel, color) in pixels.iter().zip(&colors) {
            let share = share(motif, pixel, f64::from(0.4f32));
            for channel in 0..3 {
                let truth = ends[0][channel] + share * (ends[1][channel] - ends[0][channel]);
                worst = worst.max((f64::from(color[channel]) - truth).abs());
            }
        }
        println!("{motif:?} {values:?} {taps:?}: {worst:.1e}");
        // Four taps are a mixture that has the footprint's covariance, not its normal distribution.
        let allowed = if taps == Taps::One { 0.01 } else { 0.15 };
        assert!(worst < allowed, "{motif:?} {values:?} {taps:?}: {worst}");
    }
    Ok(())
}

/// Heights take mean and deviation, as of any driver; slopes are not known.
#[test]
fn heights_take_a_pattern_and_slopes_do_not() -> Outcome {
    let driver = || Driver::Pattern(Pattern::default());
    let heights = Scene::new("tiles").height(named("terrain")?).height_tier(HeightTier::ClosedForm);
    assert!(heights.driver(driver()).module()?.wgsl().contains("pattern_moments"));
    let refused = Scene::new("tiles").slope(named("terrain")?).driver(driver()).module().map(|_| ());
    assert!(refused.unwrap_err().to_string().contains("a `slope` goes without a driver"));
    let flat = Driver::Pattern(Pattern { values: [0.5, 0.5], ..Pattern::default() });
    let refused = Scene::new("tiles").texture(named("terrain")?).driver(flat).module().map(|_| ());
    assert!(refused.unwrap_err().to_string().contains("the pattern's second value is 0.5"));
    Ok(())
}
