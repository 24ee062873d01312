//! Maps of the whole slope: means by quadrature of the map over normal distributions of slopes, and the sums of round
//! distributions with the least largest error of a step, by exchange.

use std::sync::OnceLock;

use prefilter::gpu::Address;
use prefilter::reference::slope_map::rounds::nearest;
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

/// Between nodes linearly, which leaves 1e-5: each node starts from the one before.
struct Nearest<const N: usize> {
    from: f64,
    step: f64,
    nodes: Vec<[f64; N]>,
}

impl<const N: usize> Nearest<N> {
    /// Down from a part for which a sum is known.
    fn new(from: f64, step: f64, count: usize, start: [f64; N]) -> Self {
        let mut last = start;
        let node = |index: usize| {
            last = nearest(from - step * index as f64, last);
            last
        };
        Self { from, step, nodes: (0..count).map(node).collect() }
    }

    /// The places as multiples of z a, and the weights.
    fn at(&self, part: f64) -> [f64; N] {
        let along = ((self.from - part) / self.step).clamp(0.0, self.nodes.len() as f64 - 1.001);
        let (index, share) = (along as usize, along.fract());
        let z = (1.0 - part * part).sqrt();
        std::array::from_fn(|number| {
            let value = (1.0 - share) * self.nodes[index][number] + share * self.nodes[index + 1][number];
            value / if number < N / 2 { z } else { 1.0 }
        })
    }
}

pub(super) fn rows() -> Vec<Row> {
    static SIDES: OnceLock<Nearest<2>> = OnceLock::new();
    static ARMS: OnceLock<Nearest<4>> = OnceLock::new();
    let (map, table) = map();
    let reads = ["slope_map_one", "slope_map_three", "slope_map_five"].map(|name| {
        let map = map.clone();
        Row::new(name, move |x| map.mean([x[0], x[1]], [x[2], x[3], x[4]])).table(table.clone(), Address::Clamp)
    });
    let round = map.clone();
    let read = Row::new("slope_map_read", move |x| round.mean([x[0], x[1]], [x[2] * x[2], 0.0, x[2] * x[2]]));
    let rows = [
        read.table(table.clone(), Address::Clamp),
        Row::new("slope_map_sides", |x| SIDES.get_or_init(|| Nearest::new(0.6, 0.004, 80, [1.18, 0.219])).at(x[0])),
        Row::new("slope_map_arms", |x| {
            ARMS.get_or_init(|| Nearest::new(0.36, 0.002, 110, [0.846, 1.82, 0.249, 0.074])).at(x[0])
        }),
    ];
    rows.into_iter().chain(reads).collect()
}
