//! Means over the lengths of slopes, by quadrature.

use prefilter::gpu::Address;
use prefilter::reference::slopes::Visible;
use prefilter::reference::steepness::mean;
use prefilter::{ColorMap, Colors, Ranges, Scene, SlopeTaps, SlopeTier};

use super::Row;

pub(super) fn rows() -> Vec<Row> {
    let map = ColorMap::gradient([(0.2, [0.1, 0.9, 0.2, 0.0]), (0.9, [0.8, 0.1, 0.5, 1.0])]).expect("a ramp is a map");
    let ranges = Ranges { mean: (0.0, 1.0), deviation: 0.32 };
    // Of dynamic colors, whose axes do not depend on the map: the contract can name them.
    let scene = Scene::new("judged").steepness(map.clone()).colors(Colors::Dynamic).ranges(ranges);
    let table = |scene: Scene| scene.module().expect("the ranges are those of the contract").tables()[0].clone();
    let [three, ten] = [scene.clone().slope_taps(SlopeTaps::Three), scene.slope_tier(SlopeTier::Pair)].map(table);
    let map = map.reference();
    let lengths = map.clone();
    let seen = move |x: &[f64]| {
        mean(&lengths, &Visible { view: [x[0], x[1], x[2]], mean: [x[3], x[4]], covariance: [x[5], x[6], x[7]] })
    };
    let reference = move |x: &[f64]| {
        let (mean_slope, covariance) = ([x[0], x[1]], [x[2], x[3], x[4]]);
        mean(&map, &Visible { view: [0.0, 0.0, 1.0], covariance, mean: mean_slope })
    };
    vec![
        Row::new("rice_five", reference).table(ten, Address::Clamp),
        Row::new("rice_three", seen).table(three, Address::Clamp),
    ]
}
