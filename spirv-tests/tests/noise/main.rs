//! Procedural noise on the device: its statistics, its periods, its seeds and its gradient.

mod cost;
mod curvature;
mod driver;
mod figures;
mod folds;
mod footprints;
mod noises;
mod periods;
mod plane;
mod quotients;
mod slope_figures;
mod slopes;
mod solid;
mod warp;

use prefilter::gpu::Device;
use prefilter::{Noise, NoiseBasis};
use spirv_tests::kernel::Function;

type Found<T> = Result<T, Box<dyn std::error::Error + Send + Sync>>;
type Outcome = Found<()>;

/// The results of a function of the shelf at lists of numbers.
fn at(device: &Device, name: &str, points: &[Vec<f64>]) -> Found<Vec<Vec<f64>>> {
    let shelf = Function::shelf()?;
    let function = shelf.iter().find(|function| function.name == name).ok_or("no such function")?;
    Ok(function.results(device, &[], points)?)
}

/// A function `truth_noise(position: vec2f) -> f32`: the driver's noise by its definition, without a footprint.
fn octaves(noise: &Noise) -> String {
    // The variances of the definitions, which a test here finds again.
    let (name, variance) = match noise.basis {
        NoiseBasis::Perlin => ("perlin", 181.0 / 231.0 * 535.0 / 9009.0),
        NoiseBasis::Value => ("value", (181f64 / 231.0).powi(2) / 3.0),
        NoiseBasis::Simplex => ("simplex", 4900.0 * 3f64.sqrt() * std::f64::consts::PI / 184_320.0),
        NoiseBasis::PerlinSolid | NoiseBasis::ValueSolid => panic!("a noise of the plane"),
    };
    let gain = f64::from(noise.gain);
    let power: f64 = (0..noise.octaves).map(|octave| gain.powi(2 * octave as i32)).sum();
    let scale = f64::from(noise.deviation) / (power * variance).sqrt();
    let tile = if noise.basis == NoiseBasis::Simplex { "" } else { ", tile" };
    format!(
        "fn truth_noise(position: vec2f) -> f32 {{
    var at = position;
    var sum = {mean:?};
    var tile = vec2f({period:?});
    for (var octave = 0u; octave < {count}u; octave++) {{
        sum += {scale:?} * pow({gain:?}, f32(octave)) * {name}_noise(at{tile}, {seed}u + octave).x;
        let turned = vec2f(cos({turn:?}) * at.x - sin({turn:?}) * at.y, sin({turn:?}) * at.x + cos({turn:?}) * at.y);
        at = {lacunarity:?} * turned + vec2f(0.618033989, 0.414213562);
        tile *= {lacunarity:?};
    }}
    return sum;
}}",
        mean = noise.mean,
        period = noise.period as f32,
        count = noise.octaves,
        seed = noise.seed.wrapping_mul(0x9e37_79b1),
        turn = noise.rotation,
        lacunarity = noise.lacunarity,
    )
}
