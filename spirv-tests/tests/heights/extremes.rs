//! Finite results for any input: random bit patterns, which are huge, tiny, denormal, infinite and of both signs.

use spirv_tests::kernel::Function;

use prefilter::gpu::Device;

const COUNT: usize = 1_000_000;

/// Random bits from a seed.
fn random(seed: u64) -> impl FnMut() -> u32 {
    let mut state = seed;
    move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 32) as u32
    }
}

/// Any number of 32 bits but NaN; one of five is an ordinary one, one of 40 infinite, zero or the smallest.
fn any(next: &mut impl FnMut() -> u32) -> f64 {
    let kind = next() % 40;
    let value = match kind {
        0 => [0.0, -0.0, f32::INFINITY, f32::NEG_INFINITY, f32::MAX, f32::MIN, 1e-45, -1e-45][next() as usize % 8],
        1..=8 => 16.0 * (next() as f32 / u32::MAX as f32) - 8.0,
        _ => f32::from_bits(next()),
    };
    if value.is_nan() {
        0.5
    } else {
        f64::from(value)
    }
}

#[test]
fn every_result_is_finite() -> Result<(), String> {
    let device = Device::new().map_err(|error| error.to_string())?;
    let functions = Function::shelf()?;
    let ours = functions
        .iter()
        .filter(|function| function.path == "visibility/heights.wgsl" || function.name == "normal_surprisal");
    let mut count = 0;
    for (seed, function) in (1..).zip(ours) {
        let mut next = random(seed);
        let inputs = function.signature.inputs().len();
        let points: Vec<Vec<f64>> = (0..COUNT).map(|_| (0..inputs).map(|_| any(&mut next)).collect()).collect();
        let results = function.results(&device, &[], &points)?;
        assert_eq!(results.len(), COUNT);
        for (point, result) in points.iter().zip(&results) {
            assert!(result.iter().all(|value| value.is_finite()), "{}: {point:?} gives {result:?}", function.name);
        }
        count += 1;
    }
    assert_eq!(count, 8);
    Ok(())
}
