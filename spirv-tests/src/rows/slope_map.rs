//! Maps of the whole slope: means by quadrature of the map over normal distributions of slopes.

use prefilter::gpu::Address;
use prefilter::reference::slope_map::Bilinear;
use prefilter::table::Table;
use prefilter::{Scene, SlopeDomain, SlopeMap, SlopeTaps, SlopeTier};

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
    ["slope_map_one", "slope_map_three", "slope_map_five", "slope_map_six", "slope_map_seven", "slope_map_nine"];

pub(super) fn rows() -> Vec<Row> {
    let (map, table) = map();
    let reads = NAMES.map(|name| {
        let map = map.clone();
        Row::new(name, move |x| map.mean([x[0], x[1]], [x[2], x[3], x[4]])).table(table.clone(), Address::Clamp)
    });
    let round = map.clone();
    let read = Row::new("slope_map_read", move |x| round.mean([x[0], x[1]], [x[2] * x[2], 0.0, x[2] * x[2]]));
    let sides = Row::new("slope_map_sides", move |x| {
        let (variance, two) = (x[4] * x[4], [-1.0, 1.0].map(|side| [x[0] + side * x[2], x[1] + side * x[3]]));
        let [one, other] = two.map(|mean| map.mean(mean, [variance, 0.0, variance]));
        [0, 1, 2, 3].map(|channel| one[channel] + other[channel])
    });
    reads.into_iter().chain([read, sides].map(|row| row.table(table.clone(), Address::Clamp))).collect()
}
