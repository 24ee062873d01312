//! Simplex noise, by its definition: a sum over the points of a lattice of triangles.

use super::perlin::slope;

/// Where a lattice point stands: the lattice of triangles is that of whole numbers, shrunk along its diagonal by √3.
fn stands([i, j]: [i64; 2]) -> [f64; 2] {
    let (along, across) = ((i + j) as f64 / 2.0, (i - j) as f64 / 2.0);
    let shrunk = along / 3f64.sqrt();
    [shrunk + across, shrunk - across]
}

/// A lattice point's part of the noise at a distance from it.
pub fn part(away: [f64; 2], slope: [f64; 2]) -> f64 {
    let rest = 0.5 - away[0] * away[0] - away[1] * away[1];
    70.0 * rest.max(0.0).powi(4) * (slope[0] * away[0] + slope[1] * away[1])
}

/// All lattice points near a position, with how far it is from each.
pub fn around([x, y]: [f64; 2]) -> impl Iterator<Item = ([i64; 2], [f64; 2])> {
    // The inverse of `stands`.
    let (along, across) = ((x + y) * 3f64.sqrt() / 2.0, (x - y) / 2.0);
    let corner = [along + across, along - across].map(|whole| whole.round() as i64);
    let near = (-2..=2).flat_map(move |i| (-2..=2).map(move |j| [corner[0] + i, corner[1] + j]));
    near.map(move |place| {
        let stands = stands(place);
        (place, [x - stands[0], y - stands[1]])
    })
}

/// The noise: the sum over all lattice points near a position.
pub fn noise(position: [f64; 2], seed: u32) -> f64 {
    around(position).map(|(place, away)| part(away, slope(place, seed))).sum()
}
