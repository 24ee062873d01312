//! How do I color solids by noise that does not shimmer? Carves blocks, near and far, from one stone into a PNG.
//!
//! `cargo run --release --example noise --features gpu [-- FILE.png]`

use prefilter::gpu::{Device, Kernel, Work};
use prefilter::transfer::srgb::from_linear;
use prefilter::{ColorMap, Driver, Gabor, Scene, Spectrum, Taps};

const WIDTH: usize = 640;
const HEIGHT: usize = 360;

/// The host's side: where a pixel's ray ends on a block, how that changes from pixel to pixel, and one call.
const HOST: &str = "
@group(0) @binding(0) var<storage, read_write> colors: array<vec4f>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u, @builtin(num_workgroups) groups: vec3u) {
    let index = id.x + id.y * groups.x * 64u;
    if index >= arrayLength(&colors) {
        return;
    }
    let pixel = vec2f(f32(index % 640u) - 319.5, f32(index / 640u) - 79.5);
    let right = vec3f(0.8, 0.6, 0.0);
    let way = pixel.x * right + vec3f(-300.0, 400.0, 0.0) - vec3f(0.0, 0.0, pixel.y);
    let eye = vec3f(4.0, -3.0, 2.6);
    var along = 1e9;
    var normal = vec3f();
    for (var block = 0; block < 400; block++) {
        let low = 2.6 * vec3f(f32(block % 20 - 17), f32(block / 20), 0.0) - eye;
        let high = low + vec3f(1.0, 1.0, 1.4);
        let enters = min(low / way, high / way);
        let leaves = max(low / way, high / way);
        let enter = max(enters.x, max(enters.y, enters.z));
        if enter > 0.0 && enter < min(along, min(leaves.x, min(leaves.y, leaves.z))) {
            along = enter;
            normal = -sign(way) * step(vec3f(enter), enters);
        }
    }
    if along == 1e9 {
        colors[index] = vec4f(mix(vec3f(0.25, 0.24, 0.22), vec3f(0.6, 0.7, 0.8), step(pixel.y, 0.0)), 1.0);
        return;
    }
    // From pixel to pixel the ray's end slides over the face that it is on.
    let slide = way / dot(normal, way);
    let dpdx = along * (right - slide * dot(normal, right));
    let dpdy = along * (slide * normal.z - vec3f(0.0, 0.0, 1.0));
    let light = 0.2 + 0.8 * max(dot(normal, vec3f(0.75, -0.2, 0.63)), 0.0);
    colors[index] = vec4f(light * stone_color(eye + along * way, dpdx, dpdy), 1.0);
}";

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let path = std::env::args().nth(1).unwrap_or_else(|| "target/noise.png".into());

    // What color each value has; the noise has the mean 0.5 and the deviation 0.18.
    let map = ColorMap::gradient_srgb([
        (0.20, [0.16, 0.10, 0.10]),
        (0.50, [0.72, 0.42, 0.33]),
        (0.50, [0.95, 0.90, 0.82]), // the same position twice: a hard edge
        (0.54, [0.90, 0.82, 0.72]),
        (0.54, [0.62, 0.34, 0.27]),
        (0.85, [0.86, 0.62, 0.50]),
    ])?;
    let noise = Gabor { spectrum: Spectrum::Isotropic { frequency: 4.0 }, bandwidth: 3.0, ..Gabor::default() };
    let driver = Driver::Gabor(Gabor { taps: Taps::Four, ..noise });
    let module = Scene::new("stone").texture(map).driver(driver).module()?;
    println!("{}", module.explain());

    // The module behind the host's text, on the device.
    let device = Device::new()?;
    let kernel = Kernel::new(&device, module.link(HOST)?.wgsl(), "main")?;
    let pixels = WIDTH * HEIGHT;
    let colors = kernel.run(&Work { inputs: &[], textures: &[], invocations: pixels, output: 4 * pixels })?;

    let encode = |linear: f32| (255.0 * from_linear(linear.clamp(0.0, 1.0)) + 0.5) as u8;
    let bytes: Vec<u8> = colors.chunks_exact(4).flat_map(|color| [0, 1, 2].map(|part| encode(color[part]))).collect();
    image::save_buffer(&path, &bytes, WIDTH as u32, HEIGHT as u32, image::ColorType::Rgb8)?;
    println!("{path}, filtered on {}", device.label());
    Ok(())
}
