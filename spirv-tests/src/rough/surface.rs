//! A rough surface: a sum of plane waves with random phases, and what a Gaussian footprint leaves of it.
//!
//! h(x) = Σ a cos(k·x + φ). Over a footprint of the covariance Σ a wave keeps the part exp(−½ kᵀΣk) of its amplitude.
//! What the footprint loses of it has the variance ½ a² (1 − exp(−kᵀΣk)), and slopes of that times k kᵀ.
//! Heights are in units of their deviation, and so is the ground.

use crate::random::Random;
use std::f64::consts::{PI, TAU};

/// Waves of a surface: enough for heights near normal.
const WAVES: usize = 128;

/// Waves that a period of the surface holds, the longest and the shortest.
const PERIODS: [f64; 2] = [6.0, 96.0];

/// Deviation of slopes along either axis, about: masking and shadowing matter, and overhangs do not.
pub const SLOPE_DEVIATION: f64 = 0.6;

/// The part of an amplitude below which a wave counts as lost.
const LOST: f64 = 1e-2;

/// Steps of rays over filtered surfaces, in wavelengths of the root mean square wave number.
const STEP: f64 = 1.0 / 12.0;

/// Halvings of a step: 1e-3 of it are left.
const BISECTIONS: usize = 10;

/// A plane wave: whole periods along both axes of a period of the surface, amplitude and phase.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wave {
    /// Periods along both axes.
    pub periods: [i32; 2],
    /// The amplitude.
    pub amplitude: f64,
    /// The phase at the origin.
    pub phase: f64,
}

/// Heights of mean 0 and variance 1.
#[derive(Clone, Debug, PartialEq)]
pub struct Surface {
    /// What they are the sum of.
    pub waves: Vec<Wave>,
    /// After how much ground they repeat, along both axes.
    pub period: f64,
}

impl Surface {
    /// The surface of a seed: wave numbers are spread evenly in direction and in logarithm, and variances fall with
    /// them, so that the density of variance over plane wave vectors falls with their third power as of many reliefs.
    pub fn new(seed: u32) -> Self {
        let mut random = Random::new(seed);
        let mut waves: Vec<Wave> = (0..WAVES).map(|number| wave(number, &mut random)).collect();
        let sum = |of: &dyn Fn(&Wave) -> f64| waves.iter().map(|wave| 0.5 * wave.amplitude.powi(2) * of(wave)).sum();
        let variance: f64 = sum(&|_| 1.0);
        let squares: f64 = sum(&|wave| wave.periods.iter().map(|&count| f64::from(count).powi(2)).sum());
        let period = TAU * (0.5 * squares / variance).sqrt() / SLOPE_DEVIATION;
        waves.iter_mut().for_each(|wave| wave.amplitude /= variance.sqrt());
        Self { waves, period }
    }

    /// The height over a place, which no footprint has filtered.
    pub fn height(&self, place: [f64; 2]) -> f64 {
        self.filtered([0.0; 3]).height(place)
    }

    /// The surface as a footprint of that covariance (xx, xy, yy) leaves it.
    pub fn filtered(&self, footprint: [f64; 3]) -> Filtered {
        let mut filtered = Filtered { waves: Vec::new(), variance: 0.0, slope_covariance: [0.0; 3] };
        for wave in &self.waves {
            let [x, y] = wave.periods.map(|count| TAU * f64::from(count) / self.period);
            let spread = x * x * footprint[0] + 2.0 * x * y * footprint[1] + y * y * footprint[2];
            let lost = -0.5 * wave.amplitude.powi(2) * (-spread).exp_m1();
            filtered.variance += lost;
            for (total, square) in filtered.slope_covariance.iter_mut().zip([x * x, x * y, y * y]) {
                *total += lost * square;
            }
            let kept = (-0.5 * spread).exp();
            if kept > LOST {
                filtered.waves.push(Plane { number: [x, y], amplitude: wave.amplitude * kept, phase: wave.phase });
            }
        }
        filtered
    }
}

