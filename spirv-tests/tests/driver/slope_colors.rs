//! Question 3: colors by the slopes that are seen of a map, by 1 to 8 taps, against the integral over the map's
//! reconstruction, facets counted by their area in the picture.

use std::f64::consts::TAU;

use prefilter::gpu::{Address, Device, Kernel, Texture, Work};
use prefilter::reference::footprint::{axes, deviations};
use prefilter::reference::moments::{Beyond, Image};
use prefilter::reference::texture::PiecewiseLinear;
use prefilter::table::Format;
use prefilter::{ColorMap, Driver, Edge, Kernel as Form, Scene, SlopeMipmap, SlopeMoments, SlopeTier, Taps, Tier};
use spirv_tests::random::Random;
use spirv_tests::{any, maps};

use crate::footprints::{footprints, Footprint};
use crate::{photograph, random};

const TAPS: [Taps; 4] = [Taps::One, Taps::Two, Taps::Four, Taps::Eight];
const SEEDS: [u32; 4] = [1, 2, 3, 4];

const ENTRY: &str = "
@group(0) @binding(0) var<storage, read_write> output: array<f32>;
@group(0) @binding(1) var<storage, read> points: array<array<f32, 11>>;
@group(1) @binding(0) var slopes: texture_2d<f32>;
@group(1) @binding(1) var slopes_sampler: sampler;
@group(1) @binding(2) var slopes_cross: texture_2d<f32>;
@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= arrayLength(&points) { return; }
    let p = points[id.x];
    let color = rock_color(vec2f(p[0], p[1]), vec2f(p[2], p[3]), vec2f(p[4], p[5]), vec3f(p[6], p[7], p[8]),
        vec2f(p[9], p[10]), slopes, slopes_cross, slopes_sampler);
    for (var channel = 0u; channel < 3u; channel++) { output[3u * id.x + channel] = color[channel]; }
}";

/// A pixel of a map: its footprint, the direction of the view and that of the component.
struct Pixel {
    footprint: Footprint,
    view: [f64; 3],
    direction: [f64; 2],
}

/// A map of slopes with a color map, ready to be colored by each number of taps.
struct Case {
    slopes: [Image; 2],
    textures: [Texture; 2],
    map: PiecewiseLinear,
    kernels: Vec<Kernel>,
}

/// A map over [0, 1] stretched to slopes from −reach to reach.
fn stretched(map: &ColorMap, reach: f32) -> ColorMap {
    let stops = map.knots().iter().flat_map(|knot| {
        let at = reach * (2.0 * knot.position - 1.0);
        let hard = (knot.left != knot.right).then_some((at, knot.right));
        [Some((at, knot.left)), hard].into_iter().flatten()
    });
    ColorMap::gradient(stops).unwrap()
}

impl Case {
    /// A photograph as heights, from 0 to `height` texels.
    fn new(device: &Device, file: &str, height: f64, map: &str) -> Self {
        let (image, _) = photograph(file, Beyond::Repeat);
        let slope = |at: usize| {
            let (x, y) = ((at % image.width) as f64 + 0.5, (at / image.width) as f64 + 0.5);
            let across = image.value(x + 1.0, y) - image.value(x - 1.0, y);
            let down = image.value(x, y + 1.0) - image.value(x, y - 1.0);
            [across, down].map(|rise| (0.5 * height * rise) as f32)
        };
        let slopes: Vec<[f32; 2]> = (0..image.values.len()).map(slope).collect();
        let deviation = (slopes.iter().flatten().map(|s| s * s).sum::<f32>() / (2 * slopes.len()) as f32).sqrt();
        println!("{file}: slopes deviate by {deviation:.3}");
        let pyramid = SlopeMipmap::from_slopes(image.width as u32, image.height as u32, &slopes, Edge::Repeat).unwrap();
        let textures = pyramid
            .tables("slopes", Format::Rgba32Float)
            .unwrap()
            .map(|table| device.upload(&table, Address::Repeat).unwrap());
        let map = stretched(&maps::named(map).unwrap(), 2.5 * deviation);
        let kernel = |taps| {
            let driver = Driver::SlopeMoments(SlopeMoments { taps, ..SlopeMoments::default() });
            let scene = Scene::new("rock").slope(map.clone()).slope_tier(SlopeTier::Pair);
            let module = scene.tier(Tier::ClosedForm(Form::Exact)).driver(driver).module().unwrap();
            Kernel::new(device, module.link(ENTRY).unwrap().wgsl(), "main").unwrap()
        };
        let slopes = [0, 1]
            .map(|axis| Image { values: slopes.iter().map(|slope| f64::from(slope[axis])).collect(), ..image.clone() });
        Self { slopes, textures, kernels: TAPS.map(kernel).into(), map: map.reference() }
    }

