//! Pyramids of slopes against the surfaces of their maps.

use prefilter::reference::moments::{Beyond, Image};
use prefilter::table::{Format, Level, Sampling};
use prefilter::{Edge, Error, SlopeMipmap};

use crate::{photograph, random};

/// Mean x and y and covariance xx, xy, yy of a texel.
fn moments(texel: &[f32]) -> [f64; 5] {
    let [x, y, first, cross, second] = [0, 1, 2, 3, 4].map(|channel| f64::from(texel[channel]));
    [x, y, first * first, first * cross, cross * cross + second * second]
}

/// Moments of all texels of a level together, from raw moments.
fn all(level: &Level) -> [f64; 5] {
    let count = f64::from(level.width * level.height);
    let mut sums = [0.0; 5];
    for [x, y, xx, xy, yy] in level.texels.chunks(5).map(moments) {
        sums.iter_mut().zip([x, y, xx + x * x, xy + x * y, yy + y * y]).for_each(|(sum, raw)| *sum += raw / count);
    }
    let [x, y, xx, xy, yy] = sums;
    [x, y, xx - x * x, xy - x * y, yy - y * y]
}

fn close(found: &[f64], expected: &[f64], within: f64) -> bool {
    found.len() == expected.len() && found.iter().zip(expected).all(|(a, b)| (a - b).abs() <= within)
}

/// Raw moments of a field of slopes over a texel, in 40² points.
fn over(field: &impl Fn(f64, f64) -> [f64; 2], x: u32, y: u32) -> [f64; 5] {
    let mut sums = [0.0; 5];
    for point in 0..1600 {
        let [u, v] =
            [(x, point % 40), (y, point / 40)].map(|(from, at)| f64::from(from) + (f64::from(at) + 0.5) / 40.0);
        let [u, v] = field(u, v);
        sums.iter_mut().zip([u, v, u * u, u * v, v * v]).for_each(|(sum, raw)| *sum += raw / 1600.0);
    }
    sums
}

/// Every texel of every level against points of the field in the texels of the map, by the area that it covers of each;
/// the field changes by as much as `change` along a texel.
fn holds_what_it_covers(pyramid: &SlopeMipmap, change: f64, field: impl Fn(f64, f64) -> [f64; 2]) {
    let [width, height] = [pyramid.levels()[0].width, pyramid.levels()[0].height];
    let texels: Vec<_> = (0..width * height).map(|at| (at % width, at / width)).collect();
    let raw: Vec<_> = texels.iter().map(|&(x, y)| over(&field, x, y)).collect();
    for (number, level) in pyramid.levels().iter().enumerate().skip(1) {
        assert_eq!([level.width, level.height], [width, height].map(|side| (side >> number).max(1)));
        for (at, texel) in level.texels.chunks(5).enumerate() {
            let covered = |place: u32, count: u32, size: u32, texel: u32| {
                let edge = |place: u32| f64::from(place * size) / f64::from(count);
                let (from, to) = (f64::from(texel).max(edge(place)), f64::from(texel + 1).min(edge(place + 1)));
                (to - from).max(0.0) * f64::from(count) / f64::from(size)
            };
            let mut sums = [0.0; 5];
            for (&(x, y), raw) in texels.iter().zip(&raw) {
                let across = covered(at as u32 % level.width, level.width, width, x);
                let weight = across * covered(at as u32 / level.width, level.height, height, y);
                sums.iter_mut().zip(raw).for_each(|(sum, raw)| *sum += weight * raw);
            }
            let [x, y, xx, xy, yy] = sums;
            let expected = [x, y, xx - x * x, xy - x * y, yy - y * y];
            // The midpoint rule in n = 40 points a texel misses d²/12n² of a variance, d the change over a texel.
            let within = change * change / (12.0 * 1600.0);
            assert!(
                close(&moments(texel), &expected, within),
                "{width}×{height} {number} {at}: {texel:?} {expected:?}"
            );
        }
    }
}

