//! Octaves of noise folded at 0.

use super::taps::Taps;

/// What becomes of every octave of a noise before they are summed, in the plane and by [`NoiseMethod::Gradient`].
///
/// [`NoiseMethod::Gradient`]: crate::NoiseMethod::Gradient
///
/// Root mean square errors of the color, in thousandths, for six octaves of Perlin's noise on a plane to the horizon,
/// under a terrain map and hard steps: with values taken for normal, by one to eight taps; for Beta distributions from
/// the fold to five deviations beyond the mean, by one tap; and of the naive map.
///
/// | noise, map | 1 tap | 2 taps | 4 taps | 8 taps | Beta, 1 tap | naive |
/// |---|---|---|---|---|---|---|
/// | turbulence, terrain | 52.9 | 39.4 | 24.9 | 16.6 | 52.1 | 185.8 |
/// | turbulence, steps6 | 64.2 | 48.2 | 32.6 | 23.4 | 61.6 | 249.1 |
/// | ridged, terrain | 55.8 | 41.8 | 27.0 | 18.2 | 54.7 | 177.3 |
/// | ridged, steps6 | 58.0 | 44.8 | 30.6 | 22.0 | 56.8 | 228.1 |
///
/// What limits the error is how little one point tells of its footprint, not the distribution: a table of
/// [`Distribution::Beta`](crate::Distribution::Beta) wins little, a second tap much.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum NoiseFold {
    /// Nothing.
    #[default]
    None,
    /// |n|: valleys with sharp floors.
    Turbulence,
    /// −|n|: hills with sharp ridges.
    Ridged,
}

impl NoiseFold {
    /// 1 where the folded octaves are added, −1 where they are taken off; nothing where they are not folded.
    pub(super) fn sign(self) -> Option<f64> {
        match self {
            Self::None => None,
            Self::Turbulence => Some(1.0),
            Self::Ridged => Some(-1.0),
        }
    }

    /// Of six octaves of Perlin's noise under terrain and hard steps, the error by taps and the naive map's.
    pub(super) fn errors(self, taps: Taps) -> [[f64; 2]; 2] {
        let of = |[one, two, four, eight]: [[f64; 2]; 4]| match taps {
            Taps::One => one,
            Taps::Two => two,
            Taps::Four => four,
            Taps::Eight => eight,
        };
        match self {
            Self::None => [of([[0.051, 0.058], [0.038, 0.043], [0.026, 0.030], [0.017, 0.021]]), [0.155, 0.216]],
            Self::Turbulence => [of([[0.053, 0.064], [0.039, 0.048], [0.025, 0.033], [0.017, 0.023]]), [0.186, 0.249]],
            Self::Ridged => [of([[0.056, 0.058], [0.042, 0.045], [0.027, 0.031], [0.018, 0.022]]), [0.177, 0.228]],
        }
    }
}

/// The statements that add an octave `n` whose derivatives along the footprint's vectors are `slope`: of all of it, and
/// of one of which nothing is left.
pub(super) fn added(slope: &str, variance: f64, share: f64) -> [String; 2] {
    let [mean, rest] = [share * variance.sqrt(), 1.0 - share * share];
    [
        format!(
            "let slope = {slope};
            let folded = fold_octave(weights, n.x, slope, {variance:?}, {share:?});
            sum = fractal_add(sum, amplitude, folded, 1.0, slope);"
        ),
        format!(
            "sum.mean += {:?} * amplitude; // nothing of it is left
            sum.rest += {:?} * amplitude * amplitude;",
            mean as f32, rest as f32
        ),
    ]
}
