//! The loop over the octaves of a noise, in WGSL.

use super::fold::{added, NoiseFold};
use super::noise::{Noise, NoiseMethod, Shelf};

/// Where an octave has the origin of the one before, 1/φ and √2 − 1: no lattice point of one is near one of another.
pub(super) const OFFSET: &str = "vec2f(0.618033989, 0.414213562)";

/// A word of a seed, to which octaves are added: of neighboring seeds they are far apart.
pub(super) fn apart(seed: u32) -> u32 {
    seed.wrapping_mul(0x9e37_79b1)
}

/// What the loop over octaves in the plane is made of, in WGSL.
pub(super) struct Octave {
    /// The call that gives the noise and its gradient, of `at` and `octave`.
    pub noise: String,
    /// The scalar or matrix from an octave to the next.
    pub step: String,
    /// Statements before the loop.
    pub before: String,
    /// Statements at the end of each turn.
    pub after: String,
}

impl Noise {
    /// The noise of an octave, of a function of the shelf, and its place, in the plane.
    pub(super) fn octave(&self, noise: &str) -> Octave {
        let Shelf { periodic, .. } = self.basis.shelf();
        let seed = apart(self.seed);
        let tile = if periodic { format!(", vec2f({:?})", self.period as f32) } else { String::new() };
        let tile = if self.period > 0 { ", tile".to_owned() } else { tile };
        let (mut before, mut after) = (String::new(), String::new());
        if self.period > 0 {
            before += &format!("    var tile = vec2f({:?});\n", self.period as f32);
            after += &format!("        tile *= {:?};\n", self.lacunarity);
        }
        let [step, _] = self.turned(1);
        if self.rotation != 0.0 {
            before += &format!("    let step = {step};\n");
        }
        let step = if self.rotation == 0.0 { step } else { "step".to_owned() };
        Octave { noise: format!("{noise}(at{tile}, {seed}u + octave)"), step, before, after }
    }

    /// The loop over octaves.
    pub(super) fn body(&self) -> String {
        let Shelf { name, variance, folded, .. } = self.basis.shelf();
        let Self { octaves, gain, lacunarity, .. } = *self;
        let [mean, scale] = self.placed();
        let Octave { noise, step, mut before, mut after } = self.octave(&format!("{name}_noise"));
        let weights = match self.method {
            NoiseMethod::Stationary => format!("fractal_stationary({name}_lost(vec2f(1.41421356 * deviations.x)))"),
            NoiseMethod::Gradient | NoiseMethod::Curvature => format!("{name}_filter(deviations)"),
        };
        let (octave, behind) = match self.fold {
            NoiseFold::None => self.straight(&noise, &mut before, &mut after),
            _ => {
                before += "    var right = across;\n    var down = along;\n";
                after += &format!("        right = {step} * right;\n        down = {step} * down;\n");
                (folded_octave(&noise, variance, folded), String::new())
            }
        };
        format!(
            "    // Deviations of the footprint in cells of an octave.
    var deviations = fractal_deviations(across, along);
    var sum = fractal_sum(0.0, 0.0, vec2f());
    var at = clamp(position, vec2f(-1e9), vec2f(1e9));
    var amplitude = 1.0;
{before}    var octave = 0u;
    for (; octave < {octaves}u; octave++) {{
        let weights = {weights};
{octave}        amplitude *= {gain:?};
        deviations *= {lacunarity:?};
        at = {step} * at + {OFFSET};
{after}    }}
{behind}    return fractal_statistics(sum, {mean:?}, {scale:?}, {variance:?});
"
        )
    }

    /// The statements that add an octave as it is, and those behind the loop; adds what stands before and after them.
    fn straight(&self, noise: &str, before: &mut String, after: &mut String) -> (String, String) {
        let octaves = self.octaves;
        let mut behind = format!("    sum.rest += select(0.0, power, octave < {octaves}u);\n");
        *before += &format!("    var power = {:?};\n", self.power() as f32);
        if self.method == NoiseMethod::Gradient {
            behind += &self.slopes_along(before, after);
        }
        let octave = format!(
            "        if weights.x < {CUT:?} {{
            break; // nothing is left of this octave and of those that follow
        }}
        let n = {noise};
        sum = fractal_add(sum, amplitude, weights, n.x, n.yz);
        power -= amplitude * amplitude;
"
        );
        (octave, behind)
    }

    /// The statements behind the loop that turn the sum's slopes to be along the footprint's vectors; adds what stands
    /// before it and at the end of each turn.
    pub(super) fn slopes_along(&self, before: &mut String, after: &mut String) -> String {
        let (octaves, [_, back], [last, _]) = (self.octaves, self.turned(1), self.turned(self.octaves as i32));
        *before += &format!("    let back = {back};\n");
        *after += "        sum.slope = back * sum.slope; // along the next octave's axes\n";
        format!(
            "    for (; octave < {octaves}u; octave++) {{
        sum.slope = back * sum.slope;
    }}
    let last = {last};
    sum.slope = vec2f(dot(last * across, sum.slope), dot(last * along, sum.slope));
"
        )
    }

    /// The variance of a sum of octaves whose noise has the variance 1.
    pub(super) fn power(&self) -> f64 {
        (0..self.octaves).map(|octave| f64::from(self.gain).powi(2 * octave as i32)).sum()
    }

    /// How vectors change over so many octaves, and gradients, as scalars or matrices: Mⁿ and its inverse transposed.
    fn turned(&self, octaves: i32) -> [String; 2] {
        let scale = f64::from(self.lacunarity).powi(octaves);
        let (sin, cos) = (f64::from(self.rotation) * f64::from(octaves)).sin_cos();
        [scale, 1.0 / scale].map(|scale| {
            let [cos, sin] = [cos * scale, sin * scale].map(|part| part as f32);
            match self.rotation {
                0.0 => format!("{:?}", scale as f32),
                _ => format!("mat2x2f({cos:?}, {sin:?}, {:?}, {cos:?})", -sin),
            }
        })
    }
}

/// The statements that add a folded octave, or what it has where nothing is left of it.
fn folded_octave(noise: &str, variance: f64, folded: f64) -> String {
    let [octave, lost] = added("vec2f(dot(right, n.yz), dot(down, n.yz))", variance, folded);
    format!(
        "        if weights.x > {CUT:?} {{
            let n = {noise};
            {octave}
        }} else {{
            {lost}
        }}
"
    )
}

/// The multiplier below which an octave is not evaluated: it would change the sum by a hundredth of its deviation.
pub(super) const CUT: f32 = 0.01;