#[test]
fn every_texel_holds_the_moments_of_the_slopes_that_it_covers() {
    for (size, seed) in [([8, 4], 1), ([1, 9], 2), ([5, 7], 3)] {
        for (edge, beyond) in [(Edge::Clamp, Beyond::Clamp), (Edge::Repeat, Beyond::Repeat)] {
            let mut next = random(seed);
            let [width, height]: [usize; 2] = size;
            let slopes: Vec<[f32; 2]> = (0..width * height).map(|_| [next() as f32, next() as f32 - 0.5]).collect();
            let [x, y] = [0, 1].map(|axis| Image {
                width,
                height,
                values: slopes.iter().map(|slope| f64::from(slope[axis])).collect(),
                beyond,
            });
            let pyramid = SlopeMipmap::from_slopes(width as u32, height as u32, &slopes, edge).unwrap();
            let points = pyramid.levels()[0].texels.chunks(5).zip(&slopes);
            assert!(points.into_iter().all(|(texel, slope)| texel == [slope[0], slope[1], 0.0, 0.0, 0.0]));
            holds_what_it_covers(&pyramid, 1.0, |u, v| [x.value(u, v), y.value(u, v)]);
        }
    }
}

#[test]
fn every_texel_holds_the_moments_of_the_surface_that_it_covers() {
    for (size, seed) in [([8, 4], 4), ([6, 9], 5), ([4, 4], 6)] {
        let mut next = random(seed);
        let [width, height]: [usize; 2] = size;
        let heights: Vec<f32> = (0..width * height).map(|_| next() as f32).collect();
        let values = heights.iter().map(|&value| f64::from(value)).collect();
        let image = Image { width, height, values, beyond: Beyond::Repeat };
        // Differences over a part of a cell in which the points of 1/80 to 79/80 are.
        let h = 1e-4;
        let field = |x: f64, y: f64| {
            let across = image.value(x + h, y) - image.value(x - h, y);
            [across / (2.0 * h) / 0.5, (image.value(x, y + h) - image.value(x, y - h)) / (2.0 * h) / 0.5]
        };
        let pyramid = SlopeMipmap::from_heights(width as u32, height as u32, &heights, 0.5, Edge::Repeat).unwrap();
        holds_what_it_covers(&pyramid, 4.0, field);
    }
}

#[test]
fn a_plane_has_one_slope_and_no_covariance() {
    let heights: Vec<f32> = (0..13 * 7).map(|at| 0.25 * (at % 13) as f32 - 0.5 * (at / 13) as f32).collect();
    let plane = SlopeMipmap::from_heights(13, 7, &heights, 2.0, Edge::Clamp).unwrap();
    let normals = SlopeMipmap::from_normals(13, 7, &[[-0.25, 0.5, 2.0]; 91], Edge::Repeat).unwrap();
    for pyramid in [plane, normals] {
        assert_eq!((pyramid.levels().len(), pyramid.moments()), (4, ([0.125, -0.25], [0.0; 3])));
        for level in pyramid.levels() {
            assert!(level.texels.chunks(5).all(|texel| texel == [0.125, -0.25, 0.0, 0.0, 0.0]), "{level:?}");
        }
    }
    let texel = SlopeMipmap::from_heights(1, 1, &[3.0], 1.0, Edge::Clamp).unwrap();
    assert_eq!((texel.levels().len(), texel.moments()), (1, ([0.0; 2], [0.0; 3])));
}

