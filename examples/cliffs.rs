//! How do I put snow where it is high and flat, and light it by a sky? Prints a module, and the light of elevations of
//! the eye.
//!
//! `cargo run --release --example cliffs --features gpu,joint`

use prefilter::gpu::{Address, Device, Kernel, Texture, Work};
use prefilter::{Irradiance, JointMap, Microsurface, Scene};

/// The host's side: a pixel knows the heights and slopes that it covers, and where the eye is.
const HOST: &str = "
@group(0) @binding(0) var<storage, read_write> results: array<vec4f>;
@group(0) @binding(1) var<storage, read> elevations: array<f32>;
@group(1) @binding(0) var a: texture_2d<f32>;
@group(1) @binding(1) var a_sampler: sampler;
@group(1) @binding(2) var b: texture_2d<f32>;
@group(1) @binding(3) var b_sampler: sampler;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= arrayLength(&elevations) {
        return;
    }
    // Heights in meters and slopes of the mountains in this pixel; its tangent frame is the world's.
    let slope_covariance = vec3f(0.2, 0.0, 0.2);
    let view = vec3f(cos(elevations[id.x]), 0.0, sin(elevations[id.x]));
    let x = vec3f(1.0, 0.0, 0.0);
    let y = vec3f(0.0, 1.0, 0.0);
    let z = vec3f(0.0, 0.0, 1.0);
    let mean_slope = vec2f();
    let light = alps_lit(1500.0, 400.0, mean_slope, slope_covariance, view, x, y, z, a, a_sampler, b, b_sampler);
    results[id.x] = vec4f(light / 3.14159265, 1.0);
}";

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // By height and by steepness, the length of the slope: rock, and snow from 1600 m on where it is flat enough.
    let color = |height: f32, steepness: f32| {
        let snow = ((height - 1500.0) / 100.0).clamp(0.0, 1.0) * ((0.7 - steepness) / 0.2).clamp(0.0, 1.0);
        [0.20, 0.15, 0.11].map(|rock| rock + snow * (0.9 - rock))
    };
    let map = JointMap::new([0.0, 1500.0, 1600.0, 3000.0], [0.0, 0.5, 0.7, 1.5], color)?;
    println!("one and two products leave {:?} of the map\n", &map.errors()[..2]);
    // Rows from the zenith to the nadir, columns around from +x: a bright west, +x, under a blue sky.
    let sky: Vec<[f32; 3]> = (0..64 * 32)
        .map(|texel| match (texel / 64, texel % 64) {
            (8..16, 0..4 | 60..64) => [9.0, 7.0, 4.0],
            (0..16, _) => [0.3, 0.5, 0.9],
            _ => [0.1, 0.1, 0.1],
        })
        .collect();
    let unshadowed = Microsurface { shadowing: false, ..Microsurface::default() };
    let scene = Scene::new("alps").combination(map.combination("snow", 2)?).microsurface(unshadowed);
    let module = scene.irradiance(Irradiance::from_equirectangular(64, 32, &sky)?).module()?;
    for export in module.exports() {
        println!("{}", export.signature);
    }
    println!("\n{}\n", module.explain());

    // The module behind the host's text, and its tables, on the device.
    let device = Device::new()?;
    let kernel = Kernel::new(&device, module.link(HOST)?.wgsl(), "main")?;
    let tables = module.tables().iter().map(|table| device.upload(table, Address::Clamp));
    let tables = tables.collect::<Result<Vec<Texture>, _>>()?;
    let degrees = [90.0f32, 60.0, 40.0, 20.0, 10.0, 5.0];
    let elevations = degrees.map(f32::to_radians);
    let results = kernel.run(&Work {
        inputs: &[&elevations],
        textures: &tables.iter().collect::<Vec<_>>(),
        invocations: elevations.len(),
        output: 4 * elevations.len(),
    })?;
    println!("elevation   light of what is seen from the west");
    for (degrees, light) in degrees.iter().zip(results.chunks_exact(4)) {
        println!("{degrees:>6}      {:.3}  {:.3}  {:.3}", light[0], light[1], light[2]);
    }
    Ok(())
}
