//! How do I color a rough surface by its height? Prints a module, and what it says of elevations of the eye.
//!
//! `cargo run --release --example rough --features gpu`

use prefilter::gpu::{Device, Kernel, Work};
use prefilter::{ColorMap, Microsurface, Scene};

/// The host's side: a pixel knows the heights and slopes that it covers, where the eye is, and where the sun.
const HOST: &str = "
@group(0) @binding(0) var<storage, read_write> results: array<vec4f>;
@group(0) @binding(1) var<storage, read> elevations: array<f32>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= arrayLength(&elevations) {
        return;
    }
    // Heights and slopes of the moss in this pixel: mean and deviation, variances along x and y and their covariance.
    let mean = 0.0;
    let deviation = 1.0;
    let slope_covariance = vec3f(0.36, 0.0, 0.36);
    let view = vec3f(cos(elevations[id.x]), 0.0, sin(elevations[id.x]));
    let sun = vec3f(0.0, 0.94, 0.342); // 20 degrees above the horizon, from the side
    let color = moss_height(mean, deviation, slope_covariance, view, sun);
    results[id.x] = vec4f(color, moss_visibility(slope_covariance, view, sun));
}";

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // Positions are heights, here in deviations of them: wet moss in the valleys, lichen on the tops.
    let map = ColorMap::gradient([
        (-2.0, [0.01, 0.03, 0.03]),
        (0.0, [0.15, 0.23, 0.04]),
        (0.0, [0.26, 0.17, 0.10]), // the same position twice: a hard edge
        (2.0, [0.96, 0.95, 0.90]),
    ])?;
    let microsurface = Microsurface { hotspot: true, ..Microsurface::default() };
    let module = Scene::new("moss").height(map).microsurface(microsurface).module()?;
    for export in module.exports() {
        println!("{}", export.signature);
    }
    println!("\n{}\n", module.explain());

    // The module behind the host's text, on the device.
    let device = Device::new()?;
    let kernel = Kernel::new(&device, module.link(HOST)?.wgsl(), "main")?;
    let degrees = [90.0f32, 60.0, 40.0, 20.0, 10.0, 5.0, 2.0, 1.0];
    let elevations = degrees.map(f32::to_radians);
    let results = kernel.run(&Work {
        inputs: &[&elevations],
        textures: &[],
        invocations: elevations.len(),
        output: 4 * elevations.len(),
    })?;
    println!("elevation   color of what is seen and lit   share of it that is lit");
    for (degrees, result) in degrees.iter().zip(results.chunks_exact(4)) {
        println!("{degrees:>6}      {:.3}  {:.3}  {:.3}             {:.3}", result[0], result[1], result[2], result[3]);
    }
    Ok(())
}
