//! What filtering and the variance cost beside the plain sum of kernels: counted and timed.

use prefilter::gpu::{Device, Dispatch, Work};
use prefilter::reference::gabor::within;
use prefilter::reference::gabor_kernel::{distance, farthest, product, REACH};
use prefilter::{Gabor, GaborMethod, Module, Spectrum};
use spirv_tests::random::Random;

use crate::{kernel, module, noise, place, Found, Outcome, CELL};

/// The frequency of the noise for a bandwidth of 1.
const FREQUENCY: f32 = 1.3;

/// Kernels a cell of the count.
const KERNELS: u32 = 2;

/// The plain sum, for a number of kernels a cell.
fn plain(kernels: u32) -> String {
    let plain = include_str!("plain.wgsl").replace("KERNELS", &kernels.to_string());
    plain.replace("FREQUENCY", &format!("{:?}", 0.8 * FREQUENCY))
}

/// The footprint of a deviation on the picture's plane.
fn on(deviation: f64) -> [[f64; 3]; 2] {
    [[0.36, 0.48, 0.8], [0.8, -0.6, 0.0]].map(|vector| vector.map(|part| part * deviation))
}

/// A picture of a plane: positions with the footprints of its pixels, whose deviations are this share of 1/a.
fn picture(side: usize, deviation: f64) -> Vec<f32> {
    let [across, along] = on(deviation);
    let pixels = (0..side * side).map(|pixel| [2.0 * (pixel % side) as f64, 2.0 * (pixel / side) as f64]);
    let numbers = pixels.flat_map(|[x, y]| {
        let position = [0, 1, 2].map(|axis| x * across[axis] + y * along[axis] + 7.3);
        [position, across, along].concat()
    });
    numbers.map(|number| number as f32).collect()
}

/// The least of the times of each, interleaved.
fn fastest(all: &[Dispatch]) -> Found<Vec<f64>> {
    let mut least = vec![f64::INFINITY; all.len()];
    // Short runs, and many: some are not disturbed.
    for round in 0..200 {
        for turn in 0..all.len() {
            let which = (turn + round) % all.len();
            least[which] = least[which].min(all[which].time()?);
        }
    }
    Ok(least)
}

/// Kernels that a point sees in cells within reach: beyond the farthest, near, and counted; on average over points.
fn seen(deviation: f64) -> [f64; 3] {
    let footprint = on(deviation / CELL);
    let farthest = farthest(footprint);
    let mut random = Random::new(2);
    let mut classes = [0.0; 3];
    const POINTS: u32 = 200;
    for _ in 0..POINTS {
        let position = place(&mut random, 50.0);
        let corner = position.map(|part| (part - 1.5).floor());
        for cell in 0..64 {
            let offset = [cell & 3, cell >> 2 & 3, cell >> 4].map(f64::from);
            let apart = [0, 1, 2].map(|axis| position[axis] - corner[axis] - offset[axis]);
            let outside = apart.map(|part| (part - 1.0).max(-part).max(0.0));
            if product(outside, outside) >= farthest {
                continue;
            }
            for (apart, _) in within(apart, [random.word(), random.word(), random.word()], 1) {
                let class = match (product(apart, apart) < farthest, distance(apart, footprint) < REACH * REACH) {
                    (false, _) => 0,
                    (true, false) => 1,
                    (true, true) => 2,
                };
                classes[class] += 1.0 / f64::from(POINTS);
            }
        }
    }
    classes
}

/// Operations of a function that sums kernels: its own and those of all cells, and of the kernels in cells within reach
/// the hash and the place, whether one is then found too far, or near but not counted, or added.
fn counted(cost: &dyn Fn(&str) -> Found<usize>, deviation: f64, [all, cell, kernel]: [&str; 3]) -> Found<f64> {
    let (cell, kernel) = (cost(cell)?, cost(kernel)?);
    // As written, each loop has one turn.
    let own = cost(all)? - cell + 63 * cost("step")?;
    let each = [cost("far")?, cost("near")?, kernel].map(|part| cell - kernel + part);
    let kernels: f64 = seen(deviation).into_iter().zip(each).map(|(count, part)| count * part as f64).sum();
    Ok(own as f64 + f64::from(KERNELS) * kernels)
}

