//! The octaves of noise in space, which surfaces cut.

use super::noise::{Noise, NoiseMethod};
use super::octaves::{apart, CUT};

/// The shelf's names of a noise in space: of the noise, and of its filter.
pub(super) struct Solid {
    pub noise: &'static str,
    pub filter: &'static str,
}

/// Where an octave has the origin of the one before, 1/φ, √2 − 1 and √3 − 1: no lattice point of one is near another's.
const OFFSET: &str = "vec3f(0.618033989, 0.414213562, 0.732050808)";

/// The loop over octaves, which returns statistics of the given mean and scale; `variance` is that of an octave.
pub(super) fn body(of: &Noise, solid: &Solid, [mean, scale]: [f32; 2], variance: f64) -> String {
    let Noise { octaves, gain, lacunarity, .. } = of;
    let Solid { noise, filter } = solid;
    let seed = apart(of.seed);
    let mut before = String::new();
    let mut after = String::new();
    let mut tile = "vec3f()".to_owned();
    if of.period > 0 {
        before += &format!("    var tile = vec3f({:?});\n", of.period as f32);
        after += &format!("        tile *= {lacunarity:?};\n");
        tile = "tile".to_owned();
    }
    let mut step = format!("{lacunarity:?}");
    if of.rotation != 0.0 {
        before += &format!("    let step = {};\n", turned(of));
        step = "step".to_owned();
    }
    let weights = match of.method {
        NoiseMethod::Stationary => format!("fractal_stationary({filter}_lost(vec2f(1.41421356 * deviations.x)))"),
        NoiseMethod::Gradient | NoiseMethod::Curvature => format!("{filter}_filter(deviations)"),
    };
    format!(
        "    // Deviations of the footprint in cells of an octave.
    var deviations = footprint_deviations(vec3f(dot(across, across), dot(across, along), dot(along, along)));
    var sum = fractal_sum(0.0, 0.0, vec2f());
    var at = clamp(position, vec3f(-1e9), vec3f(1e9));
    var right = across;
    var down = along;
    var amplitude = 1.0;
{before}    for (var octave = 0u; octave < {octaves}u; octave++) {{
        let weights = {weights};
        if weights.x > {CUT:?} {{
            let n = {noise}_noise(at, {tile}, {seed}u + octave);
            sum = fractal_add(sum, amplitude, weights, n.x, vec2f(dot(right, n.yzw), dot(down, n.yzw)));
        }} else {{
            sum.rest += amplitude * amplitude; // nothing of it is left
        }}
        amplitude *= {gain:?};
        deviations *= {lacunarity:?};
        at = {step} * at + {OFFSET};
        right = {step} * right;
        down = {step} * down;
{after}    }}
    return fractal_statistics(sum, {mean:?}, {scale:?}, {variance:?});
"
    )
}

/// The matrix from an octave to the next: a turn about the diagonal of a cell, scaled by the lacunarity.
fn turned(of: &Noise) -> String {
    let (sin, cos) = f64::from(of.rotation).sin_cos();
    let (apart, mean) = (sin / 3f64.sqrt(), (1.0 - cos) / 3.0);
    let columns = [
        [cos + mean, mean + apart, mean - apart],
        [mean - apart, cos + mean, mean + apart],
        [mean + apart, mean - apart, cos + mean],
    ];
    let number = |part: f64| format!("{:?}", (f64::from(of.lacunarity) * part) as f32);
    let numbers: Vec<String> = columns.into_iter().flatten().map(number).collect();
    format!("mat3x3f({})", numbers.join(", "))
}
