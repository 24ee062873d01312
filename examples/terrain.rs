//! How do I get the first filtered picture? Colors a terrain that reaches to the horizon, on the device, into a PNG.
//!
//! `cargo run --release --example terrain --features gpu [-- FILE.png]`

use prefilter::gpu::{Address, Device, Kernel, Work};
use prefilter::table::Format;
use prefilter::transfer::srgb::from_linear;
use prefilter::{ColorMap, Driver, Edge, MomentMipmap, Moments, Scene, Taps};

const WIDTH: usize = 640;
const HEIGHT: usize = 360;

/// The host's side: where each pixel looks, how that changes from pixel to pixel, and one call.
const HOST: &str = "
@group(0) @binding(0) var<storage, read_write> colors: array<vec4f>;
@group(1) @binding(0) var moments: texture_2d<f32>;
@group(1) @binding(1) var moments_sampler: sampler;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u, @builtin(num_workgroups) groups: vec3u) {
    let index = id.x + id.y * groups.x * 64u;
    if index >= arrayLength(&colors) {
        return;
    }
    // Right of the middle and below the horizon; the ground is a plane below the camera, the texture lies turned on it.
    let pixel = vec2f(f32(index % 640u) - 319.5, f32(index / 640u) + 2.5);
    let turn = mat2x2f(0.56, 0.34, -0.4, 0.48);
    let ground = turn * vec2f(pixel.x, 800.0) / pixel.y;
    let dpdx = turn[0] / pixel.y;
    let dpdy = -ground / pixel.y;
    colors[index] = vec4f(terrain_color(vec2f(0.9, 0.7) + ground, dpdx, dpdy, moments, moments_sampler), 1.0);
}";

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let path = std::env::args().nth(1).unwrap_or_else(|| "target/terrain.png".into());

    // Elevations in meters, and the moments of every part of them.
    let image = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/data/jacksboro_dem.png");
    let elevations = image::open(image)?.into_luma16();
    let meters: Vec<f32> = elevations.pixels().map(|pixel| f32::from(pixel.0[0])).collect();
    let moments = MomentMipmap::new(elevations.width(), elevations.height(), &meters, Edge::Clamp)?;

    // What color each height has: sRGB, as one picks it.
    let map = ColorMap::gradient_srgb([
        (236.0, [0.20, 0.36, 0.24]),
        (330.0, [0.38, 0.53, 0.27]),
        (480.0, [0.80, 0.74, 0.49]),
        (700.0, [0.52, 0.38, 0.29]),
        (900.0, [0.60, 0.57, 0.55]),
        (900.0, [0.96, 0.97, 0.98]), // the same position twice: a hard edge, the snow line
    ])?;
    let driver = Driver::Moments(Moments { taps: Taps::Eight, ..Moments::default() });
    let module = Scene::new("terrain").texture(map).ranges(moments.ranges()).driver(driver).module()?;
    println!("{}", module.explain());

    // The module behind the host's text, on the device.
    let device = Device::new()?;
    let kernel = Kernel::new(&device, module.link(HOST)?.wgsl(), "main")?;
    let moments = device.upload(&moments.table("moments", Format::Rg32Float)?, Address::Mirror)?;
    let pixels = WIDTH * HEIGHT;
    let work = Work { inputs: &[], textures: &[&moments], invocations: pixels, output: 4 * pixels };
    let colors = kernel.run(&work)?;

    let encode = |linear: f32| (255.0 * from_linear(linear.clamp(0.0, 1.0)) + 0.5) as u8;
    let bytes: Vec<u8> =
        colors.chunks_exact(4).flat_map(|color| [0, 1, 2].map(|channel| encode(color[channel]))).collect();
    image::save_buffer(&path, &bytes, WIDTH as u32, HEIGHT as u32, image::ColorType::Rgb8)?;
    println!("{path}, filtered on {}", device.label());
    Ok(())
}
