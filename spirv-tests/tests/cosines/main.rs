//! Sums of cosines: what they lose over a footprint against all pairs of waves, and the colors of a plane of waves.

mod moments;
mod plane;

use prefilter::driver::cosines::Wave;
use spirv_tests::random::Random;

type Outcome = Result<(), Box<dyn std::error::Error + Send + Sync>>;

/// Waves of all directions, evenly spaced in the logarithm of their frequency from `shortest` on, of equal steepness
/// and `deviation` together.
fn waves(count: usize, shortest: f64, range: f64, deviation: f64, seed: u32) -> Vec<Wave> {
    let mut next = Random::new(seed);
    let turn = |part: f64| part * std::f64::consts::TAU;
    let made: Vec<[f64; 4]> = (0..count)
        .map(|at| {
            let frequency = shortest * range.powf((at as f64 + next.unit()) / count as f64);
            let (sin, cos) = turn(next.unit()).sin_cos();
            [frequency * cos, frequency * sin, 1.0 / frequency, next.unit()]
        })
        .collect();
    let square: f64 = made.iter().map(|wave| 0.5 * wave[2] * wave[2]).sum();
    let scale = deviation / square.sqrt();
    let wave = |[x, y, amplitude, phase]: [f64; 4]| Wave {
        frequency: [x as f32, y as f32],
        amplitude: (scale * amplitude) as f32,
        phase: phase as f32,
    };
    made.into_iter().map(wave).collect()
}
