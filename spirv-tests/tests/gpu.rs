//! `prefilter::gpu`: results, textures and refusals on a real device.

use prefilter::gpu::{Address, Device, Kernel, Texture, Work};
use prefilter::table::{Format, Level, Sampling, Table};
use prefilter::Error;

fn device() -> Device {
    Device::new().expect("the tests need a device")
}

fn doubled() -> &'static str {
    "@group(0) @binding(0) var<storage, read_write> output: array<f32>;
    @group(0) @binding(1) var<storage, read> values: array<f32>;
    @compute @workgroup_size(64)
    fn main(@builtin(global_invocation_id) id: vec3u, @builtin(num_workgroups) groups: vec3u) {
        let index = id.x + id.y * groups.x * 64u;
        if index < arrayLength(&values) { output[index] = 2.0 * values[index]; }
    }"
}

#[test]
fn runs_and_leaves_nan_where_nothing_is_written() {
    let kernel = Kernel::new(&device(), doubled(), "main").unwrap();
    let output = kernel.run(&Work { inputs: &[&[1.0, -3.5]], textures: &[], invocations: 2, output: 3 }).unwrap();
    assert_eq!(output[..2], [2.0, -7.0]);
    assert!(output[2].is_nan());
}

#[test]
fn spreads_more_workgroups_than_a_dimension_holds() {
    let device = device();
    let count = 65_535 * 64 + 1_000;
    let values: Vec<f32> = (0..count).map(|index| index as f32).collect();
    let kernel = Kernel::new(&device, doubled(), "main").unwrap();
    let work = Work { inputs: &[&values], textures: &[], invocations: count, output: count };
    let prepared = kernel.prepare(&work).unwrap();
    let output = prepared.run().unwrap();
    assert!(output.iter().zip(&values).all(|(output, value)| *output == 2.0 * value));
    let seconds = prepared.time().unwrap();
    assert!(seconds > 0.0 && seconds < 10.0, "{seconds}");
    assert_eq!(prepared.run().unwrap(), output);
}

#[test]
fn keeps_the_bits_of_integers() {
    let text = "@group(0) @binding(0) var<storage, read_write> output: array<u32>;
        @group(0) @binding(1) var<storage, read> values: array<u32>;
        @compute @workgroup_size(1) fn main() { for (var i = 0; i < 4; i++) { output[i] = values[i] + 1u; } }";
    let values = [0u32, 5, 0x7f80_0001, 0xffff_fff0].map(f32::from_bits);
    let kernel = Kernel::new(&device(), text, "main").unwrap();
    let output = kernel.run(&Work { inputs: &[&values], textures: &[], invocations: 1, output: 4 }).unwrap();
    assert_eq!(output.iter().map(|value| value.to_bits()).collect::<Vec<_>>(), [1, 6, 0x7f80_0002, 0xffff_fff1]);
}

fn table(format: Format, sampling: Sampling, levels: Vec<Level>) -> Table {
    Table { name: "ramp".into(), format, sampling, levels, error: 0.0 }
}

/// Samples the texture at u, level.
fn sample(device: &Device, texture: &Texture, points: &[f32]) -> Vec<f32> {
    let text = "@group(0) @binding(0) var<storage, read_write> output: array<f32>;
        @group(0) @binding(1) var<storage, read> points: array<vec2f>;
        @group(1) @binding(0) var ramp: texture_2d<f32>;
        @group(1) @binding(1) var ramp_sampler: sampler;
        @compute @workgroup_size(1)
        fn main(@builtin(global_invocation_id) id: vec3u) {
            let point = points[id.x];
            output[id.x] = textureSampleLevel(ramp, ramp_sampler, vec2f(point.x, 0.5), point.y).x;
        }";
    let count = points.len() / 2;
    let kernel = Kernel::new(device, text, "main").unwrap();
    kernel.run(&Work { inputs: &[points], textures: &[texture], invocations: count, output: count }).unwrap()
}

fn ramp(format: Format) -> Vec<Level> {
    let texels = |values: &[f32]| {
        values.iter().flat_map(|&value| [value, 0.0, 0.0, 1.0].into_iter().take(format.channels())).collect()
    };
    let first = Level { width: 4, height: 1, depth: 1, texels: texels(&[1.0, 2.0, 4.0, 8.0]) };
    let second = Level { width: 2, height: 1, depth: 1, texels: texels(&[10.0, 20.0]) };
    vec![first, second, Level { width: 1, height: 1, depth: 1, texels: texels(&[100.0]) }]
}

#[test]
fn samples_every_format_between_texels_levels_and_beyond_the_edge() {
    let device = device();
    let points = [0.125, 0.0, 0.25, 0.0, 0.5, 0.5, 1.125, 0.0, -0.125, 0.0, 0.5, 9.0];
    for format in [Format::Rgba32Float, Format::Rgba16Float, Format::Rg32Float, Format::Rg16Float] {
        let table = table(format, Sampling::Filtered, ramp(format));
        for (address, right, left) in
            [(Address::Clamp, 8.0, 1.0), (Address::Repeat, 1.0, 8.0), (Address::Mirror, 8.0, 1.0)]
        {
            let texture = device.upload(&table, address).unwrap();
            let values = sample(&device, &texture, &points);
            assert_eq!(values, [1.0, 1.5, 9.0, right, left, 100.0], "{format:?}, {address:?}");
        }
        let loaded = Table { sampling: Sampling::Loaded, ..table };
        let texture = device.upload(&loaded, Address::Clamp).unwrap();
        assert_eq!(sample(&device, &texture, &[0.3, 0.0]), [2.0], "{format:?}: nearest");
    }
}

