//! How do waves look up to the horizon? Colors a sea by the slopes that each pixel sees, and writes `target/ocean.png`:
//! one point a pixel on the left, where far waves break up into noise, and whole footprints on the right, where facets
//! that face the eye count by their area in the picture.
//!
//! `cargo run --release --example ocean --features gpu`

use prefilter::gpu::{Device, Kernel, Work};
use prefilter::{ColorMap, Cosines, Driver, Pixel, Scene, Wave};

const WIDTH: u32 = 960;
const HEIGHT: u32 = 400;

/// The host's side: the eye is 5 m above the water, and the horizon 60 pixels below the upper edge.
const HOST: &str = "
@group(0) @binding(0) var<storage, read_write> colors: array<f32>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    if 3u * id.x >= arrayLength(&colors) {
        return;
    }
    let at = vec2f(f32(id.x % WIDTHu) - 0.5 * WIDTH.0 + 0.5, f32(id.x / WIDTHu) - 59.5);
    var color = mix(vec3f(0.75, 0.8, 0.85), vec3f(0.3, 0.45, 0.7), clamp(-at.y / 60.0, 0.0, 1.0));
    if at.y > 0.0 {
        let position = 5.0 * vec2f(at.x, 600.0) / at.y;
        let dpdx = vec2f(5.0 / at.y, 0.0);
        let dpdy = -position / at.y;
        let view = normalize(vec3f(-position, 5.0));
        let toward = -normalize(position); // what rises toward the eye faces away from it
        if at.x < 0.0 {
            color = sharp_color(position, dpdx, dpdy, view, toward);
        } else {
            color = sea_color(position, dpdx, dpdy, view, toward);
        }
    }
    for (var channel = 0u; channel < 3u; channel++) {
        colors[3u * id.x + channel] = color[channel];
    }
}";

/// Waves of 60 m to 40 cm before a wind along the view, of about equal steepness.
fn waves() -> Vec<Wave> {
    let wave = |index: i32| {
        let part = index as f32 / 47.0;
        let frequency = 150f32.powf(part) / 60.0;
        let turn = 0.4 + (0.7 + 0.5 * part) * (2.4 * index as f32).sin();
        let amplitude = 0.0055 / frequency;
        Wave { frequency: [frequency * turn.sin(), frequency * turn.cos()], amplitude, phase: 0.618 * index as f32 }
    };
    (0..48).map(wave).collect()
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // What a facet mirrors, by its slope toward the eye: deep water, the sky above, the horizon.
    let mirrored = ColorMap::gradient([
        (-0.4, [0.005, 0.03, 0.05]),
        (-0.12, [0.03, 0.12, 0.18]),
        (0.0, [0.2, 0.33, 0.43]),
        (0.12, [0.7, 0.76, 0.8]),
    ])?;
    let sea = |name: &str, pixel: Pixel| {
        let waves = Driver::Cosines(Cosines { waves: waves(), pixel, ..Cosines::default() });
        Scene::new(name).slope(mirrored.clone()).driver(waves).module()
    };
    let (sea, sharp) = (sea("sea", Pixel::default())?, sea("sharp", Pixel::Round(0.0))?);
    println!("{}", sea.explain());

    let device = Device::new()?;
    let host = HOST.replace("WIDTH", &WIDTH.to_string());
    let linked = prefilter::link(&[&sea, &sharp], &host)?;
    let pixels = (WIDTH * HEIGHT) as usize;
    let kernel = Kernel::new(&device, linked.wgsl(), "main")?;
    let colors = kernel.run(&Work { inputs: &[], textures: &[], invocations: pixels, output: 3 * pixels })?;
    let bytes = colors.iter().map(|color| (255.0 * color.clamp(0.0, 1.0).powf(1.0 / 2.2)).round() as u8).collect();
    let picture = image::RgbImage::from_raw(WIDTH, HEIGHT, bytes).ok_or("as many colors as pixels")?;
    picture.save("target/ocean.png")?;
    Ok(())
}
