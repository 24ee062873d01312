//! The plane of `examples/data/colormaps.json`, seen up to its horizon: its pixels, what a function says there, and how
//! far colors are from the truth.

use prefilter::gpu::{Device, Kernel, Work};

/// Pixels a row, rows, and the distance of the first from the horizon.
const SIZE: [usize; 2] = [48, 36];
const FIRST: f64 = 2.5;
/// Distance of the picture from the eye, in pixels.
pub const FOCAL: f64 = 60.0;

/// Right of the middle and below the horizon.
pub fn pixels() -> impl Iterator<Item = [f64; 2]> {
    let middle = 0.5 * (SIZE[0] as f64 - 1.0);
    (0..SIZE[0] * SIZE[1]).map(move |at| [(at % SIZE[0]) as f64 - middle, (at / SIZE[0]) as f64 + FIRST])
}

/// The colors of a function `color(point: array<f32, 6>) -> vec3f` at lists of six numbers.
///
/// # Errors
/// What the device refuses.
pub fn colors(device: &Device, text: &str, points: &[f32]) -> Result<Vec<[f64; 3]>, prefilter::Error> {
    let entry = "
@group(0) @binding(0) var<storage, read_write> output: array<f32>;
@group(0) @binding(1) var<storage, read> points: array<array<f32, 6>>;
@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= arrayLength(&points) { return; }
    let color = color(points[id.x]);
    for (var channel = 0u; channel < 3u; channel++) { output[3u * id.x + channel] = color[channel]; }
}";
    let invocations = points.len() / 6;
    let kernel = Kernel::new(device, &format!("{entry}\n{text}"), "main")?;
    let work = Work { inputs: &[points], textures: &[], invocations, output: 3 * invocations };
    let colors = kernel.run(&work)?;
    Ok(colors.chunks_exact(3).map(|color| [0, 1, 2].map(|channel| f64::from(color[channel]))).collect())
}

/// The mean over pixels of the square of the largest difference of a channel.
///
/// # Panics
/// Where there are not as many of both, or a difference is no number.
pub fn square(found: &[[f64; 3]], truth: &[[f64; 3]]) -> f64 {
    assert_eq!(found.len(), truth.len());
    // Written so that NaN stays.
    let wider = |most: f64, part: f64| if part <= most { most } else { part };
    let largest =
        |(a, b): (&[f64; 3], &[f64; 3])| (0..3).map(|channel| (a[channel] - b[channel]).abs()).fold(0.0, wider);
    let sum: f64 = found.iter().zip(truth).map(|pair| largest(pair).powi(2)).sum();
    assert!(sum.is_finite());
    sum / truth.len() as f64
}
