//! Octaves of noise as heights with their slopes, in WGSL.

use super::noise::{Noise, Shelf};
use super::octaves::{Octave, CUT, OFFSET};
use super::taps::Taps;

impl Noise {
    /// The loop over octaves, which returns a `statistics_surface`.
    ///
    /// Octaves are turned and scaled alike along both axes, so that a footprint has the same axes in all of them; of
    /// these the loop carries the major one along.
    pub(super) fn surface(&self, slopes: f64) -> String {
        let Shelf { name, variance, .. } = self.basis.shelf();
        let Self { octaves, gain, lacunarity, .. } = *self;
        let [mean, scale] = self.placed();
        let Octave { noise, step, before, after } = self.octave(&format!("{name}_noise"));
        format!(
            "    // Deviations of the footprint in cells of an octave, and its major axis.
    var deviations = fractal_deviations(across, along);
    let major = footprint_direction(footprint_covariance_round(across, along, 1.0));
    var axis = major;
    var sum = fractal_surface(0.0, 0.0, vec2f(), vec2f(), vec2f());
    var at = clamp(position, vec2f(-1e9), vec2f(1e9));
    var amplitude = 1.0;
    // Variances of the octaves that are left, of heights and of slopes.
    var power = {power:?};
    var steep = {steep:?};
{before}    var octave = 0u;
    for (; octave < {octaves}u; octave++) {{
        let weights = {name}_filter(deviations);
        if weights.x < {CUT:?} {{
            break; // nothing is left of this octave and of those that follow
        }}
        let n = {noise};
        sum = fractal_tilt(sum, amplitude, weights, {name}_leveled(deviations), n, axis);
        power -= amplitude * amplitude;
        steep -= amplitude * amplitude * dot(axis, axis);
        amplitude *= {gain:?};
        deviations *= {lacunarity:?};
        at = {step} * at + {OFFSET};
        axis = {step} * axis;
{after}    }}
    if octave < {octaves}u {{
        sum.rest += power;
        sum.lost += steep;
    }}
    return fractal_slopes(sum, major, across, along, {mean:?}, {scale:?}, {variance:?}, {slopes:?});
",
            power = self.power() as f32,
            steep = self.steep() as f32,
        )
    }

    /// What no bound covers where slopes are filtered; `spirv-tests/tests/noise/slope_figures.rs` measures it again.
    pub(super) fn gap_of_slopes(&self) -> String {
        let [terrain, steps] = match self.taps {
            Taps::One => [0.049, 0.043],
            Taps::Two => [0.042, 0.037],
            Taps::Four => [0.037, 0.032],
            Taps::Eight => [0.031, 0.028],
        };
        format!(
            ".\n    By the slopes of such noise, all counted alike, it is {terrain:.3} and {steps:.3}; by the slope of \
             a point 0.297\n    and 0.313"
        )
    }

    /// The variance of the slopes of a sum of octaves along either axis, over that of the first octave.
    fn steep(&self) -> f64 {
        let growth = f64::from(self.gain) * f64::from(self.lacunarity);
        (0..self.octaves).map(|octave| growth.powi(2 * octave as i32)).sum()
    }
}