    /// The mean color over the footprint by `side`² points, each by the area of its facet in the picture, and that area
    /// for all of the mesh's.
    fn truth(&self, pixel: &Pixel, side: usize) -> ([f64; 4], f64) {
        let covariance = pixel.footprint.covariance();
        let ([major, minor], [long, short]) = (deviations(covariance), axes(covariance));
        let (sin, cos) = 0.37f64.sin_cos();
        let at = |index: usize| 4.5 * ((2 * index + 1) as f64 / side as f64 - 1.0);
        let (mut sum, mut seen, mut whole) = ([0.0; 4], 0.0, 0.0);
        for point in 0..side * side {
            let (u, v) = (at(point % side), at(point / side));
            let (a, b) = (major * (cos * u - sin * v), minor * (sin * u + cos * v));
            let [x, y] = [0, 1].map(|axis| pixel.footprint.center[axis] + a * long[axis] + b * short[axis]);
            let slope = self.slopes.each_ref().map(|image| image.value(x, y));
            let area = pixel.view[2] - pixel.view[0] * slope[0] - pixel.view[1] * slope[1];
            let place = (-0.5 * (u * u + v * v)).exp();
            let weight = place * area.max(0.0);
            let color = self.map.value(pixel.direction[0] * slope[0] + pixel.direction[1] * slope[1]);
            sum.iter_mut().zip(color).for_each(|(sum, color)| *sum += weight * color);
            seen += weight;
            whole += place * pixel.view[2];
        }
        (sum.map(|sum| sum / seen), seen / whole)
    }

    /// Pixels whose facets are in the picture with a tenth of the mesh's area at least.
    fn pixels(&self, seed: u32, minor: f64, aspect: f64) -> Vec<Pixel> {
        let mut next = random(100 + seed);
        let mut pixel = |footprint| {
            let (z, azimuth, turn) = (0.25 + 0.75 * next(), TAU * next(), TAU * next());
            let radius = (1.0 - z * z).sqrt();
            let view = [radius * azimuth.cos(), radius * azimuth.sin(), z].map(|part| f64::from(part as f32));
            Pixel { footprint, view, direction: [turn.cos(), turn.sin()].map(|part| f64::from(part as f32)) }
        };
        let pixels = footprints(&self.slopes[0], seed, minor, aspect).into_iter().map(&mut pixel);
        pixels.filter(|pixel| self.truth(pixel, 51).1 > 0.1).collect()
    }

    /// Squared errors, averaged over pixels and channels: of a point's color, of each number of taps, and how far two
    /// resolutions of the truth are apart.
    fn errors(&self, pixels: &[Pixel]) -> [f64; 6] {
        let colors = |side| -> Vec<[f64; 4]> { pixels.iter().map(|pixel| self.truth(pixel, side).0).collect() };
        let (truth, coarse) = (colors(72), colors(51));
        let apart = |found: &dyn Fn(usize, usize) -> f64| {
            let error = |at: usize| (0..3).map(|c| (found(at, c) - truth[at][c]).powi(2)).sum::<f64>();
            (0..truth.len()).map(error).sum::<f64>() / (3 * truth.len()) as f64
        };
        let numbers = |pixel: &Pixel| {
            let rest = pixel.view.into_iter().chain(pixel.direction).map(|number| number as f32);
            pixel.footprint.point(&self.slopes[0]).into_iter().chain(rest)
        };
        let points: Vec<f32> = pixels.iter().flat_map(numbers).collect();
        let component = |pixel: &Pixel| {
            let [x, y] = self.slopes.each_ref().map(|image| {
                let [x, y] = pixel.footprint.center;
                image.value(x, y)
            });
            pixel.direction[0] * x + pixel.direction[1] * y
        };
        let mut errors = [0.0; 6];
        errors[0] = apart(&|at, channel| self.map.value(component(&pixels[at]))[channel]);
        for (kernel, error) in self.kernels.iter().zip(&mut errors[1..]) {
            let textures = [&self.textures[0], &self.textures[1]];
            let work =
                Work { inputs: &[&points], textures: &textures, invocations: pixels.len(), output: 3 * pixels.len() };
            let colors = kernel.run(&work).unwrap();
            *error = apart(&|at, channel| f64::from(colors[3 * at + channel]));
        }
        errors[5] = apart(&|at, channel| coarse[at][channel]);
        errors
    }
}

/// A photograph, its height in texels and a map; the RMS over all aspects that modules quote for a point's color and
/// for 1, 2, 4 and 8 taps.
const CASES: [(&str, f64, &str, [f64; 5]); 3] = [
    ("gravel.png", 5.0, "steps6", [0.202, 0.059, 0.050, 0.039, 0.029]),
    ("gravel.png", 5.0, "terrain", [0.155, 0.051, 0.042, 0.033, 0.023]),
    // Elevations of 840 meters on texels of about 83.
    ("jacksboro_dem.png", 10.1, "terrain", [0.135, 0.045, 0.037, 0.027, 0.020]),
];

