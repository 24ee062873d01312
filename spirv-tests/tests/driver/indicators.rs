//! Shares of bands: pyramids against counts along lines, colors against the means of what the pyramid covers, and
//! question 3 beside the normal distributions of the moments' driver.

use prefilter::gpu::{Address, Device, Kernel, Texture, Work};
use prefilter::reference::indicators::{at_level, kernels, Channels};
use prefilter::reference::moments::{Beyond, Image};
use prefilter::table::{Format, Level};
use prefilter::{ColorMap, Driver, Edge, Error, IndicatorMipmap, Indicators, Kernel as Form, Scene, Taps, Tier};
use spirv_tests::maps;

use crate::colors::{rms, Case, SEEDS, TAPS};
use crate::footprints::footprints;
use crate::{documented, photograph, random};

const DOCUMENTATION: &str = include_str!("../../../src/driver/indicators.rs");

const EDGES: [f32; 5] = [0.137, 0.311, 0.47, 0.62, 0.853];

fn noise([width, height]: [usize; 2], seed: u32, beyond: Beyond) -> (Image, Vec<f32>) {
    let mut next = random(seed);
    let stored: Vec<f32> = (0..width * height).map(|_| next() as f32).collect();
    let values = stored.iter().map(|&value| f64::from(value)).collect();
    (Image { width, height, values, beyond }, stored)
}

/// The channels of a level of both textures of shares.
fn shares(tables: &[prefilter::Table], number: usize) -> (&Level, Vec<[f32; 8]>) {
    let [first, second] = [&tables[1].levels[number], &tables[2].levels[number]];
    let both = first.texels.chunks(4).zip(second.texels.chunks(4));
    (first, both.map(|(a, b)| [a[0], a[1], a[2], a[3], b[0], b[1], b[2], b[3]]).collect())
}

#[test]
fn every_texel_holds_the_shares_of_what_it_covers() {
    const LINES: usize = 256;
    for (size, seed) in [([1, 1], 1), ([1, 9], 2), ([7, 4], 3), ([8, 8], 4), ([6, 11], 5)] {
        for (edge, beyond) in [(Edge::Clamp, Beyond::Clamp), (Edge::Repeat, Beyond::Repeat)] {
            let (image, stored) = noise(size, seed, beyond);
            let (width, height) = (size[0] as u32, size[1] as u32);
            let pyramid = IndicatorMipmap::new(width, height, &stored, edge, &EDGES).unwrap();
            let tables = pyramid.tables(Format::Rgba32Float).unwrap();
            let (_, found) = shares(&tables, 0);
            let mut whole = [0.0; 5];
            for (at, found) in found.iter().enumerate() {
                for (number, &value) in EDGES.iter().enumerate() {
                    let expected = image.above_over_texel(at % size[0], at / size[0], f64::from(value), LINES);
                    // Two lines of a half texel for each crossing: at most a column's width times what a share varies
                    // over a quarter, twice 1 in each of four; and by the middle of columns half of it.
                    let bound = 0.5 / (2 * LINES) as f64 * 4.0;
                    let apart = f64::from(found[number]) - expected;
                    assert!(apart.abs() < bound, "{size:?} {at} {value}: {} {expected}", found[number]);
                    whole[number] += f64::from(found[number]) / stored.len() as f64;
                }
                assert_eq!(found[5..], [0.0; 3]);
            }
            for (found, expected) in pyramid.shares().iter().zip(whole) {
                assert!((f64::from(*found) - expected).abs() < 1e-6, "{size:?}: {found} {expected}");
            }
            for number in 0..tables[1].levels.len() {
                // Every level has the shares of the image.
                let (level, found) = shares(&tables, number);
                assert_eq!([level.width, level.height], [width, height].map(|side| (side >> number).max(1)));
                for edge in 0..5 {
                    let mean = found.iter().map(|shares| f64::from(shares[edge])).sum::<f64>() / found.len() as f64;
                    assert!((mean - whole[edge]).abs() < 1e-6, "{size:?} {number} {edge}");
                }
            }
        }
    }
}

