//! Finite results for any input: random bit patterns, which are huge, tiny, denormal, infinite and of both signs.

use prefilter::gpu::Device;
use spirv_tests::kernel::Function;
use spirv_tests::random::Random;

const COUNT: usize = 1_000_000;

/// Any number of 32 bits but NaN; one of five is an ordinary one, one of 40 infinite, zero or the smallest.
fn any(random: &mut Random) -> f64 {
    let kind = random.word() % 40;
    let value = match kind {
        0 => {
            [0.0, -0.0, f32::INFINITY, f32::NEG_INFINITY, f32::MAX, f32::MIN, 1e-45, -1e-45][random.word() as usize % 8]
        }
        1..=8 => 16.0 * random.unit() as f32 - 8.0,
        _ => f32::from_bits(random.word()),
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
        let mut random = Random::new(seed);
        let inputs = function.signature.inputs().len();
        let points: Vec<Vec<f64>> = (0..COUNT).map(|_| (0..inputs).map(|_| any(&mut random)).collect()).collect();
        let results = function.results(&device, &[], &points)?;
        assert_eq!(results.len(), COUNT);
        for (point, result) in points.iter().zip(&results) {
            assert!(result.iter().all(|value| value.is_finite()), "{}: {point:?} gives {result:?}", function.name);
        }
        count += 1;
    }
    assert_eq!(count, 7);
    Ok(())
}
