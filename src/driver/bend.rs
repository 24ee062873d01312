//! The loop over the octaves of a noise whose second derivatives are known, in WGSL.

use super::noise::{Noise, Shelf};
use super::octaves::{Octave, CUT, OFFSET};
use super::taps::Taps;

impl Noise {
    /// The loop over octaves.
    pub(super) fn bent_body(&self) -> String {
        let Shelf { name, variance, .. } = self.basis.shelf();
        let Self { octaves, gain, lacunarity, .. } = *self;
        let [mean, scale] = self.placed();
        let Octave { noise, step, mut before, mut after } = self.octave(&format!("bent_noise_{name}"));
        before += &format!("    let wider = {};\n    var power = {:?};\n", self.wider(), self.power() as f32);
        after += "        footprint = wider * footprint;\n";
        let behind = self.slopes_along(&mut before, &mut after);
        format!(
            "    // Deviations of the footprint in cells of an octave, and its covariance along the octave's axes.
    var deviations = fractal_deviations(across, along);
    var footprint = footprint_covariance_round(across, along, 1.0);
    var sum = bend_sum(0.0, 0.0, vec2f(), 0.0);
    var at = clamp(position, vec2f(-1e9), vec2f(1e9));
    var amplitude = 1.0;
{before}    var octave = 0u;
    for (; octave < {octaves}u; octave++) {{
        let weights = bent_noise_{name}_filter(deviations);
        if weights.multiplier < {CUT:?} {{
            break; // nothing is left of this octave and of those that follow
        }}
        let n = {noise};
        sum = bend_add(sum, amplitude, weights, n.noise, n.slope, n.bends, footprint);
        power -= amplitude * amplitude;
        amplitude *= {gain:?};
        deviations *= {lacunarity:?};
        at = {step} * at + {OFFSET};
{after}    }}
    sum.rest += select(0.0, power, octave < {octaves}u);
{behind}    return bend_statistics(sum, {mean:?}, {scale:?}, {variance:?});
"
        )
    }

    /// How a covariance xx, xy, yy changes from an octave's axes to the next one's.
    fn wider(&self) -> String {
        let square = f64::from(self.lacunarity).powi(2);
        let (sin, cos) = f64::from(self.rotation).sin_cos();
        if self.rotation == 0.0 {
            return format!("{:?}", square as f32);
        }
        let columns = [
            [cos * cos, sin * cos, sin * sin],
            [-2.0 * sin * cos, cos * cos - sin * sin, 2.0 * sin * cos],
            [sin * sin, -sin * cos, cos * cos],
        ];
        let parts = columns.into_iter().flatten().map(|part| format!("{:?}", (square * part) as f32));
        format!("mat3x3f({})", parts.collect::<Vec<_>>().join(", "))
    }
}

/// Of six octaves of Perlin's noise under terrain and hard steps, the error by taps.
pub(super) fn errors(taps: Taps) -> [f64; 2] {
    match taps {
        Taps::One => [0.039, 0.050],
        Taps::Two => [0.031, 0.037],
        Taps::Four => [0.021, 0.025],
        Taps::Eight => [0.014, 0.018],
    }
}
