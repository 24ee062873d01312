//! Mean and covariance of slopes: mixtures of the map's own texels, without a pyramid.

use std::sync::Arc;

use prefilter::gpu::Address;
use prefilter::reference::moments::{Beyond, Image};
use prefilter::reference::slope_moments::Slopes;
use prefilter::table::{Format, Table};
use prefilter::{Edge, SlopeMipmap};

use super::moments::{cell_is_certain, SIZE};
use super::Row;

/// Waves and noise in [-1, 1], y of which goes along with x in part.
fn values() -> Vec<[f32; 2]> {
    let noise = |at: usize| (at as u32).wrapping_mul(0x9e37_79b9).rotate_left(13).wrapping_mul(0x85eb_ca6b) >> 16;
    let unit = |at: usize| noise(at) as f32 / 65_536.0;
    let value = |at: usize| {
        let x = 0.02 * (at % SIZE[0]) as f32 - 0.6 + 0.9 * unit(at);
        [x, 0.3 - 0.5 * x + 0.6 * (unit(at + 500) - 0.5)]
    };
    (0..SIZE[0] * SIZE[1]).map(value).collect()
}

fn sample(beyond: Beyond) -> (Slopes, [Table; 2]) {
    let [width, height] = SIZE;
    let edge = if beyond == Beyond::Repeat { Edge::Repeat } else { Edge::Clamp };
    let tables = SlopeMipmap::from_slopes(width as u32, height as u32, &values(), edge)
        .and_then(|slopes| slopes.tables("slopes", Format::Rgba32Float))
        .expect("91 finite slopes are a map");
    let [x, y] = [0, 1].map(|axis| {
        let values = values().into_iter().map(|slope| f64::from(slope[axis])).collect();
        Image { width, height, values, beyond }
    });
    (Slopes::new(x, y), tables)
}

/// Mean and covariance from raw moments of a cell.
fn mixed(cell: &[f64]) -> [f64; 5] {
    // On the far edge of the cell the next one begins.
    let [x, y] = [20, 21].map(|at| cell[at].min(1.0 - 1e-12) + 0.5);
    let of = |value: &dyn Fn(usize) -> f64| {
        let values = (0..4).map(value).collect();
        Image { width: 2, height: 2, values, beyond: Beyond::Clamp }.value(x, y)
    };
    let part = |number: usize, at: usize| cell[4 * number + at];
    let [u, v] = [0, 1].map(|axis| of(&|at| part(axis, at)));
    let xx = of(&|at| part(0, at).powi(2) + part(2, at).powi(2));
    let xy = of(&|at| part(0, at) * part(1, at) + part(2, at) * part(3, at));
    let yy = of(&|at| part(1, at).powi(2) + part(3, at).powi(2) + part(4, at).powi(2));
    [u, v, xx - u * u, xy - u * v, yy - v * v]
}

pub(super) fn rows() -> Vec<Row> {
    let mut rows = vec![Row::new("slope_moments_mixed", mixed)];
    for (beyond, address) in
        [(Beyond::Clamp, Address::Clamp), (Beyond::Repeat, Address::Repeat), (Beyond::Mirror, Address::Mirror)]
    {
        let (slopes, [four, two]) = sample(beyond);
        let kernels = slopes.image().kernels();
        let last = kernels.len() - 1;
        let changes = kernels.into_iter().map(|kernel| [0.3, 0.7, kernel, 0.1 * kernel, kernel]);
        let [cell, read] = [Arc::new(slopes.clone()), Arc::new(slopes)];
        rows.push(
            Row::new("slope_moments_texels", move |x| cell.cell([x[0], x[1]], (x[2] as usize).min(last)))
                .table(four.clone(), address)
                .table(two.clone(), address)
                .only_where(cell_is_certain),
        );
        rows.push(
            Row::new("slope_moments_read", move |x| read.read([x[0], x[1]], [x[2], x[3], x[4]]))
                .table(four, address)
                .table(two, address)
                .at(changes)
                .at([[0.3, 0.7, 0.0, 0.0, 0.0], [0.3, 0.7, 1e6, 0.0, 1e6]]),
        );
    }
    rows
}
