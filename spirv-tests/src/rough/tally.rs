//! Sums of squared errors, by what is judged and by how much of the surface a pixel resolves.

use super::judge::Look;
use crate::imaging::region::Region;

/// What is judged.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// The mean color of what is seen.
    Seen,
    /// The mean color of what is seen and lit, weighted by the share that is lit.
    Lit,
    /// That color times the share: the light that reaches the eye.
    Light,
    /// The share itself.
    Share,
}

impl Quantity {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Seen, Self::Lit, Self::Light, Self::Share];

    /// The name in tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::Seen => "seen",
            Self::Lit => "lit",
            Self::Light => "light",
            Self::Share => "share",
        }
    }
}

/// The share that must be lit for the mean color of what is lit to be judged.
const DARK: f64 = 0.05;

/// Sums of squared errors and of weights. An error is that of a pixel's worst channel.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Tally {
    /// By quantity and region.
    sums: [[[f64; 2]; 3]; 4],
}

impl Tally {
    /// Adds a pixel of which a share is lit in truth.
    pub fn add(&mut self, look: &Look, truth: &Look, share: f64, region: Region) {
        for (quantity, sums) in Quantity::ALL.into_iter().zip(&mut self.sums) {
            let (error, weight) = match quantity {
                Quantity::Seen => (worst(look.color, truth.color), 1.0),
                Quantity::Lit if share < DARK => continue,
                // A sample of the truth may have missed all that is lit.
                Quantity::Lit if look.share == 0.0 || truth.share == 0.0 => continue,
                Quantity::Lit => (worst(look.lit, truth.lit), share),
                Quantity::Light => (worst(look.lighted(), truth.lighted()), 1.0),
                Quantity::Share => (look.share - truth.share, 1.0),
            };
            let [squares, weights] = &mut sums[region as usize];
            *squares += weight * error * error;
            *weights += weight;
        }
    }

    /// The same with squares that are as many times larger.
    pub fn scaled(mut self, factor: f64) -> Self {
        self.sums.iter_mut().flatten().for_each(|sums| sums[0] *= factor);
        self
    }

    /// Root of the mean square over several tallies; of all pixels where no region is named. NaN for nothing.
    pub fn rms<'a>(tallies: impl IntoIterator<Item = &'a Self>, quantity: Quantity, region: Option<Region>) -> f64 {
        let (mut squares, mut weights) = (0.0, 0.0);
        for tally in tallies {
            let sums = tally.sums[quantity as usize];
            for of in Region::ALL.into_iter().filter(|of| region.is_none_or(|region| region == *of)) {
                squares += sums[of as usize][0];
                weights += sums[of as usize][1];
            }
        }
        (squares / weights).sqrt()
    }
}

/// The largest difference of a channel; NaN if any is.
fn worst(one: [f64; 3], other: [f64; 3]) -> f64 {
    let differences = one.iter().zip(other).map(|(one, other)| (one - other).abs());
    differences.fold(0.0, |worst, next| if worst >= next || worst.is_nan() { worst } else { next })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn errors_are_weighed_and_nothing_is_hidden() {
        let look = |color: f64, share: f64| Look { color: [color; 3], lit: [2.0 * color; 3], share };
        let mut tally = Tally::default();
        tally.add(&look(0.3, 0.5), &look(0.1, 0.5), 0.5, Region::Near);
        tally.add(&look(0.1, 1.0), &look(0.1, 0.0), 0.0, Region::Far);
        let rms = |quantity, region| Tally::rms([&tally], quantity, region);
        assert!((rms(Quantity::Seen, None) - 0.2 / 2f64.sqrt()).abs() < 1e-12);
        assert!((rms(Quantity::Lit, None) - 0.4).abs() < 1e-12);
        assert!((rms(Quantity::Light, Some(Region::Far)) - 0.2).abs() < 1e-12);
        assert!((rms(Quantity::Share, None) - 1.0 / 2f64.sqrt()).abs() < 1e-12);
        assert!(rms(Quantity::Lit, Some(Region::Far)).is_nan());
        tally.add(&look(f64::NAN, 0.5), &look(0.1, 0.5), 0.5, Region::Far);
        assert!(Tally::rms([&tally], Quantity::Seen, None).is_nan());
    }
}
