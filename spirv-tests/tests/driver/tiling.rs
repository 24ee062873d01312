//! Images that repeat: reads a whole image further are the same, none has a seam, and footprints larger than the image
//! hold all of it.

use prefilter::gpu::{Address, Device, Texture};
use prefilter::reference::moments::{Beyond, Image};
use prefilter::table::Format;
use prefilter::{Edge, FourMomentMipmap, MomentMipmap};
use spirv_tests::kernel::Function;

use crate::random;

const SIZES: [[usize; 2]; 4] = [[13, 7], [37, 23], [5, 64], [32, 32]];

fn noise([width, height]: [usize; 2]) -> (Image, Vec<f32>) {
    let mut next = random(width as u32);
    let stored: Vec<f32> = (0..width * height).map(|_| next() as f32).collect();
    let values = stored.iter().map(|&value| f64::from(value)).collect();
    (Image { width, height, values, beyond: Beyond::Repeat }, stored)
}

fn textures(device: &Device, [width, height]: [usize; 2], stored: &[f32]) -> [(&'static str, Texture); 2] {
    let (width, height) = (width as u32, height as u32);
    let two = MomentMipmap::new(width, height, stored, Edge::Repeat).unwrap();
    let four = FourMomentMipmap::new(width, height, stored, Edge::Repeat).unwrap();
    let upload = |table: &prefilter::Table| device.upload(table, Address::Repeat).unwrap();
    [
        ("moments_read", upload(&two.table("two", Format::Rg32Float).unwrap())),
        ("four_moments_read", upload(&four.table("four", Format::Rgba32Float).unwrap())),
    ]
}

fn read(device: &Device, function: &str, texture: &Texture, points: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let shelf = Function::shelf().unwrap();
    let read = shelf.iter().find(|shelf| shelf.name == function).unwrap();
    read.results(device, &[texture], points).unwrap()
}

/// Footprints of a deviation from one texel, below which the image's cells have edges, to four images.
fn footprint(next: &mut impl FnMut() -> f64, size: [usize; 2]) -> [f64; 3] {
    let longest = 4.0 * size[0].max(size[1]) as f64;
    let variance = longest.powf(2.0 * next());
    [variance, 0.4 * variance * (next() - 0.5), variance]
}

#[test]
fn reads_are_the_same_in_every_repetition_and_have_no_seam() {
    let device = Device::new().unwrap();
    for size in SIZES {
        let (_, stored) = noise(size);
        let mut next = random(5);
        let (mut here, mut there, mut before, mut behind) = (vec![], vec![], vec![], vec![]);
        for turn in 0..2000 {
            let (at, covariance) = ([next(), next()], footprint(&mut next, size).to_vec());
            let away = [f64::from(turn % 5) - 2.0, f64::from(turn % 3) - 1.0];
            let point = |x: f64, y: f64| [vec![x, y], covariance.clone()].concat();
            here.push(point(at[0], at[1]));
            there.push(point(at[0] + away[0], at[1] + away[1]));
            // A thousandth of a texel on both sides of the left edge.
            let aside = 1e-3 / size[0] as f64;
            before.push(point(-aside, at[1]));
            behind.push(point(aside, at[1]));
        }
        // Positions up to 3 are rounded, and times the size once more; no moment changes by more than 4 a texel.
        let shifted = 4.0 * 4.0 * f64::from(3f32.next_up() - 3.0) * size[0].max(size[1]) as f64;
        for (function, texture) in textures(&device, size, &stored) {
            let most = |a: &[Vec<f64>], b: &[Vec<f64>]| {
                let pairs = read(&device, function, &texture, a).into_iter().zip(read(&device, function, &texture, b));
                let apart =
                    pairs.flat_map(|(a, b)| a.into_iter().zip(b).map(|(a, b)| (a - b).abs()).collect::<Vec<_>>());
                // Written so that NaN is the largest.
                apart.fold(0.0, |most: f64, apart| if apart <= most { most } else { apart })
            };
            let (moved, seam) = (most(&here, &there), most(&before, &behind));
            println!("{size:?} {function}: {moved:.1e} a whole image away, {seam:.1e} across the seam");
            assert!(moved < shifted, "{size:?} {function}: {moved:e} of {shifted:e}");
            assert!(seam < 4.0 * 2e-3 + shifted, "{size:?} {function}: {seam:e}");
        }
    }
}

/// Against the repeated image itself, by quadrature over as many of its repetitions as the footprint covers.
#[test]
fn footprints_larger_than_an_image_hold_all_of_it() {
    let device = Device::new().unwrap();
    for size in [[13, 7], [5, 16], [8, 8]] {
        let (image, stored) = noise(size);
        let side = size[0].max(size[1]) as f64;
        let count = stored.len() as f64;
        let texels: Vec<[f64; 4]> =
            (0..stored.len()).map(|at| image.raw_over_texel(at % size[0], at / size[0])).collect();
        let whole: [f64; 4] = std::array::from_fn(|power| texels.iter().map(|raw| raw[power]).sum::<f64>() / count);
        let [_, second, ..] = prefilter::reference::four_moments::central(whole);
        for wide in [0.25, 0.5, 1.0, 3.0] {
            let covariance = [(wide * side).powi(2), 0.0, (wide * side).powi(2)];
            let mut next = random(9);
            let points: Vec<Vec<f64>> =
                (0..16).map(|_| [vec![4.0 * next() - 2.0, 4.0 * next() - 2.0], covariance.to_vec()].concat()).collect();
            let mut most = [0f64; 2];
            for (function, texture) in textures(&device, size, &stored) {
                for (point, found) in points.iter().zip(read(&device, function, &texture, &points)) {
                    let at = [point[0] * size[0] as f64, point[1] * size[1] as f64];
                    let powers = |value: f64| [value, value * value];
                    // Three points a texel along both axes.
                    let [mean, square] = image.mean(at, covariance, (9.0 * wide * side * 3.0) as usize, powers);
                    let variance = if function == "moments_read" { found[1] * found[1] } else { found[1] };
                    let errors = [found[0] - mean, variance - (square - mean * mean)];
                    most = [0, 1].map(|at| most[at].max(errors[at].abs()));
                    if wide >= 0.5 {
                        // The last level: the mean of the whole to the bit, but for its rounding.
                        assert!((found[0] - whole[0]).abs() < 1e-6 && (variance - second).abs() < 1e-6);
                    }
                }
            }
            println!("{size:?}, {wide} images wide: mean ±{:.1e}, variance ±{:.1e} of {second:.3}", most[0], most[1]);
            // A Gaussian of deviation w images leaves exp(−2π² w²) of the image's longest wave, the pyramid no more.
            let left = (-2.0 * (std::f64::consts::PI * wide).powi(2)).exp();
            assert!(most[0] < 2.0 * left * second.sqrt() + 1e-3, "{size:?} {wide}: {most:?}");
            assert!(most[1] < 2.0 * left * second + 1e-3, "{size:?} {wide}: {most:?}");
        }
    }
}
