//! Brute force of the report: its samples end up at the integrals that filters are judged by.

use std::error::Error;

use prefilter::gpu::Device;
use spirv_tests::random::Random;
use spirv_tests::report::filters::brute::Brute;
use spirv_tests::report::filters::case::Case;
use spirv_tests::report::filters::{cases, pixel::Pixel};

type Outcome = Result<(), Box<dyn Error + Send + Sync>>;

/// Pixels of each case, and runs of 1024 samples each that are averaged.
const PIXELS: usize = 8;
const RUNS: usize = 64;

/// The mean of all runs of a case and how far it may be by chance: their deviation over √RUNS.
fn averaged(device: &Device, case: &Case, pixels: &[Pixel]) -> Result<Vec<[[f64; 2]; 3]>, prefilter::Error> {
    let kernel = case.brute.kernel(device)?;
    let many: Vec<Pixel> = pixels.iter().flat_map(|pixel| [*pixel; RUNS]).collect();
    let colors = kernel.run(&Brute::points(&kernel, &many, 32, 77))?;
    let of = |runs: &[[f32; 4]], channel: usize| {
        let values = || runs.iter().map(|color| f64::from(color[channel]));
        let mean = values().sum::<f64>() / RUNS as f64;
        let variance = values().map(|value| (value - mean).powi(2)).sum::<f64>() / (RUNS - 1) as f64;
        [mean, (variance / RUNS as f64).sqrt()]
    };
    Ok(colors.chunks_exact(RUNS).map(|runs| [0, 1, 2].map(|channel| of(runs, channel))).collect())
}

/// Within five standard errors and a thousandth, for self-normalized sums are biased by one over their samples.
#[test]
fn samples_converge_to_the_reference() -> Outcome {
    let device = Device::new()?;
    for case in cases(2)? {
        let mut random = Random::new(0xb4);
        let pixels: Vec<Pixel> = (0..PIXELS).map(|_| case.drawn.pixel(&mut random)).collect();
        let (mut worst, mut largest) = (0.0f64, 0.0f64);
        for (pixel, color) in pixels.iter().zip(averaged(&device, &case, &pixels)?) {
            let truth = (case.truth)(pixel);
            for (channel, [mean, error]) in color.into_iter().enumerate() {
                let apart = (mean - truth[channel]).abs();
                assert!(
                    apart <= 5.0 * error + 1e-3,
                    "{}: {mean} ± {error}, not {}: {pixel:?}",
                    case.stem,
                    truth[channel]
                );
                worst = worst.max(apart);
                largest = largest.max((truth[channel] - color_at_first(&case, channel)).abs());
            }
        }
        println!("{}: {} pixels, the worst mean is off by {worst:.1e}", case.stem, pixels.len());
        assert!(largest > 0.05, "{}: all colors are alike, which tells nothing", case.stem);
    }
    Ok(())
}

/// A channel of the truth at one pixel, to tell others from.
fn color_at_first(case: &Case, channel: usize) -> f64 {
    let pixel = case.drawn.pixel(&mut Random::new(0xb4));
    (case.truth)(&pixel)[channel]
}
