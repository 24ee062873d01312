//! How does a surface look whose heights a curve makes of noise? Colors moss up to the horizon, on the device, into a
//! PNG: its cushions hide the dark ground between them, the more the flatter one looks.
//!
//! `cargo run --release --example moss --features gpu [-- FILE.png]`

use prefilter::gpu::{Address, Device, Kernel, Texture, Work};
use prefilter::transfer::srgb::from_linear;
use prefilter::{ColorMap, Cosines, Driver, HeightTransfer, Scene, Taps, Wave};

const WIDTH: usize = 640;
const HEIGHT: usize = 300;

/// The host's side: where each pixel looks, how that changes from pixel to pixel, and one call.
const HOST: &str = "
@group(0) @binding(0) var<storage, read_write> colors: array<vec4f>;
@group(1) @binding(0) var table: texture_3d<f32>;
@group(1) @binding(1) var table_sampler: sampler;
@group(1) @binding(2) var nodes: texture_2d<f32>;
@group(1) @binding(3) var nodes_sampler: sampler;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u, @builtin(num_workgroups) groups: vec3u) {
    let index = id.x + id.y * groups.x * 64u;
    if index >= arrayLength(&colors) {
        return;
    }
    // Right of the middle and below the horizon; a plane two units below the eye.
    let pixel = vec2f(f32(index % 640u) - 319.5, f32(index / 640u) + 1.5);
    let ground = 2.0 * vec2f(pixel.x, 400.0) / pixel.y;
    let dpdx = vec2f(2.0, 0.0) / pixel.y;
    let dpdy = -ground / pixel.y;
    let view = normalize(vec3f(-ground, 2.0));
    let sun = normalize(vec3f(-0.5, -0.3, 0.6));
    colors[index] = vec4f(moss_color(ground, dpdx, dpdy, view, sun, table, table_sampler, nodes, nodes_sampler), 1.0);
}";

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let path = std::env::args().nth(1).unwrap_or_else(|| "target/moss.png".into());

    // Waves of about one length in all directions, of variance 1 together.
    let wave = |number: u8| {
        let (turn, length) = (2.4 * f32::from(number), 0.8 + 0.015 * f32::from(number));
        let frequency = [turn.cos() / length, turn.sin() / length];
        Wave { frequency, amplitude: (2.0f32 / 32.0).sqrt(), phase: (0.618 * f32::from(number)).fract() }
    };
    let waves = (0..32).map(wave).collect();

    // Cushions a quarter of a unit high where the noise is above 0, and the colors of heights.
    let cushions = HeightTransfer::smoothstep(0.0, 1.2)?.scaled(0.25, 0.0)?.over((-3.0, 3.0), 1.0);
    let map = ColorMap::gradient([
        (0.00, [0.05, 0.03, 0.02]),
        (0.03, [0.05, 0.03, 0.02]),
        (0.03, [0.03, 0.08, 0.01]), // the same position twice: a hard edge
        (0.25, [0.60, 0.65, 0.20]),
    ])?;
    let driver = Driver::Cosines(Cosines { waves, taps: Taps::Four, ..Cosines::default() });
    let module = Scene::new("moss").height(map).transfer(cushions).driver(driver).module()?;
    println!("{}", module.explain());

    // The module behind the host's text, on the device.
    let device = Device::new()?;
    let kernel = Kernel::new(&device, module.link(HOST)?.wgsl(), "main")?;
    let tables = module.tables().iter().map(|table| device.upload(table, Address::Clamp));
    let tables = tables.collect::<Result<Vec<Texture>, _>>()?;
    let pixels = WIDTH * HEIGHT;
    let textures: Vec<&Texture> = tables.iter().collect();
    let work = Work { inputs: &[], textures: &textures, invocations: pixels, output: 4 * pixels };
    let colors = kernel.run(&work)?;

    let encode = |linear: f32| (255.0 * from_linear(linear.clamp(0.0, 1.0)) + 0.5) as u8;
    let colors = colors.chunks_exact(4).flat_map(|color| [0, 1, 2].map(|channel| encode(color[channel])));
    let bytes: Vec<u8> = colors.collect();
    image::save_buffer(&path, &bytes, WIDTH as u32, HEIGHT as u32, image::ColorType::Rgb8)?;
    println!("{path}, filtered on {}", device.label());
    Ok(())
}