/// What filtering adds, and the variance with it. A plain sum that gives the gradient, too, is the like: filters of
/// slopes need it, and the variance does.
#[test]
fn filtering_and_variance_add_few_operations() -> Outcome {
    let module = module(Gabor { kernels: KERNELS, ..noise(Spectrum::Isotropic { frequency: FREQUENCY }) })?;
    let shader = module.link(&plain(KERNELS))?;
    let cost = |name: &str| -> Found<usize> {
        Ok(shader.cost(name).map(|cost| cost.operations).ok_or(format!("no `{name}`"))?)
    };
    let value = counted(&cost, 0.0, ["plain_value", "plain_cell", "plain_kernel"])?;
    let steep = counted(&cost, 0.0, ["steep_value", "steep_cell", "steep_kernel"])?;
    let kernels = ["plain_kernel", "steep_kernel", "gabor_kernel"].map(cost);
    println!("a point {value:.0}, with its gradient {steep:.0}; a kernel, with its gradient, filtered: {kernels:?}");
    // Wider footprints stretch kernels, and more of them count.
    for (deviation, most) in [(0.0, 1.15), (0.02, 1.15), (0.1, 1.2), (0.3, 2.0)] {
        let ours = counted(&cost, deviation, ["wood_statistics", "gabor_cell", "gabor_kernel"])?;
        let [far, near, within] = seen(deviation);
        println!("σ {deviation}/a: {far:.1} far, {near:.1} near, {within:.1} counted of a kernel a cell");
        let (value, steep) = (ours / value, ours / steep);
        println!("    {ours:.0} operations: of the value {value:.3}, of it with its gradient {steep:.3}");
        assert!(steep < most, "{deviation}: {steep}");
    }
    Ok(())
}

/// The same in time. Mesa's software rasterizer evaluates the kernels that are culled, too: all of them count.
#[test]
fn filtering_and_variance_take_little_time() -> Outcome {
    // The number of threads is read when a device is made.
    std::env::set_var("LP_NUM_THREADS", "1");
    let device = Device::new()?;
    for kernels in [1, 2, 4] {
        let gabor = Gabor { kernels, ..noise(Spectrum::Isotropic { frequency: FREQUENCY }) };
        let [ours, paper] = [GaborMethod::Exact, GaborMethod::Paper].map(|method| module(Gabor { method, ..gabor }));
        let (ours, paper) = (ours?, paper?);
        let run = |module: &Module, function: &str| {
            let call = format!("{function}({{0}}, {{1}}, {{2}})");
            kernel(&device, module, &plain(kernels), &call, 9)
        };
        let all = [
            run(&ours, "plain_value")?,
            run(&ours, "steep_value")?,
            run(&ours, "wood_statistics")?,
            run(&paper, "wood_statistics")?,
        ];
        let points = picture(32, 0.1);
        let work = Work { inputs: &[&points], textures: &[], invocations: 32 * 32, output: 4 * 32 * 32 };
        let all = all.map(|kernel| kernel.prepare(&work));
        let all = all.into_iter().collect::<Result<Vec<_>, _>>()?;
        let times = fastest(&all)?;
        let [value, steep, paper] = [0, 1, 3].map(|which| times[2] / times[which]);
        println!(
            "{kernels} kernels, {:.2} ms: of the value {value:.3}, of it with its gradient {steep:.3}",
            1e3 * times[2]
        );
        println!("    of the paper's form, which has no gradient, {paper:.3}");
        assert!(steep < 1.5, "{steep}");
    }
    Ok(())
}
