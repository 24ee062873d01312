//! Dynamic colors: materials that differ in colors, stops and stop count share one text and one pipeline.

use std::error::Error;

use prefilter::gpu::{Address, Device, Kernel as Compute, Work};
use prefilter::reference::texture::mean;
use prefilter::{ColorMap, Colors, Kernel, Module, Scene, Tier};
use spirv_tests::maps::{named, random};

type Outcome = Result<(), Box<dyn Error + Send + Sync>>;

fn material(map: &ColorMap, tier: Tier) -> Result<Module, prefilter::Error> {
    Scene::new("material").texture(map.clone()).colors(Colors::Dynamic).tier(tier).module()
}

const ENTRY: &str = "
@group(0) @binding(0) var<storage, read_write> colors: array<vec4f>;
@group(0) @binding(1) var<storage, read> points: array<vec2f>;
@group(1) @binding(0) var colors_of_the_map: texture_2d<f32>;
@group(1) @binding(1) var colors_sampler: sampler;
@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    if id.x < arrayLength(&colors) {
        let point = points[id.x];
        colors[id.x] = vec4f(material_texture(point.x, point.y, ARGUMENTS), 1.0);
    }
}
";

#[test]
fn two_materials_share_one_text_and_one_pipeline() -> Outcome {
    let device = Device::new()?;
    let maps = [named("terrain")?, random(19, true, 5)?];
    assert_ne!(maps[0].knots().len(), maps[1].knots().len());
    let points: Vec<f32> = (0..600).flat_map(|at| [at as f32 / 400.0 - 0.25, 0.3 / (1.0 + (at % 37) as f32)]).collect();
    for (tier, arguments) in [
        (Tier::ClosedForm(Kernel::Exact), "colors_of_the_map"),
        (Tier::Table, "colors_of_the_map, colors_sampler"),
        (Tier::Paper, "colors_of_the_map, colors_sampler"),
    ] {
        let modules = [material(&maps[0], tier)?, material(&maps[1], tier)?];
        assert_eq!(modules[0].wgsl(), modules[1].wgsl(), "{tier}");
        assert_ne!(modules[0].tables(), modules[1].tables(), "{tier}");
        let text = modules[0].link(&ENTRY.replace("ARGUMENTS", arguments))?;
        let pipeline = Compute::new(&device, text.wgsl(), "main")?; // one, for both
        for (map, module) in maps.iter().zip(&modules) {
            let texture = device.upload(&module.tables()[0], Address::Clamp)?;
            let work = Work { inputs: &[&points], textures: &[&texture], invocations: 600, output: 4 * 600 };
            let colors = pipeline.run(&work)?;
            let mut worst = 0.0f64;
            for (color, point) in colors.chunks_exact(4).zip(points.chunks_exact(2)) {
                let truth = mean(&map.reference(), point[0].into(), point[1].into());
                let error = |channel: usize| (f64::from(color[channel]) - truth[channel]).abs();
                worst = (0..3).map(error).fold(worst, |worst, error| if error <= worst { worst } else { error });
            }
            println!("{tier}, {} knots: {worst:.2e}, bound {}", map.knots().len(), module.bound());
            assert!(worst <= f64::from(module.bound().value()), "{tier}: {worst}");
        }
    }
    Ok(())
}
