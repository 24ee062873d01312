//! Slopes of transferred heights: a factor of two values times the slopes. Tables of moments: quadrature of the curves.

use prefilter::driver::transfer::{preconvolved, stage};
use prefilter::gpu::Address;
use prefilter::reference::piece::moments;
use prefilter::reference::transfer::slopes;
use prefilter::{HeightTransfer, Ranges};

use super::Row;

/// Moments of a curve over the normal variable whose mean and deviation the first two numbers are.
fn of(curve: &HeightTransfer, x: &[f64]) -> [f64; 4] {
    moments(&curve.bends(), |value| [curve.height(value), curve.slope(value)], x[0], x[1])
}

/// A row of `transfer_table` for eleven samples, in parts of half their ranges about the middles of these.
fn table() -> Row {
    let heights = [0.0, 0.3, 0.25, 0.6, 1.0, 0.7, 0.75, 0.9, 0.4, 0.1, 0.2];
    let curve = HeightTransfer::samples(0.0, 1.0, &heights).expect("eleven samples are a curve");
    let (_, table) = preconvolved("judged", &curve, &Ranges { mean: (-0.5, 1.5), deviation: 0.5 })
        .expect("heights and slopes of samples are small");
    let (least, steepest) = curve.slopes(f64::NEG_INFINITY, f64::INFINITY);
    let (middle, slope) = (0.5 * (least + steepest), 0.5 * (steepest - least));
    let parts = move |x: &[f64]| {
        let [height, variance, mean, spread] = of(&curve, x);
        [2.0 * height - 1.0, 4.0 * variance, (mean - middle) / slope, spread / (slope * slope)]
    };
    Row::new("transfer_table", parts).table(table, Address::Clamp)
}

fn power() -> Row {
    let curve = HeightTransfer::power(1.7).expect("powers from 1 on are curves");
    let (_, tables) = stage("judged", &curve);
    Row::new("transfer_power", move |x| of(&curve, x)).table(tables[0].clone(), Address::Clamp)
}

/// Nodes of Gauss and Hermite's rule of four, the roots of x⁴ − 6 x² + 3, with their weights.
fn rule() -> [[f64; 2]; 4] {
    let root = 6f64.sqrt();
    let node = |square: f64| [square.sqrt(), (6.0 - square) / 12.0];
    let [[near, more], [far, less]] = [node(3.0 - root), node(3.0 + root)];
    [[-far, less], [-near, more], [near, more], [far, less]]
}

/// The three functions of narrow footprints.
fn narrow() -> [Row; 3] {
    [
        Row::new("transfer_places", |x| rule().map(|[node, _]| x[0] + x[1] * node)),
        Row::new("transfer_cubic", |x| {
            std::array::from_fn::<f64, 4, _>(|at| (0..4).map(|power| x[4 + power] * x[at].powi(power as i32)).sum())
        }),
        Row::new("transfer_heights", |x| {
            let mean: f64 = rule().iter().zip(x).map(|([_, weight], height)| weight * height).sum();
            let square = |([_, weight], height): (&[f64; 2], &f64)| weight * (height - mean) * (height - mean);
            [mean, rule().iter().zip(x).map(square).sum::<f64>().sqrt()]
        }),
    ]
}

pub(super) fn rows() -> Vec<Row> {
    let surface = |x: &[f64]| {
        let [x_mean, y_mean, xx, xy, yy] = slopes([x[2], x[3]], [x[4], x[5]], [x[6], x[7], x[8]]);
        [x[0], x[1], 0.0, 0.0, x_mean, y_mean, xx, xy, yy]
    };
    [Row::new("transfer_surface", surface), table(), power()].into_iter().chain(narrow()).collect()
}
