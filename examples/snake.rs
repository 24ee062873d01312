//! How do I blend a texture with a color by slope? Prints a module, and what it says of a body that turns about.
//!
//! `cargo run --release --example snake --features gpu`

use prefilter::gpu::{Address, Device, Kernel, Texture, Work};
use prefilter::{ColorMap, Irradiance, Scene};

/// The host's side: a pixel knows the values and the slopes that it covers, where the eye is, and how the body lies.
const HOST: &str = "
@group(0) @binding(0) var<storage, read_write> results: array<vec4f>;
@group(0) @binding(1) var<storage, read> azimuths: array<f32>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= arrayLength(&azimuths) {
        return;
    }
    // The pattern's values in this pixel: mean and deviation; slopes of scales along the body and around it: variances
    // and covariance, from a displacement map by `slope_moments_read`.
    let mean = 0.5;
    let deviation = 0.15;
    let slope_covariance = vec3f(0.16, 0.0, 0.16);
    // The frame: along the body, around it, and up. The eye is 25 degrees above the ground.
    let x = vec3f(cos(azimuths[id.x]), sin(azimuths[id.x]), 0.0);
    let y = vec3f(-x.y, x.x, 0.0);
    let z = vec3f(0.0, 0.0, 1.0);
    let eye = vec3f(0.906, 0.0, 0.423);
    let view = vec3f(dot(eye, x), dot(eye, y), eye.z);
    let tail = vec2f(1.0, 0.0); // what rises to the head faces the tail
    let color = snake_combined(mean, deviation, vec2f(), slope_covariance, view, tail);
    let lit = snake_lit(mean, deviation, vec2f(), slope_covariance, view, tail, x, y, z);
    results[2u * id.x] = vec4f(color, 1.0);
    results[2u * id.x + 1u] = vec4f(lit, 1.0);
}";

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // Two layers of slopes and one of values: green where scales are bare, red where they face the tail.
    let green = ColorMap::bands([0.02, 0.08, 0.02], [(0.4, [0.15, 0.35, 0.05]), (0.65, [0.65, 0.7, 0.2])])?;
    let bare = ColorMap::gradient([(0.05, [1.0; 3]), (0.2, [0.0; 3])])?;
    let red = ColorMap::gradient([(0.05, [0.0; 3]), (0.2, [0.7, 0.08, 0.02])])?;
    let [bare, red] = [("bare", bare), ("red", red)].map(|(name, map)| Scene::new(name).slope(map));
    let layers = Scene::new("green").texture(green) * &bare + &red;
    // A bright side of the sky.
    let sky: Vec<[f32; 3]> =
        (0..32 * 16).map(|texel| if texel % 32 < 8 { [3.0; 3] } else { [0.3, 0.4, 0.6] }).collect();
    let sky = Irradiance::from_equirectangular(32, 16, &sky)?;
    let module = Scene::new("snake").combination(layers).irradiance(sky).module()?;
    for export in module.exports() {
        println!("{}", export.signature);
    }
    println!("\n{}\n", module.explain());

    // The module behind the host's text, on the device.
    let device = Device::new()?;
    let kernel = Kernel::new(&device, module.link(HOST)?.wgsl(), "main")?;
    let tables = module.tables().iter().map(|table| device.upload(table, Address::Clamp));
    let tables = tables.collect::<Result<Vec<Texture>, _>>()?;
    let degrees = [0.0f32, 45.0, 90.0, 135.0, 180.0, 225.0, 270.0, 315.0];
    let results = kernel.run(&Work {
        inputs: &[&degrees.map(f32::to_radians)],
        textures: &tables.iter().collect::<Vec<_>>(),
        invocations: degrees.len(),
        output: 8 * degrees.len(),
    })?;
    println!("the head is turned from the eye by, the color, and that times irradiance:");
    for (degrees, result) in degrees.iter().zip(results.chunks_exact(8)) {
        let [r, g, b, _, x, y, z, _] = result else { continue };
        println!("{degrees:>3} degrees    {r:.3}  {g:.3}  {b:.3}    {x:.3}  {y:.3}  {z:.3}");
    }
    Ok(())
}
