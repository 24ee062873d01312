//! The whole surface as a relief of bilinear cells.

use crate::imaging::relief::Relief;
use crate::imaging::waves::Waves;

/// Nodes a side of a period: the shortest wave has 21.
const NODES: usize = 2048;

/// The relief of a surface. Between nodes it differs from the waves by 0.0012 of the heights' deviation, RMS, as its
/// test measures.
pub fn relief(surface: &Waves) -> Relief {
    surface.relief(NODES, |height| height)
}

#[cfg(test)]
mod tests {
    use super::super::surface::surface;
    use super::*;
    use crate::random::Random;

    /// What the cells between nodes cost, in deviations of the heights.
    #[test]
    fn cells_are_near_the_waves() {
        let surface = surface(1);
        let relief = relief(&surface);
        let mut random = Random::new(7);
        let errors = (0..10_000).map(|_| {
            let place = [0, 1].map(|_| (4.0 * random.unit() - 2.0) * surface.period);
            relief.height(place) - surface.height(place)
        });
        let rms = (errors.map(|error| error * error).sum::<f64>() / 1e4).sqrt();
        println!("cells differ from the waves by {rms:.5} of the heights' deviation, RMS");
        assert!(rms < 0.0015, "{rms}");
    }
}
