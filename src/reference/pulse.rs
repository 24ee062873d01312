//! Steps, pulses and trains of pulses over a footprint, by quadrature over what is filled.

use super::normal::{density, REACH};
use super::quadrature::integrate;

/// The footprint along an axis: a kernel around a position that integrates to 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Footprint {
    /// A normal density of this deviation.
    Gaussian(f64),
    /// A constant over this width.
    Box(f64),
}

impl Footprint {
    /// How far the footprint reaches to both sides.
    fn reach(self) -> f64 {
        match self {
            Self::Gaussian(deviation) => REACH * deviation,
            Self::Box(width) => 0.5 * width,
        }
    }

    /// The footprint's share between two offsets from its center.
    pub fn share(self, from: f64, to: f64) -> f64 {
        let (from, to) = (from.max(-self.reach()), to.min(self.reach()));
        match self {
            Self::Gaussian(s) => integrate(from, to, 2.0 * s, |at| [density(at / s) / s])[0],
            Self::Box(width) => (to - from).max(0.0) / width,
        }
    }

    /// The mean of a pulse, 1 from `low` to `high` and 0 elsewhere.
    pub fn pulse(self, position: f64, low: f64, high: f64) -> f64 {
        self.share(low - position, high - position)
    }

    /// The mean of a step, 1 above `edge`.
    pub fn step(self, position: f64, edge: f64) -> f64 {
        self.pulse(position, edge, f64::INFINITY)
    }

    /// The mean of a train of pulses, 1 from every whole number on for the share `duty` of the period 1, at most all of
    /// it: every pulse that the footprint reaches.
    pub fn train(self, position: f64, duty: f64) -> f64 {
        let duty = duty.min(1.0);
        let [first, last] = [position - self.reach(), position + self.reach()].map(f64::floor);
        let pulses = (0..=(last - first) as u32).map(|pulse| first + f64::from(pulse));
        pulses.map(|start| self.pulse(position, start, start + duty)).sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The first waves of a train that is centered at 0: Fourier coefficients by quadrature over a pulse, fades by
    /// quadrature over the footprint.
    fn waves(position: f64, duty: f64, deviation: f64) -> f64 {
        let wave = |number: u32| {
            let turn = std::f64::consts::TAU * f64::from(number);
            let [coefficient] = integrate(0.0, 0.5 * duty, 0.05, |at| [4.0 * libm::cos(turn * at)]);
            let reach = REACH * deviation;
            let [faded] = integrate(-reach, reach, deviation.min(0.25 / f64::from(number)), |at| {
                [libm::cos(turn * (position + at)) * density(at / deviation) / deviation]
            });
            coefficient * faded
        };
        (1..=12).map(wave).sum()
    }

    /// By another way: the whole Fourier series.
    #[test]
    fn trains_are_their_series() {
        for (position, duty, deviation) in [(0.3, 0.5, 0.2), (-3.71, 0.03, 0.11), (12.9, 0.8, 0.4), (0.02, 1.0, 1.3)] {
            let direct = Footprint::Gaussian(deviation).train(position, duty);
            let series = duty + waves(position - 0.5 * duty, duty, deviation);
            assert!((direct - series).abs() < 1e-12, "{position} {duty} {deviation}: {direct} {series}");
        }
    }

    #[test]
    fn narrow_footprints_see_the_pulse_and_wide_ones_its_share() {
        for footprint in [Footprint::Gaussian(1e-6), Footprint::Box(1e-5)] {
            assert_eq!([0.1, 0.4, -0.9, 0.9].map(|at| footprint.train(at, 0.3).round()), [1.0, 0.0, 1.0, 0.0]);
            assert!((footprint.step(2.0, 2.0) - 0.5).abs() < 1e-12);
            assert!((footprint.train(7.3, 0.3) - 0.5).abs() < 1e-4);
        }
        assert!((Footprint::Gaussian(3.0).train(0.7, 0.3) - 0.3).abs() < 1e-12);
        assert!((Footprint::Box(3.0).train(0.7, 0.3) - 0.3).abs() < 1e-12);
    }
}
