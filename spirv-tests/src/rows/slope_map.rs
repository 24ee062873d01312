//! Maps of the whole slope: means by quadrature of the map over normal distributions of slopes.

use prefilter::gpu::Address;
use prefilter::reference::slope_map::Bilinear;
use prefilter::table::Table;
use prefilter::{Scene, SlopeDomain, SlopeMap, SlopeTaps, SlopeTier};

use super::footprint::stretched;
use super::rounds::ten;
use super::Row;
use crate::random::Random;

/// A random map of 2 × 2 cells, and its table.
fn map() -> (Bilinear, Table) {
    let mut random = Random::new(17);
    let texels: Vec<[f32; 4]> = (0..4).map(|_| [0, 1, 2, 3].map(|_| random.unit() as f32)).collect();
    let map = SlopeMap::from_texels(2, 1.0, &texels).expect("4 texels are a map");
    assert_eq!(map.domain(), SlopeDomain::Within(1.0));
    let scene = Scene::new("judged").slope_map(map.clone()).slope_tier(SlopeTier::Gaussian);
    let module = scene.slope_taps(SlopeTaps::One).module().expect("the scene is complete");
    (map.reference(), module.tables()[0].clone())
}

/// The functions of so many reads.
const NAMES: [&str; 6] =
    ["slope_map_one", "slope_map_three", "slope_map_five", "slope_map_seven", "slope_map_ten", "slope_map_eleven"];

/// The deviation of a slice: the largest, ½, is that of the last of 20, and a twelfth of it the logarithm's unit.
fn deviation(slice: f64) -> f64 {
    0.5 * (13f64.powf((20.0 * slice - 0.5) / 19.0) - 1.0) / 12.0
}

/// The sum of the means over two round distributions on either side of a mean.
fn both_sides(map: &Bilinear, [x, y]: [f64; 2], [away_x, away_y]: [f64; 2], deviation: f64) -> [f64; 4] {
    let variance = deviation * deviation;
    let of = |side: f64| map.mean([x + side * away_x, y + side * away_y], [variance, 0.0, variance]);
    let [one, other] = [-1.0, 1.0].map(of);
    [0, 1, 2, 3].map(|channel| one[channel] + other[channel])
}

pub(super) fn rows() -> Vec<Row> {
    let (map, table) = map();
    let reads = NAMES.map(|name| {
        let map = map.clone();
        Row::new(name, move |x| map.mean([x[0], x[1]], [x[2], x[3], x[4]])).table(table.clone(), Address::Clamp)
    });
    let (round, several) = (map.clone(), map.clone());
    let read = Row::new("slope_map_read", move |x| {
        let variance = deviation(x[2]).powi(2);
        round.mean([x[0], x[1]], [variance, 0.0, variance])
    });
    let sides = Row::new("slope_map_sides", move |x| both_sides(&map, [x[0], x[1]], [x[2], x[3]], deviation(x[4])));
    let pairs = Row::new("slope_map_pairs", move |x| {
        let [away_x, away_y, ..] = stretched([x[2], x[3], x[4]], x[5]);
        let [p, q, r, s, a, b, c, d, t, e] = ten(x[6]);
        [(p, a), (q, b), (r, c), (s, d), (t, e)].into_iter().fold([0.0; 4], |sum, (place, weight)| {
            let away = [place * away_x, place * away_y];
            let both = both_sides(&several, [x[0], x[1]], away, deviation(x[7]));
            [0, 1, 2, 3].map(|channel| sum[channel] + weight * both[channel])
        })
    });
    let reads = reads.into_iter().chain([read, sides, pairs].map(|row| row.table(table.clone(), Address::Clamp)));
    // The first of 20 slices has its center at ½/20.
    let slice = Row::new("slope_map_slice", |x| [0.025 + x[2] * (1.0 + x[1] * x[0]).log2()]);
    reads.chain([slice]).collect()
}
