//! Question 3: colors over long footprints, by 1 to 8 taps, against the integral over the image's reconstruction.

use prefilter::gpu::{Address, Device, Kernel, Texture, Work};
use prefilter::reference::moments::{Beyond, Image};
use prefilter::reference::texture::PiecewiseLinear;
use prefilter::table::Format;
use prefilter::{Driver, Edge, Kernel as Form, MomentMipmap, Moments, Scene, Taps, Tier};
use spirv_tests::maps;

use crate::footprints::{footprints, Footprint};
use crate::photograph;

pub const TAPS: [Taps; 4] = [Taps::One, Taps::Two, Taps::Four, Taps::Eight];
pub const SEEDS: [u32; 4] = [1, 2, 3, 4];

pub const ENTRY: &str = "
@group(0) @binding(0) var<storage, read_write> output: array<f32>;
@group(0) @binding(1) var<storage, read> points: array<array<f32, 6>>;
@group(1) @binding(0) var image: texture_2d<f32>;
@group(1) @binding(1) var image_sampler: sampler;
@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= arrayLength(&points) { return; }
    let p = points[id.x];
    let color = rock_color(vec2f(p[0], p[1]), vec2f(p[2], p[3]), vec2f(p[4], p[5]), image, image_sampler);
    for (var channel = 0u; channel < 3u; channel++) { output[3u * id.x + channel] = color[channel]; }
}";

/// An image with a map, ready to be colored by each number of taps.
pub struct Case {
    pub image: Image,
    pub textures: Vec<Texture>,
    pub map: PiecewiseLinear,
    pub kernels: Vec<Kernel>,
}

impl Case {
    pub fn new(device: &Device, file: &str, map: &str) -> Self {
        let (image, stored) = photograph(file, Beyond::Repeat);
        let pyramid = MomentMipmap::new(image.width as u32, image.height as u32, &stored, Edge::Repeat).unwrap();
        let texture = device.upload(&pyramid.table("image", Format::Rg32Float).unwrap(), Address::Repeat).unwrap();
        let map = maps::named(map).unwrap();
        let kernel = |taps| {
            let driver = Driver::Moments(Moments { taps, ..Moments::default() });
            let scene = Scene::new("rock").texture(map.clone()).tier(Tier::ClosedForm(Form::Exact)).driver(driver);
            Kernel::new(device, scene.module().unwrap().link(ENTRY).unwrap().wgsl(), "main").unwrap()
        };
        Self { image, textures: vec![texture], kernels: TAPS.map(kernel).into(), map: map.reference() }
    }

    /// Squared errors, averaged over positions and channels: of a point's color, of each number of taps, and how far
    /// two resolutions of the truth are apart.
    pub fn errors(&self, footprints: &[Footprint]) -> [f64; 6] {
        let colors = |side| -> Vec<[f64; 4]> {
            let color = |at: &Footprint| self.image.mean(at.center, at.covariance(), side, |v| self.map.value(v));
            footprints.iter().map(color).collect()
        };
        let (truth, coarse) = (colors(72), colors(51));
        let apart = |found: &dyn Fn(usize, usize) -> f64| {
            let count = 3.0 * truth.len() as f64;
            let error = |at: usize| (0..3).map(|c| (found(at, c) - truth[at][c]).powi(2)).sum::<f64>();
            (0..truth.len()).map(error).sum::<f64>() / count
        };
        let points: Vec<f32> = footprints.iter().flat_map(|footprint| footprint.point(&self.image)).collect();
        let mut errors = [0.0; 6];
        let value = |at: usize| self.image.value(footprints[at].center[0], footprints[at].center[1]);
        errors[0] = apart(&|at, channel| self.map.value(value(at))[channel]);
        for (kernel, error) in self.kernels.iter().zip(&mut errors[1..]) {
            let (invocations, output) = (footprints.len(), 3 * footprints.len());
            let textures: Vec<&Texture> = self.textures.iter().collect();
            let work = Work { inputs: &[&points], textures: &textures, invocations, output };
            let colors = kernel.run(&work).unwrap();
            *error = apart(&|at, channel| f64::from(colors[3 * at + channel]));
        }
        errors[5] = apart(&|at, channel| coarse[at][channel]);
        errors
    }
}

/// Roots of squared errors over seeds and footprints of each, in thousandths.
pub fn rms<const N: usize, const M: usize>(of_seed: [[[f64; 6]; N]; M]) -> [f64; 6] {
    let all = || of_seed.iter().flatten();
    std::array::from_fn(|column| 1e3 * (all().map(|errors| errors[column]).sum::<f64>() / (N * M) as f64).sqrt())
}

#[test]
fn errors_of_long_footprints_fall_with_the_taps() {
    let device = Device::new().unwrap();
    println!("RMS × 1e-3 over positions, directions and minor deviations 0.15, 0.6, 2.5 texels");
    println!("{:<28} {:>6} {:>6} {:>6} {:>6} {:>6} {:>6} {:>6}", "", "point", "1", "2", "4", "8", "truth", "seeds");
    let cases = [("gravel.png", "steps6"), ("gravel.png", "terrain"), ("jacksboro_dem.png", "terrain")];
    for (file, map) in cases {
        let case = Case::new(&device, file, map);
        for aspect in [1.0, 2.0, 4.0, 8.0, 16.0] {
            let of_seed = SEEDS.map(|seed| {
                let minors = [0.15, 0.6, 2.5].map(|minor| case.errors(&footprints(&case.image, seed, minor, aspect)));
                std::array::from_fn::<f64, 6, _>(|column| minors.iter().map(|errors| errors[column]).sum::<f64>() / 3.0)
            });
            let mean = |column: usize| of_seed.iter().map(|errors| errors[column]).sum::<f64>() / SEEDS.len() as f64;
            let rms: [f64; 6] = std::array::from_fn(|column| 1e3 * mean(column).sqrt());
            // Standard error of the figure for eight taps, from the seeds.
            let spread = of_seed.iter().map(|errors| (errors[4] - mean(4)).powi(2)).sum::<f64>() / 3.0;
            let standard = 1e3 * (spread / 4.0).sqrt() / (2.0 * mean(4).sqrt());
            let numbers = rms.map(|value| format!("{value:6.1}")).join(" ");
            println!("{:<28} {numbers} {standard:6.1}", format!("{file} {map} {aspect}:1"));
            let [point, one, two, four, eight, truth] = rms;
            assert!(truth < eight / 3.0 && standard < eight / 3.0, "the measurement is not good enough");
            assert!(one < point / 2.0 && eight < 0.8 * one, "{file} {map} {aspect}");
            if aspect > 2.0 {
                assert!(two < one && four < two && eight < four, "{file} {map} {aspect}");
            }
            if aspect >= 8.0 {
                assert!(eight < 0.5 * one, "{file} {map} {aspect}: {eight} of {one}");
            }
        }
    }
}
