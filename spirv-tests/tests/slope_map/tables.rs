//! How far the tables are from the means over round distributions, on the device against the f64 integral.

use prefilter::gpu::Device;
use prefilter::{Ranges, Scene, SlopeDomain, SlopeMap, SlopeTaps, SlopeTier};
use spirv_tests::exports::ExportKernel;
use spirv_tests::random::Random;

use crate::{edges, single, Fault, Outcome};

/// Reads of the table alone, with the table's own errors from the floor on and over all deviations.
struct Read {
    kernel: ExportKernel,
    error: f64,
    below: f64,
}

fn read(device: &Device, map: &SlopeMap, ranges: Ranges) -> Result<Read, Fault> {
    let scene = Scene::new("judged").slope_map(map.clone()).ranges(ranges);
    let module = scene.slope_tier(SlopeTier::Unweighted).slope_taps(SlopeTaps::One).module()?;
    let text = module.exports()[0].documentation.clone();
    let below = text.split_once("The table errs by up to ").and_then(|(_, rest)| rest.split_once(','));
    Ok(Read {
        kernel: ExportKernel::new(device, &module, &module.exports()[0])?,
        error: module.tables()[0].error.into(),
        below: below.ok_or("no error below the floor")?.0.parse()?,
    })
}

/// The largest error over round distributions whose deviations are between two.
fn error(read: &Read, map: &SlopeMap, most: f64, deviations: [f64; 2]) -> Result<f64, Fault> {
    let mut random = Random::new(31);
    let calls: Vec<[f64; 5]> = (0..100)
        .map(|_| {
            let [x, y] = [0, 1].map(|_| most * (2.0 * random.unit() - 1.0));
            let deviation = random.between(deviations[0], deviations[1]);
            single([x, y, deviation * deviation, 0.0, deviation * deviation])
        })
        .collect();
    let numbers: Vec<f32> = calls.iter().flatten().map(|&number| number as f32).collect();
    let (reference, mut worst) = (map.reference(), 0.0f64);
    for (color, &[x, y, xx, xy, yy]) in read.kernel.run(&numbers)?.iter().zip(&calls) {
        for (value, truth) in color.iter().zip(reference.mean([x, y], [xx, xy, yy])) {
            let error = (f64::from(*value) - truth).abs();
            assert!(error.is_finite());
            worst = worst.max(error);
        }
    }
    Ok(worst)
}

/// Edges of a step, a disc and a quarter of all directions, as sharp as 128 cells have them.
#[test]
fn tables_keep_their_figures() -> Outcome {
    let device = Device::new()?;
    let (within, all) = (SlopeDomain::Within(1.0), SlopeDomain::All);
    let usual = Ranges { mean: (-1.0, 1.0), deviation: 0.5 };
    let wide = Ranges { deviation: 1.0, ..usual };
    for (domain, turn, ranges, figure) in [
        (within, 0.0, usual, 5e-3),
        (within, 0.4, usual, 5e-3),
        (within, 0.785, usual, 5e-3),
        (within, 0.4, wide, 1e-1),
        (all, 0.0, usual, 1e-1),
        (all, 0.4, usual, 1e-1),
        (all, 0.785, usual, 1e-1),
    ] {
        let map = edges(128, domain, turn)?;
        let read = read(&device, &map, ranges)?;
        let wide = f64::from(ranges.deviation);
        let found = error(&read, &map, 1.0, [0.12, wide])?;
        let small = error(&read, &map, 1.0, [1e-3, 0.12])?;
        println!(
            "{domain:?} turned by {turn}, deviations to {wide}: {found:.2e} from 0.12, {small:.2e} below; baked {:.2e} \
             from {:.2}, {:.2e} below",
            read.error,
            0.24 * wide,
            read.below
        );
        assert!(found <= figure && read.error <= figure && found <= read.error, "{domain:?}: {found}");
        assert!(small <= read.below, "{domain:?}: {small}");
    }
    Ok(())
}
