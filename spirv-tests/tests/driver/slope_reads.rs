//! The shelf's slopes on a device against their maps: constants, limits, seams, and what reads must conserve.

use prefilter::gpu::{Address, Device, Texture};
use prefilter::reference::moments::Beyond;
use prefilter::table::Format;
use prefilter::{Edge, SlopeMipmap};
use spirv_tests::any;
use spirv_tests::kernel::Function;
use spirv_tests::random::Random;

use crate::{photograph, points, random};

struct Reader {
    device: Device,
    read: Function,
}

impl Reader {
    fn new() -> Self {
        let shelf = Function::shelf().unwrap();
        let read = shelf.into_iter().find(|function| function.name == "slope_moments_read").unwrap();
        Self { device: Device::new().unwrap(), read }
    }

    /// Mean x and y and covariance xx, xy, yy for each point: a position and a footprint.
    fn read(&self, pyramid: &SlopeMipmap, format: Format, address: Address, points: &[Vec<f64>]) -> Vec<Vec<f64>> {
        let tables = pyramid.tables("slopes", format).unwrap();
        let textures: Vec<Texture> = tables.iter().map(|table| self.device.upload(table, address).unwrap()).collect();
        self.read.results(&self.device, &textures.iter().collect::<Vec<_>>(), points).unwrap()
    }
}

#[test]
fn a_plane_reads_as_its_slope_and_huge_footprints_as_the_whole_map() {
    let reader = Reader::new();
    let heights: Vec<f32> = (0..13 * 7).map(|at| 0.25 * (at % 13) as f32 - 0.5 * (at / 13) as f32).collect();
    let plane = SlopeMipmap::from_heights(13, 7, &heights, 2.0, Edge::Clamp).unwrap();
    for format in [Format::Rgba32Float, Format::Rgba16Float] {
        for result in reader.read(&plane, format, Address::Clamp, &points(10_000)) {
            assert_eq!(result, [0.125, -0.25, 0.0, 0.0, 0.0]);
        }
    }

    let mut next = random(11);
    let slopes: Vec<[f32; 2]> = (0..91).map(|_| [next() as f32, next() as f32 - 0.25]).collect();
    let pyramid = SlopeMipmap::from_slopes(13, 7, &slopes, Edge::Repeat).unwrap();
    let huge = [43.0, 1e4, 1e18, 1e36, f64::from(f32::MAX), f64::INFINITY];
    let points: Vec<Vec<f64>> = huge.iter().map(|&variance| vec![0.37, -5.6, variance, 0.0, variance]).collect();
    let (mean, covariance) = pyramid.moments();
    for result in reader.read(&pyramid, Format::Rgba32Float, Address::Repeat, &points) {
        assert_eq!(result[..2], mean.map(f64::from));
        // The texel is read four times: its covariance comes back to the rounding of the weights.
        let apart = result[2..].iter().zip(covariance).map(|(got, expected)| (got - f64::from(expected)).abs());
        assert!(apart.fold(0.0, f64::max) <= 1.2e-7, "{result:?} {covariance:?}");
    }
}

/// Mean x and y and covariance of all reads together.
fn total(reads: &[Vec<f64>]) -> [f64; 5] {
    let mut sums = [0.0; 5];
    for read in reads {
        let [x, y] = [read[0], read[1]];
        let raw = [x, y, read[2] + x * x, read[3] + x * y, read[4] + y * y];
        sums.iter_mut().zip(raw).for_each(|(sum, raw)| *sum += raw / reads.len() as f64);
    }
    let [x, y, xx, xy, yy] = sums;
    [x, y, xx - x * x, xy - x * y, yy - y * y]
}

