//! Pyramids that the device builds against those of the processor, texel by texel.

use std::time::Instant;

use prefilter::gpu::{Device, Kernel, MomentPass, Texture, Work};
use prefilter::table::{Format, Level};
use prefilter::{Edge, Error, FourMomentMipmap, MomentMipmap};
use spirv_tests::random::Random;

const SIZES: [[u32; 2]; 11] =
    [[1, 1], [1, 9], [9, 1], [2, 2], [16, 16], [64, 4], [13, 7], [37, 23], [100, 60], [255, 129], [1023, 344]];

/// All four channels of a level's texels.
fn texels(kernel: &Kernel, texture: &Texture, number: u32) -> Vec<f32> {
    let [width, height] = [texture.wgpu().width(), texture.wgpu().height()].map(|side| (side >> number).max(1));
    let invocations = (width * height) as usize;
    let (number, width) = (f32::from_bits(number), f32::from_bits(width));
    let work = Work { inputs: &[&[number, width]], textures: &[texture], invocations, output: 4 * invocations };
    kernel.run(&work).unwrap()
}

fn reader(device: &Device) -> Kernel {
    let text = "@group(0) @binding(0) var<storage, read_write> output: array<vec4f>;
        @group(0) @binding(1) var<storage, read> level: array<u32>;
        @group(1) @binding(0) var image: texture_2d<f32>;
        @compute @workgroup_size(64)
        fn main(@builtin(global_invocation_id) id: vec3u, @builtin(num_workgroups) groups: vec3u) {
            let index = id.x + id.y * groups.x * 64u;
            if index < arrayLength(&output) {
                output[index] = textureLoad(image, vec2u(index % level[1], index / level[1]), level[0]);
            }
        }";
    Kernel::new(device, text, "main").unwrap()
}

/// Half an ulp of 1.
const UNIT: f32 = 5.97e-8;

/// How far means and deviations of a level may be for values in [0.2, 1.2], from the roundings of its sums.
///
/// A sum of n terms, of which none is above the range 1 and whose weights add up to 1, errs by at most n + 2 units; of
/// more than 64 terms by 66 and one for each 64. Two sums make a level, the second adds the first one's error. Means
/// and deviations are stored once each, a unit of 1.2. Levels that nest add what the level above errs by, others that
/// of the moments over texels, four units.
fn allowed(size: [u32; 2], number: u32) -> f32 {
    let at = |number: u32| size.map(|side| (side >> number).max(1));
    let (own, above) = (at(number), at(number.saturating_sub(1)));
    if number == 0 {
        return 0.0;
    }
    let nests = number > 1 && above[0].is_multiple_of(own[0]) && above[1].is_multiple_of(own[1]);
    let (from, before) = if nests { (above, allowed(size, number - 1)) } else { (size, 4.0 * UNIT) };
    let sum = |side: usize| {
        let terms = (from[side] as f32 / own[side] as f32).ceil() + 1.0;
        terms.min(64.0) + 2.0 + (terms / 64.0).floor()
    };
    before + UNIT * (sum(0) + sum(1) + 2.0 * 1.2)
}

fn image([width, height]: [u32; 2], seed: u32) -> Vec<f32> {
    let mut random = Random::new(seed);
    // Squares: skewed, and not about 0.
    (0..width * height).map(|_| 0.2 + random.unit().powi(2) as f32).collect()
}

/// The largest difference of any channel in parts of what is allowed, over all levels.
///
/// An error e of mean and deviation is one of 3 e/σ of the skewness and 4 e/σ of the kurtosis, times what is summed.
fn compared(expected: &[Level], channels: usize, found: impl Fn(u32) -> Vec<f32>) -> f32 {
    let size = [expected[0].width, expected[0].height];
    let mut most = 0f32;
    for (number, level) in (0..).zip(expected) {
        let error = allowed(size, number);
        for (texel, found) in level.texels.chunks(channels).zip(found(number).chunks(4)) {
            let deviation = texel[1].max(1e-9);
            let [skewness, kurtosis] = if channels == 4 { [texel[2], texel[3]] } else { [0.0; 2] };
            let absolute = (kurtosis + 3.0).sqrt();
            let of_skewness = 3.0 * (1.0 + absolute + skewness.abs()) * error / deviation;
            let of_kurtosis = 4.0 * (kurtosis + 3.0 + absolute + skewness.abs()) * error / deviation;
            let bounds = [error, error, of_skewness, of_kurtosis];
            for ((expected, found), bound) in texel.iter().zip(found).zip(bounds) {
                let apart = (expected - found).abs();
                let part = if apart == 0.0 { 0.0 } else { apart / bound };
                // Written so that NaN is the largest.
                most = if part <= most { most } else { part };
            }
        }
    }
    most
}

#[test]
fn the_device_builds_the_pyramids_of_the_processor() {
    let device = Device::new().unwrap();
    let reader = reader(&device);
    for (size, seed) in SIZES.into_iter().zip(1..) {
        let ([width, height], values) = (size, image(size, seed));
        for edge in [Edge::Clamp, Edge::Repeat] {
            let expected = MomentMipmap::new(width, height, &values, edge).unwrap();
            let texture = device.moments(width, height, &values, edge, Format::Rg32Float).unwrap();
            assert_eq!(texture.wgpu().mip_level_count() as usize, expected.levels().len());
            let two = compared(expected.levels(), 2, |number| texels(&reader, &texture, number));
            let expected = FourMomentMipmap::new(width, height, &values, edge).unwrap();
            let texture = device.moments(width, height, &values, edge, Format::Rgba32Float).unwrap();
            let four = compared(expected.levels(), 4, |number| texels(&reader, &texture, number));
            println!("{width}×{height} {edge:?}: {two:.3} and {four:.3} of what is allowed");
            assert!(two <= 1.0 && four <= 1.0, "{size:?} {edge:?}: {two} {four}");
        }
    }
}