#[test]
fn what_means_do_not_vary_covariances_hold() {
    // Crossed waves of 16 and 8 texels whose heights vary the slopes by a²k²/2 each, less what lines from texel to
    // texel lose: a chord over a texel has sinc²(k/2) of it, and mixing it with its neighbor's across does nothing.
    let tau = std::f64::consts::TAU;
    let (k, l) = (tau / 16.0, tau / 8.0);
    let wave = |at: usize| (2.0 * (k * (at % 64) as f64).sin() + (l * (at / 64) as f64).sin()) as f32;
    let heights: Vec<f32> = (0..64 * 32).map(wave).collect();
    let pyramid = SlopeMipmap::from_heights(64, 32, &heights, 1.0, Edge::Repeat).unwrap();
    let kept = |k: f64| ((0.5 * k).sin() / (0.5 * k)).powi(2);
    let expected = [0.0, 0.0, 2.0 * k * k * kept(k), 0.0, 0.5 * l * l * kept(l)];
    for level in &pyramid.levels()[1..] {
        assert!(close(&all(level), &expected, 1e-6), "{}: {:?} {expected:?}", level.width, all(level));
    }
    // Level 5 is two waves a texel: nothing is left to the means.
    assert!(pyramid.levels()[5].texels.chunks(5).all(|texel| close(&moments(texel), &expected, 1e-6)));

    let (image, stored) = photograph("gravel.png", Beyond::Repeat);
    let (width, height) = (image.width as u32, image.height as u32);
    for edge in [Edge::Clamp, Edge::Repeat] {
        let pyramid = SlopeMipmap::from_heights(width, height, &stored, 0.1, edge).unwrap();
        let (mean, covariance) = pyramid.moments();
        let whole = [mean.to_vec(), covariance.to_vec()].concat();
        let whole: Vec<f64> = whole.into_iter().map(f64::from).collect();
        println!("gravel {edge:?}: {whole:?}");
        for level in &pyramid.levels()[1..] {
            assert!(close(&all(level), &whole, 1e-6 * (whole[2] + whole[4])), "{}: {:?}", level.width, all(level));
        }
    }
}

#[test]
fn the_seams_of_repeated_maps_are_like_any_other_place() {
    let mut next = random(9);
    let heights: Vec<f32> = (0..64).map(|_| next() as f32).collect();
    let turned: Vec<f32> = (0..64).map(|at| heights[(at / 8 + 4) % 8 * 8 + (at % 8 + 2) % 8]).collect();
    let [here, there] = [&heights, &turned].map(|map| SlopeMipmap::from_heights(8, 8, map, 1.0, Edge::Repeat).unwrap());
    for (number, level) in here.levels().iter().enumerate().take(2) {
        let side = level.width as usize;
        let texel = |pyramid: &SlopeMipmap, x: usize, y: usize| {
            pyramid.levels()[number].texels[5 * (y % side * side + x % side)..][..5].to_vec()
        };
        for (x, y) in (0..side * side).map(|at| (at % side, at / side)) {
            assert_eq!(texel(&there, x, y), texel(&here, x + (2 >> number), y + (4 >> number)), "{number} {x} {y}");
        }
    }
}

#[test]
fn singular_covariances_are_covariances() {
    // Folds in one direction: all slopes on a line.
    for [x, y] in [[1.0, 0.0], [0.0, 1.0], [0.6, 0.8], [1e-3, -1.0], [1.0, 1e-6]] {
        let mut next = random(3);
        let slopes: Vec<[f32; 2]> = (0..64).map(|_| next() as f32 - 0.5).map(|at| [at * x, at * y]).collect();
        let pyramid = SlopeMipmap::from_slopes(8, 8, &slopes, Edge::Repeat).unwrap();
        for texel in pyramid.levels()[1..].iter().flat_map(|level| level.texels.chunks(5)) {
            let [_, _, xx, xy, yy] = moments(texel);
            // Slopes are rounded to f32, off the line by 2^-25 of them.
            let wanted = (xx + yy) * f64::from(x * y) / f64::from(x * x + y * y);
            assert!(texel.iter().all(|value| value.is_finite()) && texel[2] >= 0.0 && texel[4] >= 0.0);
            assert!((xy - wanted).abs() <= 1e-6 * (xx + yy), "{x} {y}: {texel:?}");
            assert!(xx * yy - xy * xy <= 1e-12 * (xx + yy).powi(2), "{x} {y}: {texel:?}");
        }
    }
}

