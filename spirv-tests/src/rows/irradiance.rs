//! Irradiance over visible normals: frames by sums over indices, light by the sum over the sphere, cosines by
//! quadrature.

use prefilter::gpu::Address;
use prefilter::reference::irradiance::ramp;
use prefilter::reference::normals::of_slope;
use prefilter::table::{Format, Level, Sampling, Table};

use super::Row;

/// The index of each product of two components among means.
const PAIRS: [[usize; 3]; 3] = [[3, 4, 6], [4, 5, 7], [6, 7, 8]];

/// The means with every index turned: first 3, then the symmetric square by its entries.
fn turned(x: &[f64]) -> [f64; 9] {
    let frame = |row: usize, column: usize| x[9 + 3 * column + row];
    let entry = |i: usize, j: usize| x[PAIRS[i][j]];
    let first = |row: usize| (0..3).map(|i| frame(row, i) * x[i]).sum::<f64>();
    let square = |row: usize, column: usize| {
        let pairs = (0..9).map(|at| (at / 3, at % 3));
        pairs.map(|(i, j)| frame(row, i) * entry(i, j) * frame(column, j)).sum::<f64>()
    };
    let squares = [(0, 0), (0, 1), (1, 1), (0, 2), (1, 2), (2, 2)].map(|(row, column)| square(row, column));
    std::array::from_fn(|at| if at < 3 { first(at) } else { squares[at - 3] })
}

/// Three colors of a polynomial, uneven and of both signs.
fn polynomial() -> [[f32; 3]; 9] {
    std::array::from_fn(|term| [0, 1, 2].map(|channel| (0.7 + 1.9 * (3 * term + channel) as f32).sin()))
}

/// The polynomial of the means, a term at a time.
fn read(x: &[f64]) -> [f64; 3] {
    let terms = [1.0, x[0], x[1], x[2], x[3], x[4], x[5], x[6], x[7]];
    [0, 1, 2].map(|channel| {
        let sum: f64 = terms.iter().zip(polynomial()).map(|(term, color)| term * f64::from(color[channel])).sum();
        sum.max(0.0)
    })
}

fn lambert(x: &[f64]) -> [f64; 1] {
    let light = &x[9..12];
    let mean: f64 = (0..3).map(|i| x[i] * light[i]).sum();
    let pairs = (0..9).map(|at| (at / 3, at % 3));
    let square: f64 = pairs.map(|(i, j)| light[i] * x[PAIRS[i][j]] * light[j]).sum();
    [ramp(mean, (square - mean * mean).max(1e-12).sqrt())]
}

/// The means of a single normal, turned.
fn facet(x: &[f64]) -> [f64; 9] {
    turned(&[&of_slope([x[0], x[1]]), &x[2..]].concat())
}

pub(super) fn rows() -> Vec<Row> {
    let texels = polynomial().iter().flat_map(|&[red, green, blue]| [red, green, blue, 0.0]).collect();
    let levels = vec![Level { width: 9, height: 1, depth: 1, texels }];
    let (format, sampling) = (Format::Rgba32Float, Sampling::Loaded);
    let environment = Table { name: "environment".into(), format, sampling, levels, error: 0.0 };
    vec![
        Row::new("irradiance_turned", turned),
        Row::new("irradiance_read", read).table(environment, Address::Clamp),
        Row::new("irradiance_lambert", lambert),
        Row::new("irradiance_facet", facet),
        Row::new("irradiance_cosine", |x| {
            let normal = of_slope([x[0], x[1]]);
            [normal.iter().zip(&x[2..5]).map(|(n, l)| n * l).sum::<f64>().max(0.0)]
        }),
    ]
}
