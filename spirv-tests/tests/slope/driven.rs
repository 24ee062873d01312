//! Slopes from a map's pyramid.

use prefilter::gpu::{Address, Device, Kernel, Work};
use prefilter::table::Format;
use prefilter::{
    Driver, Edge, Error, Irradiance, IrradianceTier, Moments, Scene, SlopeMipmap, SlopeMoments, SlopeTier, Taps, Tier,
};
use spirv_tests::maps::named;
use spirv_tests::random::Random;

use crate::{Fault, Outcome};

fn driven(taps: Taps) -> Driver {
    Driver::SlopeMoments(SlopeMoments { taps, ..SlopeMoments::default() })
}

/// A scene of each kind without a table, with its filter's name and what that takes behind the slopes' statistics.
fn kinds() -> Result<Vec<(Scene, &'static str, &'static str)>, Fault> {
    let slope = Scene::new("rock").slope(named("terrain")?).tier(Tier::Naive);
    let sky = Irradiance::from_harmonics(std::array::from_fn(|term| [0.9, 0.3, 0.2].map(|c| c / (1.0 + term as f32))))?;
    let hill = Scene::new("rock").irradiance(sky).irradiance_tier(IrradianceTier::FourGaussians);
    let view = "vec3f(0.48, -0.36, 0.8)";
    let frame = "vec3f(0.48, -0.36, 0.8), vec3f(0.6, 0.8, 0.0), vec3f(-0.8, 0.6, 0.0), vec3f(0.0, 0.0, 1.0)";
    let component = "vec3f(0.48, -0.36, 0.8), vec2f(-0.6, 0.8)";
    Ok(vec![
        (slope.clone().slope_tier(SlopeTier::Unweighted), "slope", "vec2f(-0.6, 0.8)"),
        (slope.clone().slope_tier(SlopeTier::Gaussian), "slope", component),
        (slope.slope_tier(SlopeTier::Pair), "slope", component),
        (Scene::new("rock").steepness(named("terrain")?), "steepness", view),
        (hill, "irradiance", frame),
    ])
}

/// A compute shader that asks a module's driver, and its filter for the statistics of a buffer.
fn entry(function: &str, given: &str, table: bool) -> String {
    let (bindings, table) = match table {
        true => (
            "@group(1) @binding(4) var table: texture_2d<f32>;\n@group(1) @binding(5) var table_sampler: sampler;\n",
            ", table, table_sampler",
        ),
        false => ("", ""),
    };
    format!(
        "
@group(0) @binding(0) var<storage, read_write> colors: array<vec4f>;
@group(0) @binding(1) var<storage, read> whole: array<f32>;
@group(1) @binding(0) var slopes: texture_2d<f32>;
@group(1) @binding(1) var slopes_sampler: sampler;
@group(1) @binding(2) var slopes_cross: texture_2d<f32>;
{bindings}@compute @workgroup_size(1)
fn main() {{
    let reach = whole[0];
    let color = rock_color(vec2f(0.3, 0.6), vec2f(reach, 0.0), vec2f(0.0, reach), {given}, slopes, slopes_cross,
        slopes_sampler{table});
    colors[0] = vec4f(color, 0.0);
    let mean = vec2f(whole[1], whole[2]);
    colors[1] = vec4f(rock_{function}(mean, vec3f(whole[3], whole[4], whole[5]), {given}{table}), 0.0);
}}"
    )
}

/// A footprint over all of the map and more has the map's slopes, however many taps lie in it.
#[test]
fn a_pixel_of_a_whole_map_sees_its_slopes() -> Outcome {
    let device = Device::new()?;
    let mut random = Random::new(3);
    let slopes: Vec<[f32; 2]> = (0..4096).map(|_| [random.unit() as f32 - 0.2, random.unit() as f32 - 0.6]).collect();
    let mipmap = SlopeMipmap::from_slopes(64, 64, &slopes, Edge::Repeat)?;
    let tables = mipmap.tables("slopes", Format::Rgba32Float)?;
    let [one, two] = [device.upload(&tables[0], Address::Repeat)?, device.upload(&tables[1], Address::Repeat)?];
    let (mean, covariance) = mipmap.moments();
    let whole = [&[900.0], &mean[..], &covariance].concat();
    for (scene, function, given) in kinds()? {
        for taps in [Taps::One, Taps::Two, Taps::Eight] {
            let module = scene.clone().driver(driven(taps)).module()?;
            assert!(module.explain().contains("footprints are from normal"), "{}", module.explain());
            let mut textures = vec![&one, &two];
            let table = module.tables().first().map(|table| device.upload(table, Address::Clamp)).transpose()?;
            textures.extend(&table);
            let kernel = Kernel::new(&device, module.link(&entry(function, given, table.is_some()))?.wgsl(), "main")?;
            let colors = kernel.run(&Work { inputs: &[&whole], textures: &textures, invocations: 1, output: 8 })?;
            for channel in 0..3 {
                let [color, own] = [colors[channel], colors[4 + channel]];
                assert!(own > 0.01 && (color - own).abs() <= 4e-6, "{function}, {taps:?}: {colors:?}");
            }
        }
    }
    Ok(())
}

#[test]
fn parameters_keep_their_order() -> Outcome {
    for (scene, function, given) in kinds()? {
        let module = scene.driver(driven(Taps::One)).module()?;
        let names: Vec<&str> = module.exports().iter().map(|export| export.name.as_str()).collect();
        assert_eq!(names[0], format!("rock_{function}"));
        let color = module.exports().iter().find(|export| export.name == "rock_color").ok_or("no color")?;
        let names: Vec<&str> = color.parameters().into_iter().map(|(name, _)| name).collect();
        let given = match (function, given.starts_with("vec3f")) {
            ("slope", false) => "direction ",
            ("slope", true) => "view direction ",
            ("steepness", _) => "view ",
            _ => "view x y z ",
        };
        let tables = if function == "steepness" { " table table_sampler" } else { "" };
        let expected = format!("position dpdx dpdy {given}slopes slopes_cross slopes_sampler{tables}");
        assert_eq!(names.join(" "), expected);
    }
    Ok(())
}

#[test]
fn drivers_of_the_wrong_kind_are_refused() -> Outcome {
    let conflict = |scene: Scene| match scene.module() {
        Err(Error::Conflict(message)) => message,
        other => format!("no conflict: {:?}", other.map(|module| module.explain().to_owned())),
    };
    for (scene, function, _) in kinds()? {
        let message = conflict(scene.driver(Driver::Moments(Moments::default())));
        let without = "goes without a driver that gives mean and deviation of a value, `Driver::Moments`";
        assert!(message.contains(function) && message.contains(without), "{message}");
    }
    let values = Scene::new("rock").texture(named("terrain")?).driver(driven(Taps::One));
    let without = "a `texture` goes without a driver that gives mean and covariance of slopes, `Driver::SlopeMoments`";
    assert_eq!(conflict(values), without);
    let heights = conflict(Scene::new("rock").height(named("terrain")?).driver(driven(Taps::One)));
    assert!(heights.starts_with("a `height` goes without a driver that gives mean and covariance"), "{heights}");
    Ok(())
}
