//! What a fragment shader of the paper's three cases calls.

use super::scenes::cases;
use prefilter::{Module, Shader};

/// A case's fragment shader.
pub struct Call {
    /// The case.
    pub name: &'static str,
    /// The lines that call the module.
    pub lines: &'static str,
    /// The module.
    pub module: Module,
    /// The whole shader, which naga has validated.
    pub shader: Shader,
}

/// The lines of each case, by the order of [`cases`].
const LINES: [&str; 3] = [
    "    color = lichen_texture(mean, deviation);",
    "    color = moss_height(mean, deviation, slope_covariance, view, light);
    color *= moss_visibility(slope_covariance, view, light);
    alpha = moss_masking(slope_covariance, view);",
    "    color = dune_slope(mean_slope, slope_covariance, view, direction);",
];

/// The cases with their calls.
///
/// # Errors
/// What naga refuses.
pub fn all() -> Result<Vec<Call>, prefilter::Error> {
    let call = |((name, scene), lines): ((&'static str, prefilter::Scene), &'static str)| {
        let module = scene.module()?;
        let shader = module.link(&format!(
            "@fragment fn main(
    @location(0) mean: f32,
    @location(1) deviation: f32,
    @location(2) mean_slope: vec2f,
    @location(3) slope_covariance: vec3f,
    @location(4) view: vec3f,
    @location(5) light: vec3f,
    @location(6) direction: vec2f,
) -> @location(0) vec4f {{
    var color = vec3f();
    var alpha = 1.0;
{lines}
    return vec4f(color, alpha);
}}
"
        ))?;
        Ok(Call { name, lines, module, shader })
    };
    cases()?.into_iter().zip(LINES).map(call).collect()
}
