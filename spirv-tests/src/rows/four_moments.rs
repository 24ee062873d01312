//! Four moments: mixtures of raw moments, and of the image's own texels without a pyramid.

use std::sync::Arc;

use prefilter::gpu::Address;
use prefilter::reference::four_moments::{about, central, from_standard, mixture, raw, Raw};
use prefilter::reference::moments::{Beyond, Image};
use prefilter::table::{Format, Table};
use prefilter::{Edge, FourMomentMipmap};

use super::moments::{cell_is_certain, plane_is_certain, values, SIZE};
use super::Row;

/// An image of a size that halves unevenly, with the raw moments of its texels.
struct Sample {
    image: Image,
    texels: Vec<Raw>,
    table: Table,
}

impl Sample {
    fn new(beyond: Beyond) -> Self {
        let [width, height] = SIZE;
        let edge = if beyond == Beyond::Repeat { Edge::Repeat } else { Edge::Clamp };
        let table = FourMomentMipmap::new(width as u32, height as u32, &values(), edge)
            .and_then(|moments| moments.table("image", Format::Rgba32Float))
            .expect("91 finite values are an image");
        let image = Image { width, height, values: values().into_iter().map(f64::from).collect(), beyond };
        let texels = (0..width * height).map(|at| image.raw_over_texel(at % width, at / width)).collect();
        Self { image, texels, table }
    }
}

/// Mean and central moments as numbers of a point.
pub(super) fn four(point: &[f64]) -> [f64; 4] {
    [point[0], point[1], point[2], point[3]]
}

/// Mean, variance, skewness and excess kurtosis, for kurtoses that a distribution can have.
pub(super) fn standard([mean, variance, third, fourth]: [f64; 4]) -> [f64; 4] {
    [mean, variance, third / variance.powf(1.5), fourth / variance.powi(2) - 3.0]
}

pub(super) fn rows() -> Vec<Row> {
    let mut rows = vec![
        Row::new("four_moments_central", |x| from_standard(four(x))),
        Row::new("four_moments_about", |x| {
            let [_, second, third, fourth] = about(raw(four(x)), x[4]);
            [second, third, fourth]
        }),
        Row::new("four_moments_pair", |x| central(mixture(&[(1.0 - x[8], raw(four(x))), (x[8], raw(four(&x[4..])))]))),
        Row::new("four_moments_standard", |x| standard(four(x))),
    ];
    for (beyond, address) in
        [(Beyond::Clamp, Address::Clamp), (Beyond::Repeat, Address::Repeat), (Beyond::Mirror, Address::Mirror)]
    {
        let sample = Arc::new(Sample::new(beyond));
        let table = || sample.table.clone();
        let [level, read] = [(); 2].map(|()| Arc::clone(&sample));
        rows.push(
            Row::new("four_moments_bilinear", move |x| {
                let most = level.image.kernels().len() - 1;
                level.image.level_four(&level.texels, [x[0], x[1]], (x[2] as usize).min(most))
            })
            .table(table(), address)
            .only_where(cell_is_certain),
        );
        let kernels = sample.image.kernels();
        let changes = kernels.iter().map(|&kernel| [0.3, 0.7, kernel, 0.1 * kernel, kernel]);
        rows.push(
            Row::new("four_moments_read", move |x| {
                read.image.read_four(&read.texels, [x[0], x[1]], [x[2], x[3], x[4]])
            })
            .table(table(), address)
            .only_where(plane_is_certain)
            .at(changes)
            .at([[0.3, 0.7, 0.0, 0.0, 0.0], [0.3, 0.7, 0.0625, 0.0, 0.0625], [0.3, 0.7, 1e6, 0.0, 1e6]]),
        );
    }
    rows
}