/// Kernels of all positions cover the map evenly: what the mean slopes read do not vary, the covariances hold.
#[test]
fn reads_conserve_the_covariance_of_the_map() {
    let reader = Reader::new();
    let (_, stored) = photograph("gravel.png", Beyond::Repeat);
    let crop: Vec<f32> = (0..64 * 64).map(|at| stored[at / 64 * 512 + at % 64]).collect();
    let pyramid = SlopeMipmap::from_heights(64, 64, &crop, 0.1, Edge::Repeat).unwrap();
    let (mean, covariance) = pyramid.moments();
    let whole: Vec<f64> = mean.into_iter().chain(covariance).map(f64::from).collect();
    // Two positions a texel either way have the tent's mean weights exactly.
    let place = |at: usize| (at as f64 + 0.5) / 128.0;
    for variance in [1.0, 2.5, 4.0, 9.0, 16.0, 100.0, 700.0] {
        let point = |at: usize| vec![place(at % 128), place(at / 128), variance, 0.0, variance];
        let points: Vec<_> = (0..128 * 128).map(point).collect();
        for (format, within) in [(Format::Rgba32Float, 1e-6), (Format::Rgba16Float, 1e-3)] {
            let reads = reader.read(&pyramid, format, Address::Repeat, &points);
            let found = total(&reads);
            let scale = whole[2] + whole[4];
            let apart = found.iter().zip(&whole).skip(2).map(|(a, b)| (a - b).abs() / scale).fold(0.0, f64::max);
            let held = reads.iter().map(|read| (read[2] + read[4]) / scale).sum::<f64>() / reads.len() as f64;
            println!("σ² {variance:<4} {format:?}: covariances hold {held:.3} of the whole, {apart:.1e} is lost");
            assert!(apart < within, "{variance} {format:?}: {found:?} {whole:?}");
        }
    }
}

#[test]
fn seams_of_repeated_maps_read_like_any_other_place() {
    let reader = Reader::new();
    let mut next = random(9);
    let heights: Vec<f32> = (0..256).map(|_| next() as f32).collect();
    let turned: Vec<f32> = (0..256).map(|at| heights[(at / 16 + 8) % 16 * 16 + (at % 16 + 8) % 16]).collect();
    let points: Vec<_> = points(10_000).into_iter().filter(|point| point[2] < 16.0).collect();
    let shifted: Vec<_> =
        points.iter().map(|point| [&[point[0] - 0.5, point[1] + 0.5], &point[2..]].concat()).collect();
    let read = |map: &[f32], points: &[Vec<f64>]| {
        let pyramid = SlopeMipmap::from_heights(16, 16, map, 1.0, Edge::Repeat).unwrap();
        reader.read(&pyramid, Format::Rgba32Float, Address::Repeat, points)
    };
    let (here, there) = (read(&heights, &points), read(&turned, &shifted));
    let apart = here.iter().flatten().zip(there.iter().flatten()).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    // Positions times 16 are rounded at 32, 2^-19 of a texel each; slopes change by 2 a texel at most, their squares
    // and the covariances by no more than twice that.
    assert!(points.len() > 5000 && apart <= 2.0 * 4.0 * 2f64.powi(-19), "{apart:e}");
}

/// Positions in the map and far from it, footprints of any size and shape.
fn any_points(random: &mut Random, count: usize) -> Vec<Vec<f64>> {
    let point = |random: &mut Random| {
        let place = random.pick([1.0, 3.0, 1e5]);
        let position = [0; 2].map(|_| f64::from((place * (2.0 * random.unit() - 1.0)) as f32));
        [&position[..], &any::covariance(random)].concat()
    };
    (0..count).map(|_| point(random)).collect()
}

#[test]
fn covariances_are_finite_and_positive_semi_definite_whatever_the_map() {
    const BATCH: usize = 10_000;
    let reader = Reader::new();
    let mut next = random(3);
    let mut random = Random::new(17);
    let mut count = 0;
    for [x, y] in [[1.0, 0.0], [0.6, 0.8], [1e-3, -1.0], [1.0, 1e-6], [200.0, -300.0], [0.0, 0.0]] {
        for noise in [0.0, 1e-4] {
            let mut slope = |at: f64| [at * x + noise * next(), at * y].map(|value| value as f32);
            let mut line = crate::random(4);
            let slopes: Vec<[f32; 2]> = (0..91).map(|_| line() - 0.5).map(&mut slope).collect();
            let pyramid = SlopeMipmap::from_slopes(13, 7, &slopes, Edge::Repeat).unwrap();
            for format in [Format::Rgba32Float, Format::Rgba16Float] {
                for _ in 0..any::inputs(24 * BATCH).div_ceil(24 * BATCH) {
                    let points = [any_points(&mut random, BATCH / 2), points(BATCH / 2)].concat();
                    for (point, read) in points.iter().zip(reader.read(&pyramid, format, Address::Repeat, &points)) {
                        let [xx, xy, yy] = [read[2], read[3], read[4]];
                        let finite = read.iter().all(|value| value.is_finite());
                        assert!(finite && xx >= 0.0 && yy >= 0.0, "{point:?}: {read:?}");
                        assert!(xy * xy <= xx * yy, "{x} {y} {noise} {format:?} {point:?}: {read:?}");
                        count += 1;
                    }
                }
            }
        }
    }
    assert!(count >= any::inputs(24 * BATCH), "{count}");
}
