//! What mean and variance cost beside the same octaves of noise without them: timed and counted.

use prefilter::gpu::{Device, Dispatch, Kernel, Work};
use prefilter::{ColorMap, Driver, Module, Noise, NoiseMethod, Scene};

use crate::plane::Plane;
use crate::{Found, Outcome};

/// The same octaves, as one writes them without a filter; `gradient` also returns the gradient.
const PLAIN: &str = "fn plain(position: vec2f) -> vec4f {
    let step = mat2x2f(STEP);
    var at = position;
    var sum = 0.0;
    var amplitude = 1.0;
    for (var octave = 0u; octave < 6u; octave++) {
        sum += amplitude * perlin_noise(at, vec2f(), octave).x;
        amplitude *= 0.5;
        at = step * at + vec2f(0.618033989, 0.414213562);
    }
    return vec4f(0.5 + 0.72274363 * sum);
}
fn gradient(position: vec2f) -> vec4f {
    let step = mat2x2f(STEP);
    var at = position;
    var sum = vec3f();
    var amplitude = 1.0;
    var frame = mat2x2f(1.0, 0.0, 0.0, 1.0);
    for (var octave = 0u; octave < 6u; octave++) {
        let n = perlin_noise(at, vec2f(), octave);
        sum += amplitude * vec3f(n.x, n.yz * frame);
        amplitude *= 0.5;
        at = step * at + vec2f(0.618033989, 0.414213562);
        frame = step * frame;
    }
    return vec4f(0.72274363 * sum, 0.0);
}";

/// Turned by half a radian and twice as fine.
const STEP: &str = "1.7551651, 0.9588511, -0.9588511, 1.7551651";

fn kernel(device: &Device, module: &Module, call: &str) -> Result<Kernel, prefilter::Error> {
    let entry = format!(
        "
@group(0) @binding(0) var<storage, read_write> output: array<vec4f>;
@group(0) @binding(1) var<storage, read> points: array<array<f32, 6>>;
@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {{
    if id.x >= arrayLength(&points) {{ return; }}
    let p = points[id.x];
    output[id.x] = {call};
}}
{}",
        PLAIN.replace("STEP", STEP)
    );
    Kernel::new(device, module.link(&entry)?.wgsl(), "main")
}

/// The least of the times of each, interleaved.
fn fastest(all: &[Dispatch]) -> Result<Vec<f64>, prefilter::Error> {
    let mut least = vec![f64::INFINITY; all.len()];
    for round in 0..41 {
        for turn in 0..all.len() {
            let which = (turn + round) % all.len();
            least[which] = least[which].min(all[which].time()?);
        }
    }
    Ok(least)
}

#[test]
fn statistics_cost_little_beside_the_noise() -> Outcome {
    // Mesa's software rasterizer takes its number of threads from here when a device is made.
    std::env::set_var("LP_NUM_THREADS", "1");
    let device = Device::new()?;
    let module = |method| {
        let map = ColorMap::gradient([(0.0, [0.0; 3]), (1.0, [1.0; 3])])?;
        Scene::new("rock").texture(map).driver(Driver::Noise(Noise { method, ..Noise::default() })).module()
    };
    let (ours, paper) = (module(NoiseMethod::Gradient)?, module(NoiseMethod::Stationary)?);
    let bent = module(NoiseMethod::Curvature)?;
    let statistics = "rock_statistics(vec2f(p[0], p[1]), 0.5 * vec2f(p[2], p[3]), 0.5 * vec2f(p[4], p[5]))";
    let run = |module: &Module, call: &str| kernel(&device, module, call);
    let kernels = [
        run(&ours, "plain(vec2f(p[0], p[1]))")?,
        run(&ours, "gradient(vec2f(p[0], p[1]))")?,
        run(&ours, statistics)?,
        run(&paper, statistics)?,
        run(&bent, statistics)?,
    ];
    let even = |size: f32| -> Vec<f32> {
        let place = |at: usize| [(at % 128) as f32 * 0.17, (at / 128) as f32 * 0.17];
        (0..16_384).flat_map(|at| [place(at)[0], place(at)[1], size, 0.3 * size, -0.2 * size, 0.7 * size]).collect()
    };
    let plane: Vec<f32> = (0..8).flat_map(|seed| Plane::new(seed).points()).collect();
    for (name, points) in [("points", even(1e-4)), ("0.05 cells", even(0.1)), ("plane", plane)] {
        let invocations = points.len() / 6;
        let work = Work { inputs: &[&points], textures: &[], invocations, output: 4 * invocations };
        let all = kernels.iter().map(|kernel| kernel.prepare(&work)).collect::<Result<Vec<_>, _>>()?;
        let times = fastest(&all)?;
        println!(
            "{name}: {:.0} ns; of the value {:.3}, of value and gradient {:.3}, of the paper's {:.3}; by the curvature \
             {:.3} of the value, {:.3} of ours",
            1e9 * times[2] / invocations as f64,
            times[2] / times[0],
            times[2] / times[1],
            times[2] / times[3],
            times[4] / times[0],
            times[4] / times[2]
        );
        // The whole plane is asked for; where every pixel resolves something of every octave none is left out.
        let most = if name == "plane" { 1.35 } else { 1.5 };
        assert!(times[2] / times[0] < most, "{name}: {:.3}", times[2] / times[0]);
        // By the curvature it is said to take 1.25 times as long.
        assert!(times[4] / times[2] < 1.4, "{name}: {:.3}", times[4] / times[2]);
    }
    let cost = |module: &Module, name: &str| -> Found<usize> {
        let shader = module.link(&PLAIN.replace("STEP", STEP))?;
        Ok(shader.cost(name).map(|cost| cost.operations).ok_or("no such function")?)
    };
    for name in ["perlin_noise", "perlin_filter", "fractal_add"] {
        println!("{name}: {} operations", cost(&ours, name)?);
    }
    Ok(())
}
