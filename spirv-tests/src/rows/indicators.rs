//! Shares above edges: levels of any numbers, mixed from their definition.

use std::sync::Arc;

use prefilter::gpu::Address;
use prefilter::reference::indicators::{at_level, kernels, read, Channels};
use prefilter::reference::moments::{Beyond, Image};
use prefilter::table::{Format, Level, Sampling, Table};

use super::moments::{off_centers, values, SIZE};
use super::Row;
use crate::random::Random;

/// Levels of random shares, each of its own.
fn levels(beyond: Beyond) -> Vec<Channels> {
    let mut random = Random::new(5);
    let [width, height] = SIZE;
    let mut level = |number: usize| {
        let (width, height) = ((width >> number).max(1), (height >> number).max(1));
        [(); 4].map(|()| {
            let values = (0..width * height).map(|_| random.unit()).collect();
            Image { width, height, values, beyond }
        })
    };
    (0..=width.ilog2() as usize).map(&mut level).collect()
}

fn table(levels: &[Channels]) -> Table {
    let level = |channels: &Channels| Level {
        width: channels[0].width as u32,
        height: channels[0].height as u32,
        depth: 1,
        texels: (0..channels[0].values.len())
            .flat_map(|at| [0, 1, 2, 3].map(|c| channels[c].values[at] as f32))
            .collect(),
    };
    let (name, format, sampling) = ("shares".into(), Format::Rgba32Float, Sampling::Loaded);
    Table { name, format, sampling, levels: levels.iter().map(level).collect(), error: 0.0 }
}

/// The image in the first channel.
fn image(beyond: Beyond) -> (Image, Table) {
    let [width, height] = SIZE;
    let texels = values().into_iter().flat_map(|value| [value, 0.0]).collect();
    let level = Level { width: width as u32, height: height as u32, depth: 1, texels };
    let (name, format, sampling) = ("image".into(), Format::Rg32Float, Sampling::Loaded);
    let table = Table { name, format, sampling, levels: vec![level], error: 0.0 };
    (Image { width, height, values: values().into_iter().map(f64::from).collect(), beyond }, table)
}

pub(super) fn rows() -> Vec<Row> {
    let mut rows = vec![Row::new("indicators_plane", |x| {
        let deviation = (0.5 * (x[0] + x[2])).max(0.0).sqrt();
        [1.0 - (libm::log(deviation / 0.25) / libm::log(2.0)).clamp(0.0, 1.0)]
    })];
    for (beyond, address) in [(Beyond::Clamp, Address::Clamp), (Beyond::Repeat, Address::Repeat)] {
        let levels = Arc::new(levels(beyond));
        let table = table(&levels);
        let [kernel, level, shares] = [(); 3].map(|()| Arc::clone(&levels));
        let last = levels.len() - 1;
        rows.push(
            Row::new("indicators_kernel", move |x| [kernels(&kernel)[(x[0] as usize).min(last)]])
                .table(table.clone(), address),
        );
        rows.push(
            Row::new("indicators_bilinear", move |x| at_level(&level[(x[2] as usize).min(last)], [x[0], x[1]]))
                .table(table.clone(), address),
        );
        rows.push(
            Row::new("indicators_shares", move |x| read(&shares, [x[0], x[1]], [x[2], x[3], x[4]]))
                .table(table, address)
                .at(kernels(&levels).into_iter().map(|kernel| [0.3, 0.7, kernel, 0.1 * kernel, kernel]))
                .at([[0.3, 0.7, 0.0, 0.0, 0.0], [0.3, 0.7, 1e6, 0.0, 1e6]]),
        );
        let (image, table) = image(beyond);
        rows.push(
            Row::new("indicators_value", move |x| {
                let at = [x[0] * SIZE[0] as f64, x[1] * SIZE[1] as f64];
                [image.value(at[0], at[1]), image.plane(at, [x[2], x[3], x[4]]).max(0.0).sqrt()]
            })
            .table(table, address)
            .only_where(off_centers),
        );
    }
    rows
}