#[test]
fn pyramids_of_shares_refuse_what_is_none() {
    let new = |edges: &[f32]| IndicatorMipmap::new(2, 1, &[0.0, 1.0], Edge::Clamp, edges);
    assert!(matches!(new(&[]), Err(Error::Size { .. })));
    assert!(matches!(new(&[0.1; 9]), Err(Error::Size { .. })));
    for edges in [[0.5, 0.5], [0.5, 0.4], [f32::NAN, 0.5], [0.5, f32::INFINITY]] {
        assert!(matches!(new(&edges), Err(Error::Value { .. })), "{edges:?}");
    }
    let pyramid = new(&[0.5]).unwrap();
    assert!(matches!(pyramid.tables(Format::Rg16Float), Err(Error::Conflict(_))));
    assert_eq!(pyramid.tables(Format::Rgba16Float).unwrap().len(), 2);
    // Values at an edge are below it.
    let level = IndicatorMipmap::new(3, 1, &[0.5, 0.5, 0.5], Edge::Clamp, &[0.5]).unwrap();
    assert_eq!(level.shares(), [0.0]);
    let ramp = ColorMap::gradient([(0.0, [0.0; 3]), (1.0, [1.0; 3])]).unwrap();
    let bands = ColorMap::bands([0.0; 3], (1..10).map(|edge| (edge as f32, [0.1 * edge as f32; 3]))).unwrap();
    assert_eq!((ramp.edges(), bands.edges().map(|edges| edges.len())), (None, Some(9)));
    for map in [ramp, bands] {
        let scene = Scene::new("strata").texture(map).driver(Driver::Indicators(Indicators::default()));
        let refused = scene.module().unwrap_err();
        assert!(refused.to_string().contains("shares of a map of two to nine bands"), "{refused}");
    }
}

const ENTRY: &str = "
@group(0) @binding(0) var<storage, read_write> output: array<f32>;
@group(0) @binding(1) var<storage, read> points: array<array<f32, 6>>;
@group(1) @binding(0) var image: texture_2d<f32>;
@group(1) @binding(1) var image_sampler: sampler;
@group(1) @binding(2) var shares: texture_2d<f32>;
@group(1) @binding(3) var shares_sampler: sampler;
@group(1) @binding(4) var further: texture_2d<f32>;
@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= arrayLength(&points) { return; }
    let p = points[id.x];
    let color = rock_color(vec2f(p[0], p[1]), vec2f(p[2], p[3]), vec2f(p[4], p[5]), image, image_sampler, shares, \
                     further, shares_sampler);
    for (var channel = 0u; channel < 3u; channel++) { output[3u * id.x + channel] = color[channel]; }
}";

fn kernel(device: &Device, map: &ColorMap, taps: Taps) -> Kernel {
    let driver = Driver::Indicators(Indicators { taps, ..Indicators::default() });
    let scene = Scene::new("rock").texture(map.clone()).tier(Tier::ClosedForm(Form::Exact)).driver(driver);
    Kernel::new(device, scene.module().unwrap().link(ENTRY).unwrap().wgsl(), "main").unwrap()
}

fn textures(device: &Device, image: &Image, stored: &[f32], map: &ColorMap, format: Format) -> Vec<Texture> {
    let edges = map.edges().unwrap();
    let pyramid = IndicatorMipmap::new(image.width as u32, image.height as u32, stored, Edge::Repeat, &edges).unwrap();
    let tables = pyramid.tables(format).unwrap();
    tables.iter().map(|table| device.upload(table, Address::Repeat).unwrap()).collect()
}

