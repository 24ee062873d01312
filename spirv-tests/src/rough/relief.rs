//! The whole surface as a relief of bilinear cells.

use super::surface::Surface;
use crate::imaging::relief::Relief;
use std::f64::consts::TAU;

/// Nodes a side of a period: the shortest wave has 21.
const NODES: usize = 2048;

/// The relief of a surface. Between nodes it differs from the waves by 0.0012 of the heights' deviation, RMS, as its
/// test measures.
pub fn relief(surface: &Surface) -> Relief {
    let mut heights = vec![0.0; NODES * NODES];
    for wave in &surface.waves {
        let table: Vec<f64> =
            (0..NODES).map(|node| wave.amplitude * (TAU * node as f64 / NODES as f64 + wave.phase).cos()).collect();
        let [across, down] = wave.periods.map(|count| count.rem_euclid(NODES as i32) as usize);
        for (row, nodes) in heights.chunks_exact_mut(NODES).enumerate() {
            let mut at = row * down % NODES;
            for height in nodes {
                *height += table[at];
                at = (at + across) % NODES;
            }
        }
    }
    let heights = heights.into_iter().map(|height| height as f32).collect();
    Relief::new([NODES; 2], heights, [surface.period / NODES as f64; 2])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Random;

    /// What the cells between nodes cost, in deviations of the heights.
    #[test]
    fn cells_are_near_the_waves() {
        let surface = Surface::new(1);
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
