//! The shelf on a device against the image: formats and samplers, limits, and moments over round footprints.

use prefilter::gpu::{Address, Device, Texture};
use prefilter::reference::moments::{Beyond, Image};
use prefilter::table::{Format, Sampling, Table};
use prefilter::{Edge, MomentMipmap};
use spirv_tests::kernel::Function;

use crate::{photograph, points, random};

fn read(device: &Device, texture: &Texture, points: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let shelf = Function::shelf().unwrap();
    let read = shelf.iter().find(|function| function.name == "moments_read").unwrap();
    read.results(device, &[texture], points).unwrap()
}

#[test]
fn filtering_samplers_and_nearest_ones_read_the_same() {
    let device = Device::new().unwrap();
    let (image, stored) = photograph("jacksboro_dem.png", Beyond::Mirror);
    let pyramid = MomentMipmap::new(image.width as u32, image.height as u32, &stored, Edge::Clamp).unwrap();
    let table = pyramid.table("elevations", Format::Rg16Float).unwrap();
    let nearest = device.upload(&table, Address::Mirror).unwrap();
    let filtered = device.upload(&Table { sampling: Sampling::Filtered, ..table }, Address::Mirror).unwrap();
    let points = points(20_000);
    let pairs = read(&device, &nearest, &points).into_iter().zip(read(&device, &filtered, &points));
    let most = pairs.flat_map(|(a, b)| [(a[0] - b[0]).abs(), (a[1] - b[1]).abs()]).fold(0.0, f64::max);
    // Centers at up to 2 are off by half an ulp when they are computed and again when the sampler scales them.
    let off = image.width as f64 * 2.0 * 0.5 * f64::from(2f32.next_up() - 2.0);
    let steps = stored.chunks(image.width).flat_map(|row| row.windows(2)).map(|pair| pair[0] - pair[1]);
    let steepest = steps.fold(0f32, |most, step| most.max(step.abs()));
    let bound = 2.0 * off * f64::from(steepest);
    assert!(most < bound, "{most:e} of {bound:e}");
}

#[test]
fn constant_images_return_themselves_and_huge_footprints_the_whole_image() {
    let device = Device::new().unwrap();
    let constant = MomentMipmap::new(13, 7, &[0.7; 91], Edge::Clamp).unwrap();
    let texture = device.upload(&constant.table("flat", Format::Rg32Float).unwrap(), Address::Clamp).unwrap();
    for (point, result) in points(10_000).iter().zip(read(&device, &texture, &points(10_000))) {
        assert_eq!(result, [f64::from(0.7f32), 0.0], "{point:?}");
    }

    let mut next = random(11);
    let stored: Vec<f32> = (0..91).map(|_| next() as f32).collect();
    let pyramid = MomentMipmap::new(13, 7, &stored, Edge::Repeat).unwrap();
    let texture = device.upload(&pyramid.table("noise", Format::Rg32Float).unwrap(), Address::Repeat).unwrap();
    let huge = [43.0, 1e4, 1e9, 1e18, 1e36, f64::from(f32::MAX), f64::INFINITY];
    let points: Vec<Vec<f64>> = huge.iter().map(|&variance| vec![0.37, -5.6, variance, 0.0, variance]).collect();
    for (point, result) in points.iter().zip(read(&device, &texture, &points)) {
        assert_eq!(result, pyramid.moments().map(f64::from), "{point:?}");
    }
}

/// Root mean square error of mean and deviation over round footprints, and the same of reading a point.
fn against_truth(device: &Device, image: &Image, stored: &[f32], deviation: f64) -> [f64; 4] {
    let pyramid = MomentMipmap::new(image.width as u32, image.height as u32, stored, Edge::Repeat).unwrap();
    let texture = device.upload(&pyramid.table("image", Format::Rg32Float).unwrap(), Address::Repeat).unwrap();
    let mut next = random(3);
    let covariance = [deviation * deviation, 0.0, deviation * deviation];
    let points: Vec<Vec<f64>> = (0..200).map(|_| [vec![next(), next()], covariance.to_vec()].concat()).collect();
    let mut sums = [0.0; 4];
    for (point, result) in points.iter().zip(read(device, &texture, &points)) {
        let at = [point[0] * image.width as f64, point[1] * image.height as f64];
        let [mean, square] = image.mean(at, covariance, 96, |value| [value, value * value]);
        let own = (square - mean * mean).max(0.0).sqrt();
        let errors = [result[0] - mean, result[1] - own, image.value(at[0], at[1]) - mean, own];
        sums.iter_mut().zip(errors).for_each(|(sum, error)| *sum += error * error / points.len() as f64);
    }
    sums.map(f64::sqrt)
}

/// Question 3 for the moments themselves: a point's value is the alternative that costs nothing.
#[test]
fn moments_are_close_to_those_of_the_reconstruction() {
    let device = Device::new().unwrap();
    for name in ["gravel.png", "jacksboro_dem.png"] {
        let (image, stored) = photograph(name, Beyond::Repeat);
        for deviation in [0.05, 0.15, 0.3, 0.6, 1.0, 1.5, 2.5, 6.0, 20.0, 100.0] {
            let [mean, own, point, truth] = against_truth(&device, &image, &stored, deviation);
            println!("{name:<18} σ {deviation:<5} mean ±{mean:.2e} (point ±{point:.2e}), σ {truth:.4} ±{own:.2e}");
            assert!(mean < point && own < truth / 3.0, "{name} {deviation}");
            assert!(deviation < 0.5 || mean < point / 2.0, "{name} {deviation}");
        }
    }
}
