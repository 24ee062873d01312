//! The tabulated driver: mixtures of the image's own texels, without a pyramid.

use std::sync::Arc;

use prefilter::gpu::Address;
use prefilter::reference::moments::{Beyond, Image};
use prefilter::table::{Format, Table};
use prefilter::{Edge, MomentMipmap};

use super::Row;

/// An image of a size that halves unevenly, with the moments of its texels.
struct Sample {
    image: Image,
    texels: Vec<[f64; 2]>,
    table: Table,
}

/// Across and down; `near_center` knows them too.
pub(super) const SIZE: [usize; 2] = [13, 7];

/// Slopes, waves and noise in [0, 1].
pub(super) fn values() -> Vec<f32> {
    let [width, height] = SIZE;
    let value = |at: usize| {
        let (x, y) = (at % width, at / width);
        let noise = (at as u32).wrapping_mul(0x9e37_79b9).rotate_left(13).wrapping_mul(0x85eb_ca6b) >> 16;
        0.3 + 0.02 * x as f32 - 0.03 * y as f32 + 0.4 * (noise as f32 / 65_536.0)
    };
    (0..width * height).map(value).collect()
}

impl Sample {
    fn new(beyond: Beyond) -> Self {
        let [width, height] = SIZE;
        let edge = if beyond == Beyond::Repeat { Edge::Repeat } else { Edge::Clamp };
        let table = MomentMipmap::new(width as u32, height as u32, &values(), edge)
            .and_then(|moments| moments.table("image", Format::Rg32Float))
            .expect("91 finite values are an image");
        let image = Image { width, height, values: values().into_iter().map(f64::from).collect(), beyond };
        let texels = (0..width * height).map(|at| image.over_texel(at % width, at / width)).collect();
        Self { image, texels, table }
    }
}

/// Whether rounding can move a position (the first two numbers) over a center of one of the given numbers of texels.
fn near_center(point: &[f64], size: [usize; 2]) -> bool {
    let near = |at: f64| (at - at.round()).abs() < 1e-4;
    near(point[0] * size[0] as f64 - 0.5) || near(point[1] * size[1] as f64 - 0.5)
}

pub(super) fn cell_is_certain(point: &[f64]) -> bool {
    let level = point[2].clamp(0.0, 3.0) as usize;
    !near_center(point, SIZE.map(|size| (size >> level).max(1)))
}

/// Whether no rounding moves a position over a center of the image's texels.
pub(super) fn off_centers(point: &[f64]) -> bool {
    !near_center(point, SIZE)
}

/// The surface has an edge at the centers of the image's texels, which footprints below a texel see.
pub(super) fn plane_is_certain(point: &[f64]) -> bool {
    point[2] + point[4] >= 2.0 || !near_center(point, SIZE)
}

/// A cell as an image of four texels with the place of its fraction.
fn four(cell: &[f64]) -> (Image, [f64; 2]) {
    let image = Image { width: 2, height: 2, values: cell[..4].to_vec(), beyond: Beyond::Clamp };
    // On the far edge of the cell the next one begins.
    (image, [cell[8].min(1.0 - 1e-12) + 0.5, cell[9].min(1.0 - 1e-12) + 0.5])
}

/// Mean and variance from raw moments.
fn mixed(cell: &[f64]) -> [f64; 2] {
    let (image, [x, y]) = four(cell);
    let squares = (0..4).map(|at| cell[at] * cell[at] + cell[4 + at] * cell[4 + at]).collect();
    let mean = image.value(x, y);
    [mean, Image { values: squares, ..image }.value(x, y) - mean * mean]
}

pub(super) fn rows() -> Vec<Row> {
    let mut rows = vec![
        Row::new("moments_mixed", mixed),
        Row::new("moments_planar", |x| {
            let (image, position) = four(x);
            [image.plane(position, [x[10], x[11], x[12]])]
        }),
    ];
    for (beyond, address) in
        [(Beyond::Clamp, Address::Clamp), (Beyond::Repeat, Address::Repeat), (Beyond::Mirror, Address::Mirror)]
    {
        let sample = Arc::new(Sample::new(beyond));
        let table = || sample.table.clone();
        let [size, kernel, cell, read] = [(); 4].map(|()| Arc::clone(&sample));
        rows.push(
            Row::new("moments_size", move |x| {
                let level = (x[0] as usize).min(size.image.kernels().len() - 1);
                size.image.level(level).map(|parts| parts as f64)
            })
            .table(table(), address),
        );
        rows.push(
            Row::new("moments_kernel", move |x| {
                let kernels = kernel.image.kernels();
                [kernels[(x[0] as usize).min(kernels.len() - 1)]]
            })
            .table(table(), address),
        );
        rows.push(
            Row::new("moments_texels", move |x| {
                let level = (x[2] as usize).min(cell.image.kernels().len() - 1);
                cell.image.cell(&cell.texels, [x[0], x[1]], level)
            })
            .table(table(), address)
            .only_where(cell_is_certain),
        );
        let kernels = sample.image.kernels();
        let changes = kernels.iter().map(|&kernel| [0.3, 0.7, kernel, 0.1 * kernel, kernel]);
        rows.push(
            Row::new("moments_read", move |x| read.image.read(&read.texels, [x[0], x[1]], [x[2], x[3], x[4]]))
                .table(table(), address)
                .only_where(plane_is_certain)
                .at(changes)
                .at([[0.3, 0.7, 0.0, 0.0, 0.0], [0.3, 0.7, 0.0625, 0.0, 0.0625], [0.3, 0.7, 1e6, 0.0, 1e6]]),
        );
    }
    rows
}