/// The host's texture of bytes, whose content changes between two runs of the same passes.
#[test]
fn an_image_of_bytes_that_changes_is_built_again() {
    let device = Device::new().unwrap();
    let reader = reader(&device);
    let (width, height) = (21, 10);
    let size = wgpu::Extent3d { width, height, depth_or_array_layers: 1 };
    let image = device.wgpu().create_texture(&wgpu::TextureDescriptor {
        label: None,
        size,
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format: wgpu::TextureFormat::R8Unorm,
        usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST,
        view_formats: &[],
    });
    let pass = MomentPass::new(&device, Edge::Repeat, Format::Rgba16Float).unwrap();
    let pyramid = pass.prepare(&image).unwrap();
    for seed in [3, 4] {
        let mut random = Random::new(seed);
        let bytes: Vec<u8> = (0..width * height).map(|_| (random.word() >> 25) as u8).collect();
        let layout = wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(width), rows_per_image: None };
        device.queue().write_texture(image.as_image_copy(), &bytes, layout, size);
        pyramid.run().unwrap();
        let values: Vec<f32> = bytes.iter().map(|&byte| f32::from(byte) / 255.0).collect();
        let expected = FourMomentMipmap::new(width, height, &values, Edge::Repeat).unwrap();
        for (number, level) in (0..).zip(expected.levels()) {
            let found = texels(&reader, pyramid.texture(), number);
            assert_eq!(found.len(), level.texels.len());
            for (expected, found) in level.texels.iter().zip(&found) {
                // An ulp of 16 bits, for lavapipe rounds towards 0, and what sums in f32 differ by.
                let bound = expected.abs() * 2f32.powi(-10) + 1e-5;
                assert!((expected - found).abs() <= bound, "{seed} {number}: {found} of {expected}");
            }
        }
    }
}

/// Other validators see the same texts in the corpus of `cargo xtask ci`.
#[test]
fn passes_are_shaders_of_other_languages_too() {
    for format in [Format::Rg32Float, Format::Rgba32Float, Format::Rgba16Float] {
        for edge in [Edge::Clamp, Edge::Repeat] {
            let shader = MomentPass::shader(edge, format).unwrap();
            assert!(!shader.spirv().unwrap().is_empty());
            let (hlsl, msl) = (shader.hlsl().unwrap(), shader.msl().unwrap());
            for entry in ["points", "texels", "columns", "rows", "copies"] {
                assert!(shader.wgsl().contains(&format!("fn {entry}(")));
                assert!(hlsl.contains(entry) && msl.contains(entry), "{entry}");
            }
        }
    }
}

#[test]
fn passes_refuse_what_is_no_image_and_formats_that_none_stores() {
    let device = Device::new().unwrap();
    let refused = MomentPass::new(&device, Edge::Clamp, Format::Rg16Float).unwrap_err();
    assert!(matches!(refused, Error::Conflict(_)), "{refused}");
    let refused = device.moments(2, 2, &[0.5; 3], Edge::Clamp, Format::Rg32Float).unwrap_err();
    assert!(matches!(refused, Error::Size { .. }), "{refused}");
    let integers = device.wgpu().create_texture(&wgpu::TextureDescriptor {
        label: None,
        size: wgpu::Extent3d { width: 4, height: 4, depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format: wgpu::TextureFormat::R32Uint,
        usage: wgpu::TextureUsages::TEXTURE_BINDING,
        view_formats: &[],
    });
    let pass = MomentPass::new(&device, Edge::Clamp, Format::Rg32Float).unwrap();
    let refused = pass.prepare(&integers).unwrap_err();
    assert!(matches!(refused, Error::Device { .. }), "{refused}");
}

/// Prints the times of both; on a device that runs on the processor they say little of others.
#[test]
fn times_of_the_device_and_of_the_processor() {
    let device = Device::new().unwrap();
    for size in [[512, 512], [403, 344], [1024, 1024], [1001, 1001]] {
        let [width, height] = size;
        let values = image(size, 9);
        let seconds = |work: &dyn Fn()| {
            let times = (0..5).map(|_| {
                let start = Instant::now();
                work();
                start.elapsed().as_secs_f64()
            });
            1e3 * times.fold(f64::INFINITY, f64::min)
        };
        let two = seconds(&|| drop(MomentMipmap::new(width, height, &values, Edge::Repeat).unwrap()));
        let four = seconds(&|| drop(FourMomentMipmap::new(width, height, &values, Edge::Repeat).unwrap()));
        let host = device.upload(
            &MomentMipmap::new(width, height, &values, Edge::Repeat)
                .unwrap()
                .table("image", Format::Rg32Float)
                .unwrap(),
            prefilter::gpu::Address::Repeat,
        );
        let host = host.unwrap();
        let passed = [Format::Rg32Float, Format::Rgba32Float, Format::Rgba16Float].map(|format| {
            let pyramid = MomentPass::new(&device, Edge::Repeat, format).unwrap().prepare(host.wgpu()).unwrap();
            seconds(&|| pyramid.run().unwrap())
        });
        let [of_two, of_four, halves] = passed;
        println!("{width}×{height}, two moments: processor {two:.1} ms, {} {of_two:.1} ms", device.label());
        println!("{width}×{height}, four: processor {four:.1} ms, device {of_four:.1} ms, in halves {halves:.1} ms");
        assert!(passed.into_iter().all(|time| time > 0.0));
    }
}