/// Mean squared errors of a case at an aspect, and the standard error of that of eight taps.
fn judge(case: &Case, aspect: f64) -> ([f64; 6], f64) {
    let of_seed = SEEDS.map(|seed| {
        let minors = [0.15, 0.6, 2.5].map(|minor| case.errors(&case.pixels(seed, minor, aspect)));
        std::array::from_fn::<f64, 6, _>(|column| minors.iter().map(|errors| errors[column]).sum::<f64>() / 3.0)
    });
    let mean = |column: usize| of_seed.iter().map(|errors| errors[column]).sum::<f64>() / SEEDS.len() as f64;
    let spread = of_seed.iter().map(|errors| (errors[4] - mean(4)).powi(2)).sum::<f64>() / 3.0;
    (std::array::from_fn(mean), (spread / 4.0).sqrt())
}

#[test]
fn errors_of_slopes_fall_with_the_taps() {
    let device = Device::new().unwrap();
    println!("RMS × 1e-3 over positions, directions, views and minor deviations 0.15, 0.6, 2.5 texels");
    println!("{:<28} {:>6} {:>6} {:>6} {:>6} {:>6} {:>6} {:>6}", "", "point", "1", "2", "4", "8", "truth", "seeds");
    for (file, height, map, quoted) in CASES {
        let case = Case::new(&device, file, height, map);
        let mut all = [0.0; 6];
        for aspect in [1.0, 2.0, 4.0, 8.0, 16.0] {
            let (squares, error) = judge(&case, aspect);
            all.iter_mut().zip(squares).for_each(|(sum, square)| *sum += square / 5.0);
            let rms = squares.map(|square| 1e3 * square.sqrt());
            let standard = 1e3 * error / (2.0 * squares[4].sqrt());
            let numbers = rms.map(|value| format!("{value:6.1}")).join(" ");
            println!("{:<28} {numbers} {standard:6.1}", format!("{file} {map} {aspect}:1"));
            let [point, one, two, four, eight, truth] = rms;
            assert!(truth < eight / 3.0 && standard < eight / 3.0, "the measurement is not good enough");
            assert!(one < 0.45 * point && eight < 0.8 * one, "{file} {map} {aspect}");
            assert!(aspect < 2.0 || (two < one && four < two && eight < four), "{file} {map} {aspect}");
            assert!(aspect < 4.0 || eight < 0.5 * one, "{file} {map} {aspect}: {eight} of {one}");
        }
        let all = all.map(f64::sqrt);
        println!("{file} {map}: {all:.4?}");
        for (found, quoted) in all.iter().zip(quoted) {
            assert!((found - quoted).abs() < 1e-3, "{file} {map}: {found}, not {quoted}");
        }
    }
}

#[test]
fn modules_quote_the_errors_of_their_taps() {
    for (number, taps) in TAPS.into_iter().enumerate() {
        let driver = Driver::SlopeMoments(SlopeMoments { taps, ..SlopeMoments::default() });
        let module = Scene::new("rock").slope(maps::named("terrain").unwrap()).driver(driver).module().unwrap();
        let [gravel, _, elevations] = CASES.map(|case| case.3);
        let quoted = [
            format!("RMS of {:.3} on\n    elevations and {:.3} on gravel", elevations[1 + number], gravel[1 + number]),
            format!("of a point has {:.3} and {:.3}", elevations[0], gravel[0]),
        ];
        for quoted in quoted {
            assert!(module.explain().contains(&quoted), "{quoted} is not in {}", module.explain());
        }
    }
}

/// Whatever the position, its derivatives and the view, colors are finite and in the hull.
#[test]
fn colors_of_maps_stay_in_the_hull() {
    const COUNT: usize = 200_000;
    let device = Device::new().unwrap();
    let case = Case::new(&device, "gravel.png", 5.0, "terrain");
    let mut random = Random::new(5);
    let mut points: Vec<f32> = Vec::new();
    for _ in 0..COUNT {
        let place = random.pick([1.0, 3.0, 1e4]);
        points.extend([0; 2].map(|_| (place * (2.0 * random.unit() - 1.0)) as f32));
        points.extend([0; 4].map(|_| any::number(&mut random).clamp(-f32::MAX, f32::MAX)));
        points.extend(any::direction(&mut random).map(|part| part as f32));
        points.extend([0; 2].map(|_| any::number(&mut random).clamp(-1.0, 1.0)));
    }
    for (kernel, taps) in case.kernels.iter().zip(TAPS) {
        let textures = [&case.textures[0], &case.textures[1]];
        let work = Work { inputs: &[&points], textures: &textures, invocations: COUNT, output: 3 * COUNT };
        let colors = kernel.run(&work).unwrap();
        assert_eq!(colors.len(), 3 * COUNT);
        for (color, point) in colors.chunks(3).zip(points.chunks(11)) {
            assert!(color.iter().all(|channel| (0.0..=1.0).contains(channel)), "{taps:?}: {point:?} gives {color:?}");
        }
    }
}
