//! Solid Gabor noise: its kernels against their integrals, its variances against samples, edges of solids, a plane to
//! the horizon, and what filtering costs.

mod cost;
mod edge;
mod kernels;
mod limits;
mod plane;
mod references;
mod samples;
mod settings;
mod statistics;

use prefilter::gpu::{Device, Kernel};
use prefilter::{ColorMap, Driver, Gabor, Module, Scene, Spectrum};
use spirv_tests::exports::ExportKernel;
use spirv_tests::random::Random;

type Outcome = Result<(), Box<dyn std::error::Error + Send + Sync>>;
type Found<T> = Result<T, Box<dyn std::error::Error + Send + Sync>>;

/// The side of a cell for a bandwidth of 1.
const CELL: f64 = 0.8;

/// Noise in its own units: mean 0, deviation 1, bandwidth 1.
fn noise(spectrum: Spectrum) -> Gabor {
    Gabor { spectrum, mean: 0.0, deviation: 1.0, ..Gabor::default() }
}

/// One of each kind, of a bandwidth and a frequency at which both matter.
fn spectra() -> [(&'static str, Spectrum); 4] {
    [
        ("anisotropic", Spectrum::Anisotropic { frequency: [0.9, -0.5, 0.7] }),
        ("isotropic", Spectrum::Isotropic { frequency: 1.3 }),
        ("flat", Spectrum::Hybrid { frequency: (1.3, 1.3), azimuth: (0.0, std::f32::consts::TAU), height: (0.0, 0.0) }),
        ("hybrid", Spectrum::Hybrid { frequency: (0.6, 1.8), azimuth: (0.2, 2.0), height: (-0.7, 0.4) }),
    ]
}

fn module(gabor: Gabor) -> Found<Module> {
    let map = ColorMap::gradient([(0.0, [0.0; 3]), (1.0, [1.0; 3])])?;
    Ok(Scene::new("wood").texture(map).driver(Driver::Gabor(gabor)).module()?)
}

/// Mean and variance over footprints, each of a position and two vectors.
fn statistics(device: &Device, module: &Module, footprints: &[[[f64; 3]; 3]]) -> Found<Vec<[f64; 2]>> {
    let export = module.exports().iter().find(|export| export.name.ends_with("_statistics")).ok_or("no statistics")?;
    let numbers: Vec<f32> = footprints.iter().flatten().flatten().map(|&number| number as f32).collect();
    let found = ExportKernel::new(device, module, export)?.run(&numbers)?;
    Ok(found.iter().map(|found| [found[0], found[1]].map(f64::from)).collect())
}

/// A kernel that calls a function of a text of our own, linked with the module, once for every `width` numbers; `call`
/// has `{}` for a list of them and gives a vec4f.
fn kernel(device: &Device, module: &Module, text: &str, call: &str, width: usize) -> Found<Kernel> {
    let arguments: Vec<String> = (0..width).map(|at| format!("numbers[{width}u * index + {at}u]")).collect();
    let called = (0..width / 3).fold(call.to_owned(), |call, vector| {
        call.replace(&format!("{{{vector}}}"), &format!("vec3f({})", arguments[3 * vector..][..3].join(", ")))
    });
    let entry = format!(
        "{text}
@group(0) @binding(0) var<storage, read_write> results: array<vec4f>;
@group(0) @binding(1) var<storage, read> numbers: array<f32>;
@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u, @builtin(num_workgroups) groups: vec3u) {{
    let index = id.x + id.y * groups.x * 64u;
    if index < arrayLength(&results) {{
        results[index] = {called};
    }}
}}"
    );
    Ok(Kernel::new(device, module.link(&entry)?.wgsl(), "main")?)
}

/// A standard normal number.
fn normal(random: &mut Random) -> f64 {
    let length = (-2.0 * (1.0 - random.unit()).ln()).sqrt();
    length * (std::f64::consts::TAU * random.unit()).cos()
}

/// A position within ±`reach`.
fn place(random: &mut Random, reach: f64) -> [f64; 3] {
    [0, 1, 2].map(|_| reach * (2.0 * random.unit() - 1.0))
}

/// Two vectors at right angles in a random plane, of these lengths.
fn plane(random: &mut Random, [long, short]: [f64; 2]) -> [[f64; 3]; 2] {
    let unit = |random: &mut Random| {
        let vector = [0, 1, 2].map(|_| normal(random));
        let length = vector.iter().map(|part| part * part).sum::<f64>().sqrt();
        vector.map(|part| part / length)
    };
    let (a, b) = (unit(random), unit(random));
    let along: f64 = (0..3).map(|axis| a[axis] * b[axis]).sum();
    let rest = [0, 1, 2].map(|axis| b[axis] - along * a[axis]);
    let length = rest.iter().map(|part| part * part).sum::<f64>().sqrt();
    [a.map(|part| long * part), rest.map(|part| short * part / length)]
}

/// A position moved by normal numbers along two vectors.
fn moved(random: &mut Random, at: [f64; 3], [across, along]: [[f64; 3]; 2]) -> [f64; 3] {
    let (u, v) = (normal(random), normal(random));
    [0, 1, 2].map(|axis| at[axis] + u * across[axis] + v * along[axis])
}

/// Root of the mean of squares.
fn rms(values: impl ExactSizeIterator<Item = f64>) -> f64 {
    let count = values.len() as f64;
    (values.map(|value| value * value).sum::<f64>() / count).sqrt()
}