fn wave(number: usize, random: &mut Random) -> Wave {
    let along = (number as f64 + random.unit()) / WAVES as f64;
    let length = PERIODS[0] * (PERIODS[1] / PERIODS[0]).powf(along);
    // Multiples of the golden section are spread evenly.
    let turn = PI * (number as f64 * 0.618_033_988_749_895 + 0.05 * random.unit());
    let periods = [turn.cos(), turn.sin()].map(|part| (length * part).round() as i32);
    Wave { periods, amplitude: length.powf(-0.5), phase: TAU * random.unit() }
}

/// A wave on the ground: its wave vector, amplitude and phase.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Plane {
    number: [f64; 2],
    amplitude: f64,
    phase: f64,
}

/// What a footprint leaves, and the statistics of what it loses.
#[derive(Clone, Debug, PartialEq)]
pub struct Filtered {
    waves: Vec<Plane>,
    /// Variance of the heights that are lost.
    pub variance: f64,
    /// Covariance of the slopes that are lost: xx, xy, yy.
    pub slope_covariance: [f64; 3],
}

impl Filtered {
    /// The height over a place.
    pub fn height(&self, place: [f64; 2]) -> f64 {
        self.waves.iter().map(|wave| wave.amplitude * wave.phase_at(place).cos()).sum()
    }

    /// The slopes there.
    pub fn slope(&self, place: [f64; 2]) -> [f64; 2] {
        let mut slope = [0.0; 2];
        for wave in &self.waves {
            let sine = wave.phase_at(place).sin();
            slope.iter_mut().zip(wave.number).for_each(|(sum, number)| *sum -= wave.amplitude * number * sine);
        }
        slope
    }

    /// Where a ray first comes to the surface, as a multiple of its way; none where it does not before it is above or
    /// below everything.
    pub fn hit(&self, from: [f64; 3], way: [f64; 3]) -> Option<f64> {
        let [mut above, mut below] = self.passage(from, way)?;
        for _ in 0..BISECTIONS {
            let middle = 0.5 * (above + below);
            let [x, y, height] = [0, 1, 2].map(|axis| from[axis] + middle * way[axis]);
            if height > self.height([x, y]) {
                above = middle;
            } else {
                below = middle;
            }
        }
        Some(0.5 * (above + below))
    }

    /// Two places on a ray, above the surface and not, between which it first comes to it.
    ///
    /// Of what lies between two steps only the ends are looked at. From step to step every wave turns by one angle.
    pub fn passage(&self, from: [f64; 3], way: [f64; 3]) -> Option<[f64; 2]> {
        let reach = 4.5 * self.sum(|_| 1.0).sqrt() + 1e-3;
        let [low, high] = [-reach, reach].map(|level| (level - from[2]) / way[2]);
        let (start, end) = (low.min(high).max(0.0), low.max(high));
        let square = self.sum(|wave| wave.number[0].powi(2) + wave.number[1].powi(2)) / self.sum(|_| 1.0).max(1e-9);
        let step = (STEP * TAU / square.sqrt().max(1e-9) / way[0].hypot(way[1]).max(1e-9)).min(end - start);
        let turning = |wave: &Plane| {
            let phase = wave.phase_at([0, 1].map(|axis| from[axis] + start * way[axis]));
            let turn = step * (wave.number[0] * way[0] + wave.number[1] * way[1]);
            let ((sine, cosine), (by_sine, by_cosine)) = (phase.sin_cos(), turn.sin_cos());
            [wave.amplitude * cosine, wave.amplitude * sine, by_cosine, by_sine]
        };
        let mut turning: Vec<[f64; 4]> = self.waves.iter().map(turning).collect();
        for count in 1..=((end - start) / step).ceil() as usize {
            let mut height = 0.0;
            for [real, imaginary, cosine, sine] in &mut turning {
                [*real, *imaginary] = [*real * *cosine - *imaginary * *sine, *imaginary * *cosine + *real * *sine];
                height += *real;
            }
            let after = start + count as f64 * step;
            if from[2] + after * way[2] <= height {
                return Some([after - step, after]);
            }
        }
        None
    }