/// Numbers from 0 to 1 become the nearest of 1024, what lies beyond its end.
#[test]
fn samples_parts_in_ten_bits() {
    let device = device();
    let texels = vec![0.25, 0.5, 1.0, 1.0, 0.75, 0.5, 0.0, 0.0, 2.0, 0.5, 0.0, 0.0, -1.0, 0.5, 0.0, 0.0];
    let level = Level { width: 4, height: 1, depth: 1, texels };
    let table = table(Format::Rgb10a2Unorm, Sampling::Filtered, vec![level]);
    assert_eq!((table.bytes(), Format::Rgb10a2Unorm.encode(&[0.25, 0.5, 1.0, 1.0])), (16, vec![0, 1, 248, 255]));
    let texture = device.upload(&table, Address::Clamp).unwrap();
    let values = sample(&device, &texture, &[0.125, 0.0, 0.375, 0.0, 0.25, 0.0, 0.625, 0.0, 0.875, 0.0]);
    for (value, parts) in values.iter().zip([256.0, 767.0, 511.5, 1023.0, 0.0]) {
        assert!((value - parts / 1023.0).abs() < 1e-5, "{value} for {parts} of 1023");
    }
}

/// Slices lie on centers along the depth as texels do along a row.
#[test]
fn samples_between_the_slices_of_a_volume() {
    let device = device();
    let texels = [1.0, 2.0, 3.0, 5.0, 10.0, 20.0, 30.0, 50.0].map(|value| [value, 0.0]).concat();
    let level = Level { width: 2, height: 2, depth: 2, texels };
    let volume = table(Format::Rg16Float, Sampling::Filtered, vec![level]);
    assert_eq!((volume.wgsl_type(), volume.bytes()), ("texture_3d<f32>", 32));
    let text = "@group(0) @binding(0) var<storage, read_write> output: array<f32>;
        @group(0) @binding(1) var<storage, read> points: array<f32>;
        @group(1) @binding(0) var volume: texture_3d<f32>;
        @group(1) @binding(1) var volume_sampler: sampler;
        @compute @workgroup_size(1)
        fn main(@builtin(global_invocation_id) id: vec3u) {
            let at = vec3f(points[3u * id.x], points[3u * id.x + 1u], points[3u * id.x + 2u]);
            output[id.x] = textureSampleLevel(volume, volume_sampler, at, 0.0).x;
        }";
    let texture = device.upload(&volume, Address::Clamp).unwrap();
    let points = [0.25, 0.25, 0.25, 0.75, 0.25, 0.25, 0.25, 0.75, 0.25, 0.25, 0.25, 0.75, 0.5, 0.5, 0.5, 2.0, 2.0, 2.0];
    let kernel = Kernel::new(&device, text, "main").unwrap();
    let work = Work { inputs: &[&points], textures: &[&texture], invocations: 6, output: 6 };
    assert_eq!(kernel.run(&work).unwrap(), [1.0, 2.0, 3.0, 10.0, 121.0 / 8.0, 50.0]);
    let short = Level { width: 2, height: 2, depth: 3, texels: vec![0.0; 16] };
    let error = device.upload(&table(Format::Rg16Float, Sampling::Filtered, vec![short]), Address::Clamp).unwrap_err();
    assert!(error.to_string().contains("values in level 0 of table `ramp` is 16; allowed is 24"), "{error}");
}

#[test]
fn refuses_what_does_not_fit_with_its_place() {
    let device = device();
    let refused = |levels: Vec<Level>| {
        let error = device.upload(&table(Format::Rg16Float, Sampling::Filtered, levels), Address::Clamp).unwrap_err();
        assert!(matches!(error, Error::Size { .. }), "{error}");
        error.to_string()
    };
    let level = |width, height, count| Level { width, height, depth: 1, texels: vec![0.0; count] };
    assert!(refused(vec![]).contains("levels of table `ramp` is 0"));
    assert!(refused(vec![level(0, 1, 0)]).contains("the width of level 0 of table `ramp` is 0"));
    assert!(refused(vec![level(4, 2, 15)]).contains("values in level 0 of table `ramp` is 15; allowed is 16"));
    assert!(refused(vec![level(4, 2, 16), level(4, 1, 8)]).contains("width of level 1"));
    assert!(refused(vec![level(1, 1, 2), level(1, 1, 2)]).contains("the number of levels of table `ramp` is 2"));
    let limit = device.wgpu().limits().max_texture_dimension_2d;
    assert!(refused(vec![level(limit + 1, 1, 2 * limit as usize + 2)]).contains("allowed is 1 to"));
}

#[test]
fn refuses_wrong_kernels_and_work_as_errors() {
    let device = device();
    let error =
        Kernel::new(&device, "fn f() -> f32 { return 1; }\n@compute @workgroup_size(1) fn main() { g(); }", "main");
    assert!(matches!(&error, Err(Error::Shader { message }) if message.contains("`g`")), "{error:?}");
    let missing = Kernel::new(&device, doubled(), "other").unwrap_err().to_string();
    assert!(missing.contains("no compute entry point `other`"), "{missing}");
    let kernel = Kernel::new(&device, doubled(), "main").unwrap();
    let work = Work { inputs: &[&[1.0]], textures: &[], invocations: 1, output: 1 };
    for wrong in [Work { output: 0, ..work }, Work { invocations: 0, ..work }, Work { inputs: &[&[]], ..work }] {
        assert!(matches!(kernel.run(&wrong), Err(Error::Size { count: 0, .. })), "{wrong:?}");
    }
    let unbound = kernel.run(&Work { inputs: &[], ..work }).unwrap_err();
    assert!(matches!(unbound, Error::Device { .. }), "{unbound}");
}