/// Round footprints whose kernel is that of one level: the color is the mean of the image's colors over that kernel.
#[test]
fn colors_are_those_of_the_image_under_the_pyramids_kernel() {
    let device = Device::new().unwrap();
    let map = maps::named("steps6").unwrap();
    let size = [12, 6];
    let (image, stored) = noise(size, 8, Beyond::Repeat);
    let textures = textures(&device, &image, &stored, &map, Format::Rgba32Float);
    let kernel = kernel(&device, &map, Taps::One);
    // The colors of the image over its texels, by counting; a level from them by its own texels' areas.
    let colors: Vec<[f64; 3]> = (0..72).map(|at| color_over(&image, &map, [at % 12, at / 12])).collect();
    // Of the third level texels are no squares any more.
    for width in [1usize, 2] {
        let [w, h] = size.map(|side| side / width);
        let mean = |x: usize, y: usize, channel: usize| {
            let texels = (0..width * width).map(|at| colors[(y * width + at / width) * 12 + x * width + at % width]);
            texels.map(|color| color[channel]).sum::<f64>() / (width * width) as f64
        };
        let level: Channels = [0, 1, 2, 0].map(|channel| {
            let values = (0..w * h).map(|at| mean(at % w, at / w, channel)).collect();
            Image { width: w, height: h, values, beyond: Beyond::Repeat }
        });
        let mut next = random(3);
        let deviation = 0.5 * width as f64;
        assert_eq!(kernels(std::slice::from_ref(&level)), [0.25]);
        for _ in 0..50 {
            let at = [next(), next()];
            // A pixel's deviation is half a pixel.
            let steps = [2.0 * deviation / 12.0, 0.0, 0.0, 2.0 * deviation / 6.0];
            let point: Vec<f32> = at.iter().chain(&steps).map(|&number| number as f32).collect();
            let bound: Vec<&Texture> = textures.iter().collect();
            let work = Work { inputs: &[&point], textures: &bound, invocations: 1, output: 3 };
            let found = kernel.run(&work).unwrap();
            let expected = at_level(&level, at);
            for (found, expected) in found.iter().zip(expected) {
                // Counting along 512 columns errs by up to 1/256 of an edge's share.
                assert!((f64::from(*found) - expected).abs() < 2e-3, "{width} {at:?}: {found} {expected}");
            }
        }
    }
}

/// The mean color over a texel's area, of colors at 512 × 512 points of it.
fn color_over(image: &Image, map: &ColorMap, [x, y]: [usize; 2]) -> [f64; 3] {
    const SIDE: usize = 512;
    let reference = map.reference();
    let mut sum = [0.0; 3];
    for at in 0..SIDE * SIDE {
        let [u, v] = [at % SIDE, at / SIDE].map(|step| (step as f64 + 0.5) / SIDE as f64);
        let color = reference.value(image.value(x as f64 + u, y as f64 + v));
        (0..3).for_each(|channel| sum[channel] += color[channel] / (SIDE * SIDE) as f64);
    }
    sum
}

#[test]
fn shares_of_bands_are_nearer_than_normal_distributions() {
    let device = Device::new().unwrap();
    println!("RMS × 1e-3 over positions, directions and minor deviations 0.15, 0.6, 2.5 texels, six hard steps");
    for file in ["gravel.png", "brick.png"] {
        let map = maps::named("steps6").unwrap();
        let (image, stored) = photograph(file, Beyond::Repeat);
        let textures = textures(&device, &image, &stored, &map, Format::Rgba16Float);
        let shares = Case {
            image,
            textures,
            kernels: TAPS.map(|taps| kernel(&device, &map, taps)).into(),
            map: map.reference(),
        };
        let normal = Case::new(&device, file, "steps6");
        let mut squares = [0.0; 6];
        for aspect in [1.0, 4.0, 16.0] {
            let found = [&shares, &normal].map(|case| {
                let errors =
                    |seed| [0.15, 0.6, 2.5].map(|minor| case.errors(&footprints(&case.image, seed, minor, aspect)));
                rms(SEEDS.map(errors))
            });
            let label = format!("{}, {aspect}:1", file.trim_end_matches(".png"));
            let numbers: Vec<f64> = found.iter().flat_map(|rms| rms[1..5].to_vec()).collect();
            println!("{label:<14} {numbers:6.1?}, point {:.1}, truth {:.1}", found[0][0], found[0][5]);
            for (number, said) in numbers.iter().zip(documented(DOCUMENTATION, &label)) {
                assert!((number - said).abs() < 1.0, "{label}: {number} where {said} is documented");
            }
            assert!(found[0][5] < found[0][4] / 3.0, "the measurement is not good enough");
            assert!((1..5).all(|taps| found[0][taps] < found[1][taps]), "{label}");
            squares.iter_mut().zip(found[0]).for_each(|(sum, rms)| *sum += rms * rms / 3.0);
        }
        let [point, one, .., eight, _] = squares.map(f64::sqrt);
        println!("{file}, all aspects: point {point:.1}, one tap {one:.1}, eight {eight:.1}");
        if file == "gravel.png" {
            let apart = [(point, 150.0), (one, 34.0), (eight, 13.0)].map(|(found, said)| (found / said - 1.0).abs());
            assert!(apart.iter().all(|apart| *apart < 0.05), "`explain` says otherwise: {point} {one} {eight}");
        }
    }
}
