//! A scene with all filters: one module of each, which link together.

use prefilter::{
    ColorMap, Combination, Cosines, Driver, Error, Export, HeightTransfer, Irradiance, Microsurface, Module, Noise,
    Scene, SlopeDomain, SlopeMap, Wave,
};

/// The scenes, by what they filter. None names a tier, so that each tries all that it may choose, tables included.
///
/// # Errors
/// None that has been seen: the maps are fixed.
pub fn scenes() -> Result<Vec<(&'static str, Scene)>, Error> {
    let ramp = ColorMap::gradient([
        (0.0, [0.05, 0.09, 0.03]),
        (0.2, [0.14, 0.16, 0.07]),
        (0.45, [0.21, 0.24, 0.10]),
        (0.45, [0.42, 0.40, 0.37]),
        (0.8, [0.55, 0.53, 0.5]),
        (1.0, [0.71, 0.69, 0.66]),
    ])?;
    let sand = ColorMap::gradient([(-0.6, [0.31, 0.22, 0.12]), (-0.1, [0.78, 0.63, 0.41]), (0.5, [0.93, 0.84, 0.68])])?;
    let cliff = ColorMap::gradient([(0.25, [0.22, 0.31, 0.09]), (0.7, [0.46, 0.41, 0.36]), (1.2, [0.31, 0.28, 0.26])])?;
    let wheel = SlopeMap::from_function(64, SlopeDomain::All, |[x, y]| {
        let part = 0.45 / x.hypot(y).max(0.1);
        [0.5 + part * x, 0.5 + part * y, 0.5 - part * x]
    })?;
    let sky = Irradiance::from_harmonics([[0.9, 1.1, 1.4]; 9])?;
    let masked = Microsurface { masking: true, ..Microsurface::default() };
    let wave = |frequency, amplitude, phase| Wave { frequency, amplitude, phase };
    let waves = vec![wave([1.0, 0.3], 0.4, 0.1), wave([-0.5, 1.1], 0.3, 2.0)];
    let cushions = HeightTransfer::smoothstep(0.0, 1.2)?;
    let all = |scene: Scene| scene.driver(Driver::Cosines(Cosines { waves: waves.clone(), ..Cosines::default() }));
    Ok(vec![
        ("texture", Scene::new("lichen").texture(ramp.clone()).driver(Driver::Noise(Noise::default()))),
        ("height", Scene::new("strata").height(ramp.clone()).microsurface(masked)),
        ("height_percentile", Scene::new("rust").height_percentile(ramp.clone())),
        ("slope", Scene::new("dune").slope(sand)),
        ("slope_map", Scene::new("aspect").slope_map(wheel)),
        ("steepness", all(Scene::new("cliff").steepness(cliff.clone()))),
        ("irradiance", Scene::new("hill").irradiance(sky)),
        ("combination", Scene::new("hills").combination(hills(&ramp, cliff)?)),
        ("transfer", all(Scene::new("moss").height(ramp).transfer(cushions))),
    ])
}

/// Grains on rock by its steepness, and snow where it is high.
fn hills(grain: &ColorMap, rock: ColorMap) -> Result<Combination, Error> {
    let grain = Scene::new("grain").texture(grain.clone());
    let rock = Scene::new("rock").steepness(rock);
    let high = Scene::new("high").height(ColorMap::gradient([(0.6, [0.0; 3]), (0.8, [1.0; 3])])?);
    Ok(&grain * &rock * (1.0 - &high) + Combination::color([0.9, 0.9, 0.95])? * &high)
}

/// A fragment shader that calls every export of the modules and adds up what they return.
pub fn entry(modules: &[Module]) -> String {
    let (mut bindings, mut sum, mut count) = (String::new(), String::new(), 0);
    for module in modules {
        let mut known: Vec<String> = Vec::new();
        let mut argument = |(name, kind): (&str, &str)| match kind {
            "f32" => "pixel_numbers.x".to_owned(),
            "vec2f" => "pixel_numbers.xy".to_owned(),
            "vec3f" => "pixel_numbers.xyz".to_owned(),
            "vec4f" => "pixel_numbers".to_owned(),
            _ => {
                // Not the name of a function of the module.
                let own = format!("bound_{}_{name}", module.name());
                if !known.contains(&own) {
                    bindings += &format!("@group(1) @binding({count}) var {own}: {kind};\n");
                    count += 1;
                    known.push(own.clone());
                }
                own
            }
        };
        let mut call = |export: &Export| {
            let list: Vec<String> = export.parameters().into_iter().map(&mut argument).collect();
            let call = format!("{}({})", export.name, list.join(", "));
            match export.result() {
                "vec4f" => format!("    sum += {call};\n"),
                "vec3f" => format!("    sum += vec4f({call}, 0.0);\n"),
                _ => format!("    sum += vec4f({call});\n"),
            }
        };
        sum += &module.exports().iter().map(&mut call).collect::<String>();
    }
    format!(
        "@group(0) @binding(0) var<uniform> pixel_numbers: vec4f;
{bindings}@fragment
fn main() -> @location(0) vec4f {{
    var sum = vec4f();
{sum}    return sum;
}}
"
    )
}
