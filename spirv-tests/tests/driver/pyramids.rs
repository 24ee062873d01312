//! Pyramids against the texels of their image.

use prefilter::reference::moments::{Beyond, Image};
use prefilter::table::{Format, Sampling};
use prefilter::{ColorMap, Edge, Error, MomentMipmap, Scene, Tier};

use crate::{photograph, random};

/// Mean and deviation of the part of the image that one texel of a level covers, texel by texel of the image.
fn covered(image: &Image, moments: &[[f64; 2]], size: [usize; 2], texel: [usize; 2]) -> [f64; 2] {
    let side = |texel: usize, count: usize, size: usize, at: usize| {
        let (from, to) = ((texel * size) as f64 / count as f64, ((texel + 1) * size) as f64 / count as f64);
        (to.min(at as f64 + 1.0) - from.max(at as f64)).max(0.0)
    };
    let (mut area, mut sum, mut squares) = (0.0, 0.0, 0.0);
    for y in 0..image.height {
        for x in 0..image.width {
            let weight = side(texel[0], size[0], image.width, x) * side(texel[1], size[1], image.height, y);
            let [mean, variance] = moments[y * image.width + x];
            area += weight;
            sum += weight * mean;
            squares += weight * (variance + mean * mean);
        }
    }
    let mean = sum / area;
    [mean, (squares / area - mean * mean).max(0.0).sqrt()]
}

#[test]
fn scenes_accept_the_ranges_of_every_image() {
    let map = ColorMap::gradient([(0.0, [0.1, 0.2, 0.3]), (1.0, [0.9, 0.8, 0.7])]).unwrap();
    for (low, high) in [(0.0, 0.0), (0.7, 0.7), (-3.0, 8.5), (65504.0, 65504.0), (-65504.0, -65504.0), (0.5, 0.5005)] {
        let ranges = MomentMipmap::new(2, 1, &[low, high], Edge::Clamp).unwrap().ranges();
        assert!(ranges.mean.0 <= low && high <= ranges.mean.1 && 0.5 * (high - low) <= ranges.deviation);
        let scene = Scene::new("driven").texture(map.clone()).tier(Tier::Naive).ranges(ranges);
        assert!(scene.module().is_ok(), "{low} {high}: {ranges:?}");
    }
}

#[test]
fn every_texel_holds_the_moments_of_what_it_covers() {
    for (size, seed) in [([1, 1], 1), ([1, 9], 2), ([13, 7], 3), ([16, 8], 4), ([37, 23], 5), ([2, 31], 6)] {
        for (edge, beyond) in [(Edge::Clamp, Beyond::Clamp), (Edge::Repeat, Beyond::Repeat)] {
            let mut next = random(seed);
            let [width, height]: [usize; 2] = size;
            let stored: Vec<f32> = (0..width * height).map(|_| next() as f32 - 0.25).collect();
            let values = stored.iter().map(|&value| f64::from(value)).collect();
            let image = Image { width, height, values, beyond };
            let texels: Vec<_> = (0..width * height).map(|at| image.over_texel(at % width, at / width)).collect();
            let pyramid = MomentMipmap::new(width as u32, height as u32, &stored, edge).unwrap();
            let levels = pyramid.levels();
            assert_eq!(levels.len(), 1 + size.iter().max().unwrap().ilog2() as usize);
            assert!(levels[0].texels.chunks(2).zip(&stored).all(|(texel, value)| texel == [*value, 0.0]));
            for (number, level) in levels.iter().enumerate().skip(1) {
                let parts = [level.width, level.height].map(|side| side as usize);
                assert_eq!(parts, size.map(|side| (side >> number).max(1)));
                for (at, texel) in level.texels.chunks(2).enumerate() {
                    let expected = covered(&image, &texels, parts, [at % parts[0], at / parts[0]]);
                    for (value, expected) in texel.iter().zip(expected) {
                        // Half an ulp of values up to 1, and 1e-8 for the deviation of 0 by raw moments.
                        assert!((f64::from(*value) - expected).abs() <= 6e-8, "{size:?} {number} {at}: {texel:?}");
                    }
                }
            }
        }
    }
}

#[test]
fn the_mean_of_every_level_is_the_mean_of_the_image() {
    for name in ["gravel.png", "jacksboro_dem.png"] {
        let (image, stored) = photograph(name, Beyond::Clamp);
        let mean = image.values.iter().sum::<f64>() / image.values.len() as f64;
        let (width, height) = (image.width as u32, image.height as u32);
        for edge in [Edge::Clamp, Edge::Repeat] {
            let pyramid = MomentMipmap::new(width, height, &stored, edge).unwrap();
            for level in pyramid.levels() {
                let texels = level.texels.chunks(2).map(|texel| f64::from(texel[0]));
                let found = texels.sum::<f64>() / f64::from(level.width * level.height);
                assert!((found - mean).abs() < 6e-8, "{name} {edge:?} {}: {found} {mean}", level.width);
            }
        }
    }
}

#[test]
fn a_constant_image_has_no_deviation() {
    for value in [0.1, -3e7, 1e15, 0.0] {
        let pyramid = MomentMipmap::new(13, 7, &[value; 91], Edge::Clamp).unwrap();
        for level in pyramid.levels() {
            assert!(level.texels.chunks(2).all(|texel| texel == [value, 0.0]), "{value}: {level:?}");
        }
        assert_eq!((pyramid.range(), pyramid.largest_deviation()), ((value, value), 0.0));
    }
}

#[test]
fn images_that_are_none_are_refused() {
    let new = |width, height, values: &[f32]| MomentMipmap::new(width, height, values, Edge::Clamp).unwrap_err();
    for (width, height, count) in [(0, 4, 0), (4, 0, 0), (16_385, 1, 16_385), (2, 2, 3), (2, 2, 5)] {
        let error = new(width, height, &vec![0.5; count]);
        assert!(matches!(error, Error::Size { .. }), "{width}×{height} of {count}: {error}");
    }
    for value in [f32::NAN, f32::INFINITY, -2e15] {
        let error = new(2, 2, &[0.0, 0.0, value, 0.0]);
        assert!(error.to_string().starts_with("the image's value at (0, 1) is"), "{error}");
    }
}

#[test]
fn a_table_states_what_its_format_costs() {
    let stored: Vec<f32> = (0..64).map(|at| (at * at) as f32 / 4096.0).collect();
    let pyramid = MomentMipmap::new(8, 8, &stored, Edge::Repeat).unwrap();
    let wide = pyramid.table("squares", Format::Rg32Float).unwrap();
    assert_eq!((wide.error, wide.sampling, wide.levels.as_slice()), (0.0, Sampling::Loaded, pyramid.levels()));
    let narrow = pyramid.table("squares", Format::Rg16Float).unwrap();
    assert!(narrow.error > 1e-5 && narrow.error <= 2f32.powi(-12), "{}", narrow.error);
    let four = pyramid.table("squares", Format::Rgba32Float).unwrap();
    assert_eq!(four.levels[3].texels, [wide.levels[3].texels[0], wide.levels[3].texels[1], 0.0, 0.0]);
    let high = MomentMipmap::new(1, 1, &[7e4], Edge::Clamp).unwrap();
    assert!(matches!(high.table("high", Format::Rg16Float), Err(Error::Value { .. })));
}
