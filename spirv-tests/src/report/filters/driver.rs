//! A filter behind a driver: what a pixel costs whose statistics are not given.

use super::case::Row;
use super::maps::named;
use crate::exports::ExportKernel;
use crate::report::Error;
use prefilter::gpu::Device;
use prefilter::{Driver, Module, Noise, Scene, SlopeTier, Tier};

/// Six octaves of Perlin's noise over a footprint, as values or as heights with slopes.
fn noise(slopes: bool) -> Result<Module, Error> {
    let (scene, map) = (Scene::new("octaves"), named("terrain")?);
    let scene =
        if slopes { scene.slope(map).slope_tier(SlopeTier::Naive) } else { scene.texture(map).tier(Tier::Naive) };
    Ok(scene.driver(Driver::Noise(Noise::default())).module()?)
}

/// Whether a function takes slopes, which the driver then finds.
pub fn takes_slopes(kernel: &ExportKernel) -> bool {
    kernel.parameters().iter().any(|(name, _)| *name == "mean_slope" || *name == "slope_covariance")
}

/// What the driver gives for a parameter.
fn given(name: &str, slopes: bool) -> Option<&'static str> {
    match (name, slopes) {
        ("mean", false) => Some("m.x"),
        ("deviation", false) => Some("sqrt(max(m.y, 0.0))"),
        ("mean", true) => Some("m.moments.x"),
        ("deviation", true) => Some("sqrt(max(m.moments.y, 0.0))"),
        ("mean_slope", true) => Some("m.slope"),
        ("slope_covariance", true) => Some("m.slope_covariance"),
        _ => None,
    }
}

/// The row's function behind the driver. The color's last channel is the sum of all statistics, whether the function
/// takes them or not, so that no compiler leaves any out.
///
/// # Errors
/// What naga or the device refuses.
pub fn driven(device: &Device, row: &Row, slopes: bool) -> Result<ExportKernel, Error> {
    let kernel = row.kernel(device)?;
    let parameters = kernel.parameters();
    let argument = |(name, _): &(&str, &str)| given(name, slopes).map_or((*name).to_owned(), str::to_owned);
    let arguments: Vec<String> = parameters.iter().map(argument).collect();
    let passed = parameters.iter().filter(|(name, _)| given(name, slopes).is_none());
    let passed: String = passed.map(|(name, kind)| format!(", {name}: {kind}")).collect();
    let (read, kept) = if slopes {
        ("octaves_surface", "dot(m.moments.xy + m.slope, vec2f(1.0)) + dot(m.slope_covariance, vec3f(1.0))")
    } else {
        ("octaves_statistics", "m.x + m.y")
    };
    let text = format!(
        "{}
fn driven(position: vec2f, dpdx: vec2f, dpdy: vec2f{passed}) -> vec4f {{
    let m = {read}(position, 0.5 * dpdx, 0.5 * dpdy);
    return vec4f({}({}), {kept});
}}
",
        row.text,
        row.function,
        arguments.join(", ")
    );
    let noise = noise(slopes)?;
    let modules: Vec<&Module> = row.modules.iter().chain([&noise]).collect();
    Ok(ExportKernel::before(device, &modules, &text, "driven")?)
}
