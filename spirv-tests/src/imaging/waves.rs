//! Sums of plane waves with random phases, and what a Gaussian footprint leaves of them.
//!
//! f(x) = Σ a cos(k·x + φ). Over a footprint of the covariance Σ a wave keeps the part exp(−½ kᵀΣk) of its amplitude.
//! What the footprint loses of it has the variance ½ a² (1 − exp(−kᵀΣk)), and slopes of that times k kᵀ.

use super::relief::Relief;
use crate::random::Random;
use std::f64::consts::{PI, TAU};

/// The part of an amplitude below which a wave counts as lost.
const LOST: f64 = 1e-2;

/// Steps of rays over filtered surfaces, in wavelengths of the root mean square wave number.
const STEP: f64 = 1.0 / 12.0;

/// Halvings of a step: 1e-3 of it are left.
const BISECTIONS: usize = 10;

/// A plane wave: whole periods along both axes of a period of the sum, amplitude and phase.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wave {
    /// Periods along both axes.
    pub periods: [i32; 2],
    /// The amplitude.
    pub amplitude: f64,
    /// The phase at the origin.
    pub phase: f64,
}

/// A function of mean 0.
#[derive(Clone, Debug, PartialEq)]
pub struct Waves {
    /// What it is the sum of.
    pub waves: Vec<Wave>,
    /// After how much ground it repeats, along both axes.
    pub period: f64,
}

/// How waves are spread.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spread {
    /// How many.
    pub count: usize,
    /// Waves that a period holds, the longest and the shortest.
    pub periods: [f64; 2],
    /// The power of the wave number by which amplitudes change.
    pub falling: f64,
}

impl Waves {
    /// Waves of variance 1 together, whose wave numbers are spread evenly in direction and in logarithm.
    pub fn new(spread: Spread, period: f64, seed: u32) -> Self {
        let mut random = Random::new(seed);
        let waves = (0..spread.count).map(|number| wave(number, spread, &mut random)).collect();
        let mut waves = Self { waves, period };
        let variance: f64 = waves.waves.iter().map(|wave| 0.5 * wave.amplitude.powi(2)).sum();
        waves.waves.iter_mut().for_each(|wave| wave.amplitude /= variance.sqrt());
        waves
    }

    /// The variance of slopes along an axis, the mean of both.
    pub fn slope_variance(&self) -> f64 {
        let [xx, _, yy] = self.filtered([1e9, 0.0, 1e9]).slope_covariance;
        0.5 * (xx + yy)
    }

    /// The relief whose heights over so many nodes a side of a period are a function of the sum.
    pub fn relief(&self, nodes: usize, height: impl Fn(f64) -> f64) -> Relief {
        let mut sums = vec![0.0; nodes * nodes];
        for wave in &self.waves {
            let table: Vec<f64> =
                (0..nodes).map(|node| wave.amplitude * (TAU * node as f64 / nodes as f64 + wave.phase).cos()).collect();
            let [across, down] = wave.periods.map(|count| count.rem_euclid(nodes as i32) as usize);
            for (row, sums) in sums.chunks_exact_mut(nodes).enumerate() {
                let mut at = row * down % nodes;
                for sum in sums {
                    *sum += table[at];
                    at = (at + across) % nodes;
                }
            }
        }
        let heights = sums.into_iter().map(|sum| height(sum) as f32).collect();
        Relief::new([nodes; 2], heights, [self.period / nodes as f64; 2])
    }

    /// The value at a place, which no footprint has filtered.
    pub fn height(&self, place: [f64; 2]) -> f64 {
        self.filtered([0.0; 3]).height(place)
    }

    /// The sum as a footprint of that covariance (xx, xy, yy) leaves it.
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

fn wave(number: usize, spread: Spread, random: &mut Random) -> Wave {
    let along = (number as f64 + random.unit()) / spread.count as f64;
    let length = spread.periods[0] * (spread.periods[1] / spread.periods[0]).powf(along);
    // Multiples of the golden section are spread evenly.
    let turn = PI * (number as f64 * 0.618_033_988_749_895 + 0.05 * random.unit());
    let periods = [turn.cos(), turn.sin()].map(|part| (length * part).round() as i32);
    Wave { periods, amplitude: length.powf(spread.falling), phase: TAU * random.unit() }
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

    const SPREAD: Spread = Spread { count: 128, periods: [6.0, 96.0], falling: -0.5 };

    fn waves(seed: u32) -> Waves {
        Waves::new(SPREAD, 180.0, seed)
    }

    #[test]
    fn heights_and_slopes_have_their_deviations() {
        let waves = waves(3);
        let all = waves.filtered([1e9, 0.0, 1e9]);
        assert!((all.variance - 1.0).abs() < 1e-9 && all.height([3.0, 4.0]) == 0.0);
        let [xx, _, yy] = all.slope_covariance;
        assert!((xx / yy).ln().abs() < 0.1, "directions are not even: {xx} {yy}");
        assert!((0.5 * (xx + yy) - waves.slope_variance()).abs() < 1e-12);
    }

    /// What stands at a node is a function of the sum there.
    #[test]
    fn reliefs_hold_the_sum() {
        let waves = waves(6);
        let relief = waves.relief(256, |sum| 2.0 - sum);
        for [column, row] in [[0, 0], [17, 200], [255, 3]] {
            let place = [column, row].map(|node| f64::from(node) * waves.period / 256.0);
            let (found, sum) = (relief.height(place), waves.height(place));
            assert!((found - (2.0 - sum)).abs() < 1e-5, "{place:?}: {found} {sum}");
        }
    }

    #[test]
    fn slopes_are_the_derivatives_of_heights() {
        let filtered = waves(2).filtered([0.3, 0.1, 0.2]);
        let (at, step) = ([12.3, -45.6], 1e-5);
        for (axis, slope) in filtered.slope(at).into_iter().enumerate() {
            let moved = |step: f64| filtered.height(std::array::from_fn(|a| at[a] + step * f64::from(a == axis)));
            assert!((slope - (moved(step) - moved(-step)) / (2.0 * step)).abs() < 1e-8);
        }
    }

    /// The mean and the variance over a footprint by sampling it, the variance in the mean over many places.
    #[test]
    fn a_footprint_keeps_its_mean_and_loses_the_rest() {
        let waves = waves(5);
        let (covariance, filtered) = ([1.5, 0.8, 0.9], waves.filtered([1.5, 0.8, 0.9]));
        let across = f64::sqrt(covariance[0]);
        let (lean, rest) = (covariance[1] / across, (covariance[2] - covariance[1].powi(2) / covariance[0]).sqrt());
        let unfiltered = waves.filtered([0.0; 3]);
        let mut random = Random::new(9);
        let (mut lost, places) = (0.0, 200);
        for place in 0..places {
            let middle = [random.unit() * waves.period, random.unit() * waves.period];
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
        let filtered = waves(4).filtered([0.1, 0.0, 0.1]);
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
