//! Trains of pulses: far from the origin, as lines thinner than a pixel, and what a box in place of a Gaussian costs.

use prefilter::gpu::Device;
use prefilter::reference::normal::cumulative;
use prefilter::reference::pulse::Footprint;
use spirv_tests::kernel::Function;
use spirv_tests::random::Random;

fn shelf(name: &str) -> Function {
    Function::shelf().unwrap().into_iter().find(|function| function.name == name).unwrap()
}

/// The largest distance of a function from a reference over points.
fn most(device: &Device, function: &Function, points: &[Vec<f64>], truth: impl Fn(&[f64]) -> f64) -> f64 {
    let results = function.results(device, &[], points).unwrap();
    assert!(!points.is_empty() && results.len() == points.len());
    points.iter().zip(&results).map(|(point, result)| (result[0] - truth(point)).abs()).fold(0.0, f64::max)
}

/// Points as the device holds them.
fn random(count: usize, seed: u32, mut point: impl FnMut(&mut Random) -> [f64; 3]) -> Vec<Vec<f64>> {
    let mut random = Random::new(seed);
    (0..count).map(|_| point(&mut random).map(|number| f64::from(number as f32)).to_vec()).collect()
}

/// The difference of the integral at both ends, as `filteredpulsetrain` has it, loses its digits far from the origin.
#[test]
fn trains_keep_their_digits_far_from_the_origin() {
    let device = Device::new().unwrap();
    let naive = "fn naive(position: f32, duty: f32, width: f32) -> f32 {
        let low = position - 0.5 * width;
        let high = position + 0.5 * width;
        let filled = duty * floor(high) + min(high - floor(high), duty);
        return (filled - duty * floor(low) - min(low - floor(low), duty)) / width;
    }";
    let points = random(4000, 1, |next| [1e4 + next.unit(), 0.3, 1e-2]);
    let boxed = |point: &[f64]| Footprint::Box(point[2]).train(point[0], point[1]);
    let naive = most(&device, &Function::in_text(naive, "naive").unwrap(), &points, boxed);
    let ours = most(&device, &shelf("pulse_train_box"), &points, boxed);
    let gaussian = |point: &[f64]| Footprint::Gaussian(point[2]).train(point[0], point[1]);
    let own = most(&device, &shelf("pulse_train"), &points, gaussian);
    println!("at 1e4, 1e-2 wide: integrals at both ends {naive:.1e}, reduced first {ours:.1e}, Gaussian {own:.1e}");
    assert!(naive > 1e-2 && ours < 1e-6 && own < 2e-6);
}

/// Lines far narrower than a pixel converge to the share that they cover.
#[test]
fn thin_lines_converge_to_their_coverage() {
    let device = Device::new().unwrap();
    // A pixel of deviation one half of its width: four periods a pixel are a deviation of two periods.
    let points =
        random(20_000, 2, |next| [200.0 * next.unit(), next.between(1e-4, 0.5), 0.5 * next.between(4.0, 400.0)]);
    let worst = most(&device, &shelf("pulse_train"), &points, |point| point[1]);
    println!("four periods a pixel and more: coverage within {worst:.1e}");
    assert!(worst < 1e-6);
    let points = random(20_000, 3, |next| [200.0 * next.unit(), next.between(1e-4, 0.5), 0.5]);
    let worst = most(&device, &shelf("pulse_train"), &points, |point| point[1]);
    println!("one period a pixel: within {worst:.1e}");
    assert!(worst < 0.01);
    // A box of four periods has whole periods only where it is a whole number of them wide.
    let points = random(20_000, 4, |next| [200.0 * next.unit(), next.between(1e-4, 0.5), next.between(4.0, 400.0)]);
    let worst = most(&device, &shelf("pulse_train_box"), &points, |point| point[1]);
    println!("boxes of four periods and more: within {worst:.1e}");
    assert!(worst > 1e-3);
}

/// Lines of a grid in both directions, over footprints of four periods and more at any rotation.
#[test]
fn thin_lines_of_a_grid_converge_to_their_coverage() {
    let device = Device::new().unwrap();
    let mut next = Random::new(6);
    let point = |_| {
        let (sin, cos) = (std::f64::consts::TAU * next.unit()).sin_cos();
        let minor = 2.0 * next.between(1.0, 50.0);
        let (a, b) = ((minor * next.between(1.0, 16.0)).powi(2), minor * minor);
        let widths = [next.between(1e-3, 0.5), next.between(1e-3, 0.5)];
        let footprint = [a * cos * cos + b * sin * sin, (a - b) * cos * sin, a * sin * sin + b * cos * cos];
        let place = [200.0 * next.unit(), 200.0 * next.unit(), widths[0], widths[1]];
        [&place[..], &footprint].concat().into_iter().map(|number| f64::from(number as f32)).collect()
    };
    let points: Vec<Vec<f64>> = (0..20_000).map(point).collect();
    let coverage = |point: &[f64]| point[2] + point[3] - point[2] * point[3];
    let worst = most(&device, &shelf("pattern_grid"), &points, coverage);
    println!("lines both ways, four periods a pixel and more: coverage within {worst:.1e}");
    assert!(worst < 1e-6);
}

/// The three nearest edges, which are enough for one edge a period up to a deviation of a quarter of it, are too few
/// for the two edges of a pulse: what `pulse_train` would err by.
#[test]
fn three_edges_are_too_few() {
    let deviation = 0.25;
    let mut worst = 0.0f64;
    for step in 0..1000 {
        let position = f64::from(step) / 1000.0;
        let above = |edge: f64| cumulative((position - edge) / deviation);
        let nearest = 0.5 * (2.0 * position).round();
        let sum = above(nearest - 0.5) - above(nearest) + above(nearest + 0.5);
        // Pulses of half a period begin at whole numbers: before such an edge and the one below it the pulse is on.
        let three = if nearest.fract() == 0.0 { 1.0 - sum } else { sum };
        worst = worst.max((three - Footprint::Gaussian(deviation).train(position, 0.5)).abs());
    }
    println!("three edges at a deviation of a quarter: off by {worst:.1e}");
    assert!((1e-3..2e-3).contains(&worst), "{worst}");
}

/// A box of the same variance is another filter: what it costs where the pixel's is a Gaussian.
#[test]
fn boxes_of_the_same_variance_differ() {
    let device = Device::new().unwrap();
    for deviation in [0.05, 0.2, 0.4] {
        let width = 12f64.sqrt() * deviation;
        let points = random(4000, 5, |next| [next.unit(), 0.5, width]);
        let gaussian = |point: &[f64]| Footprint::Gaussian(deviation).train(point[0], point[1]);
        let worst = most(&device, &shelf("pulse_train_box"), &points, gaussian);
        println!("deviation {deviation}: a box of the same variance differs by up to {worst:.3}");
        assert!((0.05..0.17).contains(&worst), "{worst}");
    }
}
