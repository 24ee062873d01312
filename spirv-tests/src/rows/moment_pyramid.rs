//! Levels of a pyramid from levels: quadrature over the image, and mixtures of raw moments.

use prefilter::gpu::Address;
use prefilter::reference::four_moments::{central, from_standard, mixture, raw, Raw};
use prefilter::reference::moments::{Beyond, Image};
use prefilter::reference::quadrature::integrate;
use prefilter::table::{Format, Level, Sampling, Table};

use super::four_moments::{four, standard};
use super::moments::{values, SIZE};
use super::Row;

/// The image, and what is beyond it.
fn image(repeats: f64) -> Image {
    let beyond = if repeats == 0.0 { Beyond::Clamp } else { Beyond::Repeat };
    let [width, height] = SIZE;
    Image { width, height, values: values().into_iter().map(f64::from).collect(), beyond }
}

/// The image in the first of four channels, or moments in all of them: other texels for each channel.
fn table(moments: bool) -> Table {
    let [width, height] = SIZE;
    let values = values();
    let texel = |at: usize| {
        let of = |step: usize| values[(at + step) % values.len()];
        let shape = if moments { [0.5 * of(17), 4.0 * of(31) - 2.0, 3.0 * of(53)] } else { [0.0; 3] };
        [values[at], shape[0], shape[1], shape[2]]
    };
    let texels = (0..values.len()).flat_map(texel).collect();
    let level = Level { width: width as u32, height: height as u32, depth: 1, texels };
    let (name, format, sampling) = ("level".into(), Format::Rgba32Float, Sampling::Loaded);
    Table { name, format, sampling, levels: vec![level], error: 0.0 }
}

/// Raw moments of a row or column between two places, in texels.
fn between(texels: &[Raw], across: bool, line: usize, [from, to]: [f64; 2]) -> Raw {
    let [width, height] = SIZE;
    let (step, begin, length) = if across { (1, line * width, width) } else { (width, line, height) };
    let covered = |at: usize| (to.min(at as f64 + 1.0) - from.max(at as f64)).max(0.0) / (to - from);
    mixture(&(0..length).map(|at| (covered(at), texels[begin + at * step])).collect::<Vec<_>>())
}

pub(super) fn rows() -> Vec<Row> {
    let level = table(true);
    let texels =
        level.levels[0].texels.chunks(4).map(|texel| four(&texel.iter().map(|&v| f64::from(v)).collect::<Vec<_>>()));
    let texels: Vec<Raw> = texels.map(|texel| raw(from_standard(texel))).collect();
    vec![
        Row::new("moment_pyramid_value", |x| [image(x[2]).value(x[0] + 0.5, x[1] + 0.5)])
            .table(table(false), Address::Clamp),
        Row::new("moment_pyramid_quarter", |x| {
            let image = image(x[4]);
            let [left, top] = [x[0] + 0.5 * x[2], x[1] + 0.5 * x[3]];
            let center = image.value(x[0] + 0.5, x[1] + 0.5);
            let powers = |value: f64| [value, value.powi(2), value.powi(3), value.powi(4)];
            let row = |y: f64| integrate(left, left + 0.5, 0.5, |x| powers(image.value(x, y) - center));
            central(integrate(top, top + 0.5, 0.5, row).map(|sum| 4.0 * sum))
        })
        .table(table(false), Address::Clamp),
        Row::new("moment_pyramid_texel", |x| central(image(x[2]).raw_over_texel(x[0] as usize, x[1] as usize)))
            .table(table(false), Address::Clamp),
        Row::new("moment_pyramid_part", move |x| {
            let length = SIZE[usize::from(x[0] == 0.0)] as f64 / x[3];
            let part = between(&texels, x[0] != 0.0, x[1] as usize, [x[2] * length, (x[2] + 1.0) * length]);
            central(part)
        })
        .table(level, Address::Clamp),
        Row::new("moment_pyramid_stored", |x| {
            let [mean, variance, skewness, kurtosis] = standard(four(x));
            [mean, variance.sqrt(), skewness, kurtosis]
        }),
    ]
}