#[test]
fn maps_that_are_none_are_refused() {
    for (width, height, count) in [(0, 4, 0), (4, 0, 0), (16_385, 1, 16_385), (2, 2, 3), (2, 2, 5)] {
        for error in [
            SlopeMipmap::from_slopes(width, height, &vec![[0.0; 2]; count], Edge::Clamp),
            SlopeMipmap::from_normals(width, height, &vec![[0.0, 0.0, 1.0]; count], Edge::Clamp),
            SlopeMipmap::from_heights(width, height, &vec![0.0; count], 1.0, Edge::Clamp),
        ] {
            assert!(matches!(error, Err(Error::Size { .. })), "{width}×{height} of {count}");
        }
    }
    let refused = |error: Result<SlopeMipmap, Error>, what: &str| {
        let error = error.unwrap_err();
        assert!(error.to_string().starts_with(what) && matches!(error, Error::Value { .. }), "{error}");
    };
    for value in [f32::NAN, f32::INFINITY, -2e15] {
        let slopes = [[0.0; 2], [0.0; 2], [0.0, value], [0.0; 2]];
        refused(SlopeMipmap::from_slopes(2, 2, &slopes, Edge::Clamp), "the slope at (0, 1) is");
        refused(SlopeMipmap::from_heights(2, 1, &[0.0, value], 1.0, Edge::Repeat), "the height at (1, 0) is");
    }
    refused(SlopeMipmap::from_heights(2, 1, &[0.0, 1e3], 1e-14, Edge::Clamp), "the slope at (0, 0) is");
    for size in [0.0, -1.0, f32::NAN, f32::INFINITY] {
        refused(SlopeMipmap::from_heights(1, 1, &[0.0], size, Edge::Clamp), "the texel's size is");
    }
    for z in [0.0, -1.0, f32::NAN] {
        refused(SlopeMipmap::from_normals(1, 1, &[[0.0, 0.0, z]], Edge::Clamp), "the normal's z at (0, 0) is");
    }
}

#[test]
fn tables_hold_means_and_factors() {
    let mut next = random(5);
    let slopes: Vec<[f32; 2]> = (0..64).map(|_| [next() as f32, next() as f32]).collect();
    let pyramid = SlopeMipmap::from_slopes(8, 8, &slopes, Edge::Repeat).unwrap();
    let [wide, cross] = pyramid.tables("rock", Format::Rgba32Float).unwrap();
    assert_eq!((wide.name.as_str(), wide.sampling, wide.error), ("rock", Sampling::Loaded, 0.0));
    assert_eq!((cross.name.as_str(), cross.format, cross.error), ("rock_cross", Format::Rg32Float, 0.0));
    for ((level, four), two) in pyramid.levels().iter().zip(&wide.levels).zip(&cross.levels) {
        let texels = level.texels.chunks(5).zip(four.texels.chunks(4)).zip(two.texels.chunks(2));
        for ((texel, four), two) in texels {
            assert_eq!((four, two), (&[texel[0], texel[1], texel[2], texel[4]][..], &[texel[3], 0.0][..]));
        }
    }
    let [narrow, cross] = pyramid.tables("rock", Format::Rgba16Float).unwrap();
    assert_eq!((cross.format, narrow.bytes() + cross.bytes()), (Format::Rg16Float, 85 * 12));
    assert!(narrow.error > 1e-5 && narrow.error <= 2f32.powi(-12) && cross.error <= 2f32.powi(-12));
    for format in [Format::Rg32Float, Format::Rg16Float] {
        assert!(matches!(pyramid.tables("rock", format), Err(Error::Conflict(_))));
    }
    let steep = SlopeMipmap::from_slopes(1, 1, &[[0.0, -7e4]], Edge::Clamp).unwrap();
    assert!(matches!(steep.tables("steep", Format::Rgba16Float), Err(Error::Value { .. })));
}
