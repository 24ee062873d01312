//! Question 2: the shares of nodes on the device, from views and slopes to weights that sum to 1, whatever the input.

use prefilter::gpu::Device;
use prefilter::reference::slope_nodes::{bits, Along, Part, Transferred};
use spirv_tests::any;
use spirv_tests::kernel::Function;
use spirv_tests::random::Random;

type Outcome = Result<(), String>;

/// Points at a time.
const BATCH: usize = 100_000;

const CHAIN: &str = "
struct chain { shares: vec4f, lambda: f32 }
fn asked(view: vec3f, covariance: vec3f, mean_slope: vec2f, scales: vec4f, weights: vec4f, rates: vec4f,
    spreads: vec4f) -> chain {
    let factor = slopes_factor(view, covariance);
    let averted = slope_nodes_averted(view, mean_slope, factor, scales);
    let lambda = slope_nodes_lambda(view, mean_slope, scales, weights, averted);
    let bits = slope_nodes_bits(lambda, rates, spreads);
    return chain(slope_nodes_shares(view, mean_slope, scales, weights, averted, bits), lambda);
}";

fn run(points: &[Vec<f64>]) -> Result<Vec<Vec<f64>>, String> {
    let device = Device::new().map_err(|error| error.to_string())?;
    let results = Function::in_text(CHAIN, "asked")?.results(&device, &[], points)?;
    assert!(!points.is_empty() && results.len() == points.len());
    Ok(results)
}

fn single(values: impl IntoIterator<Item = f64>) -> Vec<f64> {
    values.into_iter().map(|value| f64::from(value as f32)).collect()
}

/// Four numbers from some.
fn four(random: &mut Random, mut number: impl FnMut(&mut Random) -> f64) -> Vec<f64> {
    single((0..4).map(|_| number(random)).collect::<Vec<_>>())
}

/// Nodes as tables have them, used or not, and worse.
fn any_point(random: &mut Random) -> Vec<f64> {
    let view = any::direction(random);
    let [x, y] = [0, 1].map(|_| random.pick([0.0, 1e-20, 0.3, 0.3, 1.0, 5.0, 1e6, 1e18]));
    let even = 2.0 * random.unit() - 1.0;
    let both = x * y * random.pick([0.0, 1.0, -1.0, even]);
    let slope = random.pick([0.0, 0.0, 0.5, 1e-20, 1e4, 1e15]);
    let slope = single([slope * (2.0 * random.unit() - 1.0), slope * (2.0 * random.unit() - 1.0)]);
    let scales = four(random, |random| {
        let usual = 4.0 * random.unit() - 2.0;
        random.pick([0.0, usual, usual, 1e-8, 6e4, -6e4])
    });
    let weights = four(random, |random| random.pick([0.0, 1.0, 0.3, 1e-7]));
    let rates = four(random, |random| random.pick([0.0, 1.0, 8.0, 6e4]));
    let spreads = four(random, |random| random.pick([0.0, 0.02, 1.0, 64.0, 6e4]));
    let covariance = single([x * x, both, y * y]);
    [&view[..], &covariance, &slope, &scales, &weights, &rates, &spreads].concat()
}

#[test]
fn shares_sum_to_one_whatever_the_input() -> Outcome {
    let mut random = Random::new(7);
    for _ in 0..any::inputs(400_000) / BATCH {
        let points: Vec<Vec<f64>> = (0..BATCH).map(|_| any_point(&mut random)).collect();
        let mut hidden = 0;
        for (point, got) in points.iter().zip(run(&points)?) {
            assert!(got.iter().all(|value| value.is_finite()), "{point:?}: {got:?}");
            let sum: f64 = got[..4].iter().sum();
            let used = point[12..16].iter().any(|weight| *weight > 0.0);
            assert!((sum - f64::from(u8::from(used))).abs() < 1e-5, "{point:?}: {got:?}");
            assert!(got.iter().all(|value| *value >= 0.0), "{point:?}: {got:?}");
            // What is not used is not seen.
            assert!((0..4).all(|node| point[12 + node] > 0.0 || got[node] == 0.0), "{point:?}: {got:?}");
            hidden += usize::from(got[4] > 1e6);
        }
        assert!(hidden > BATCH / 10 && hidden < 9 * BATCH / 10, "{hidden}");
    }
    Ok(())
}

/// A view in the plane of x, of slopes of a round covariance: shares and Λ against those of the parts of a surface.
#[test]
fn the_chain_is_that_of_the_reference() -> Outcome {
    let mut random = Random::new(3);
    let mut cases = Vec::new();
    for _ in 0..20_000 {
        let (angle, mean) = (random.between(0.01, 1.5), random.pick([0.0, 0.3, -0.3]));
        let deviation = random.between(0.05, 1.5);
        let scales = four(&mut random, |random| 2.0 * random.unit());
        let weights = four(&mut random, |random| random.between(0.05, 1.0));
        let rates = four(&mut random, |random| 3.0 * random.unit());
        let spreads = four(&mut random, |random| random.between(0.02, 8.0));
        let view = [angle.sin(), 0.0, angle.cos()];
        let round = [deviation * deviation, 0.0, deviation * deviation];
        let point = [single(view), single(round), single([mean, 0.0]), scales, weights, rates, spreads].concat();
        cases.push((Along { angle: point[0].atan2(point[2]), mean: point[6], deviation: point[3].sqrt() }, point));
    }
    let points: Vec<Vec<f64>> = cases.iter().map(|case| case.1.clone()).collect();
    let (mut worst, mut judged) = ([0.0f64; 2], 0);
    for ((along, point), got) in cases.iter().zip(run(&points)?) {
        let whole: f64 = point[12..16].iter().sum();
        let part =
            |node: usize| Part { value: 0.0, share: point[12 + node] / whole, height: 0.0, scale: point[8 + node] };
        let surface = Transferred { parts: (0..4).map(part).collect() };
        let lambda = surface.lambda(*along);
        // Above the horizon of the mean surface by a tenth.
        if surface.average(|part| along.rise_and_reach(part.scale).0) < 0.1 {
            continue;
        }
        judged += 1;
        let areas = surface.shares(*along, 0.0, 0.0).into_iter().enumerate();
        let seen = areas.map(|(node, area)| area * (-bits(lambda, point[16 + node], point[20 + node])).exp2());
        let seen: Vec<f64> = seen.collect();
        let sum: f64 = seen.iter().sum();
        worst[0] = worst[0].max((got[4] - lambda).abs() / (1.0 + lambda));
        for (got, seen) in got.iter().zip(&seen) {
            let error = (got - seen / sum).abs();
            worst[1] = worst[1].max(if error.is_nan() { f64::INFINITY } else { error });
        }
    }
    println!("Λ within {:.1e} of 1 + Λ, shares within {:.1e}, of {judged}", worst[0], worst[1]);
    assert!(judged > 10_000 && worst[0] < 1e-6 && worst[1] < 6e-6, "{worst:?}");
    Ok(())
}