    /// A sum over the waves, weighted by their variance.
    fn sum(&self, of: impl Fn(&Plane) -> f64) -> f64 {
        self.waves.iter().map(|wave| 0.5 * wave.amplitude.powi(2) * of(wave)).sum()
    }
}

impl Plane {
    fn phase_at(&self, [x, y]: [f64; 2]) -> f64 {
        self.number[0] * x + self.number[1] * y + self.phase
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn heights_and_slopes_have_their_deviations() {
        let surface = Surface::new(3);
        let all = surface.filtered([1e9, 0.0, 1e9]);
        assert!((all.variance - 1.0).abs() < 1e-9 && all.height([3.0, 4.0]) == 0.0);
        let [xx, _, yy] = all.slope_covariance;
        assert!((xx + yy - 2.0 * SLOPE_DEVIATION.powi(2)).abs() < 1e-9, "{xx} {yy}");
        assert!((xx / yy).ln().abs() < 0.1, "directions are not even: {xx} {yy}");
    }

    #[test]
    fn slopes_are_the_derivatives_of_heights() {
        let filtered = Surface::new(2).filtered([0.3, 0.1, 0.2]);
        let (at, step) = ([12.3, -45.6], 1e-5);
        for (axis, slope) in filtered.slope(at).into_iter().enumerate() {
            let moved = |step: f64| filtered.height(std::array::from_fn(|a| at[a] + step * f64::from(a == axis)));
            assert!((slope - (moved(step) - moved(-step)) / (2.0 * step)).abs() < 1e-8);
        }
    }

    /// The mean and the variance over a footprint by sampling it, the variance in the mean over many places.
    #[test]
    fn a_footprint_keeps_its_mean_and_loses_the_rest() {
        let surface = Surface::new(5);
        let (covariance, filtered) = ([1.5, 0.8, 0.9], surface.filtered([1.5, 0.8, 0.9]));
        let across = f64::sqrt(covariance[0]);
        let (lean, rest) = (covariance[1] / across, (covariance[2] - covariance[1].powi(2) / covariance[0]).sqrt());
        let unfiltered = surface.filtered([0.0; 3]);
        let mut random = Random::new(9);
        let (mut lost, places) = (0.0, 200);
        for place in 0..places {
            let middle = [random.unit() * surface.period, random.unit() * surface.period];
            let (mut sum, mut squares, mut weights) = (0.0, 0.0, 0.0);
            // Trapezoids over 6 deviations are exact for such waves.
            for index in 0..25 * 25 {
                let [u, v] = [index % 25, index / 25].map(|step| 0.5 * (step as f64 - 12.0));
                let weight = (-0.5 * (u * u + v * v)).exp();
                let height = unfiltered.height([middle[0] + across * u, middle[1] + lean * u + rest * v]);
                (sum, squares, weights) = (sum + weight * height, squares + weight * height * height, weights + weight);
            }
            let mean = sum / weights;
            assert!((mean - filtered.height(middle)).abs() < 0.03, "{place}: {mean} {}", filtered.height(middle));
            lost += (squares / weights - mean * mean) / f64::from(places);
        }
        assert!((lost / filtered.variance - 1.0).abs() < 0.1, "{lost} {}", filtered.variance);
    }

    #[test]
    fn rays_end_on_the_filtered_surface() {
        let filtered = Surface::new(4).filtered([0.1, 0.0, 0.1]);
        for number in 0..50 {
            let turn = 0.1 + f64::from(number);
            let way = [turn.cos(), turn.sin(), -0.3];
            let from = [20.0 * turn, -30.0, 9.0];
            let Some(along) = filtered.hit(from, way) else { panic!("ray {number} passes the ground") };
            let [x, y, z] = [0, 1, 2].map(|axis| from[axis] + along * way[axis]);
            assert!((z - filtered.height([x, y])).abs() < 3e-3, "{number}: {z} {}", filtered.height([x, y]));
        }
    }
}
