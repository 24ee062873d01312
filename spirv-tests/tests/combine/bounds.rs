//! Do combinations that nobody chose keep their bounds?

use std::f64::consts::TAU;

use prefilter::gpu::Device;
use prefilter::reference::slopes::Visible;
use prefilter::reference::smith::Along;
use prefilter::reference::{height, percentile, slope, steepness, texture};
use prefilter::{ColorMap, Combination, HeightTier, Kernel, Microsurface, Scene, SlopeTier, Tier};
use spirv_tests::random::Random;

use crate::{run, Fault, Outcome};

/// What a layer's color is the mean over.
#[derive(Clone, Copy, PartialEq)]
enum Kind {
    Values(usize),
    Heights,
    Percentiles,
    Component,
    Length,
}

/// A layer and what is known of it.
struct Layer {
    kind: Kind,
    map: ColorMap,
    scene: Scene,
}

/// What a pixel knows.
struct Point {
    values: [[f64; 2]; 2],
    heights: [f64; 2],
    visible: Visible,
    light: [f64; 3],
    direction: [f64; 2],
    weight: f64,
}

fn single<const N: usize>(values: [f64; N]) -> [f64; N] {
    values.map(|value| f64::from(value as f32))
}

/// Three or four channels from −1 to 2, smooth or with a hard edge; bands alone have none between.
fn map(random: &mut Random, channels: usize, low: f32, high: f32, bands: bool) -> Result<ColorMap, Fault> {
    let mut color = || [(); 4].map(|()| (3.0 * random.unit() - 1.0) as f32);
    let middle = 0.5 * (low + high);
    let [a, b, c] = [color(), color(), color()];
    let three = |[r, g, b, _]: [f32; 4]| [r, g, b];
    Ok(match (channels, bands) {
        (3, true) => ColorMap::bands(three(a), [(middle, three(b))])?,
        (3, false) => ColorMap::gradient([(low, three(a)), (middle, three(b)), (middle, three(c)), (high, three(a))])?,
        (_, true) => ColorMap::bands(a, [(middle, b)])?,
        (_, false) => ColorMap::gradient([(low, a), (middle, b), (high, c)])?,
    })
}

fn layer(random: &mut Random, kind: Kind, channels: usize) -> Result<Layer, Fault> {
    let banded = kind == Kind::Heights && random.pick([true, false]);
    let [low, high] = match kind {
        Kind::Component => [-0.5, 0.4],
        Kind::Length => [0.2, 0.9],
        _ => [0.1, 0.9],
    };
    let map = map(random, channels, low, high, banded)?;
    let of = map.clone();
    let scene = match kind {
        Kind::Values(at) => {
            let tier = random.pick([Tier::Table, Tier::ClosedForm(Kernel::Fast), Tier::ClosedForm(Kernel::Exact)]);
            Scene::new(["grain", "moss"][at]).texture(of).tier(tier)
        }
        Kind::Heights if banded => Scene::new("high").height(of).height_tier(HeightTier::Exact),
        Kind::Heights => {
            let tier = random.pick([
                HeightTier::Gaussian,
                HeightTier::ClosedFormFast,
                HeightTier::ClosedForm,
                HeightTier::Skewed,
            ]);
            Scene::new("high").height(of).height_tier(tier)
        }
        Kind::Percentiles => Scene::new("share").height_percentile(of),
        Kind::Component => Scene::new("sand").slope(of).slope_tier(random.pick([SlopeTier::Gaussian, SlopeTier::Pair])),
        Kind::Length => {
            Scene::new("rock").steepness(of).slope_tier(random.pick([SlopeTier::Gaussian, SlopeTier::Pair]))
        }
    };
    Ok(Layer { kind, map, scene })
}

impl Layer {
    /// The mean over what is seen, and lit where there are shadows.
    fn mean(&self, point: &Point, shadowing: bool) -> [f64; 4] {
        let map = self.map.reference();
        let along = |direction| Along::new(direction, point.visible.covariance, [0.0; 2]).lambda();
        let lambda = || along(point.visible.view) + if shadowing { along(point.light) } else { 0.0 };
        match self.kind {
            Kind::Values(at) => texture::mean(&map, point.values[at][0], point.values[at][1]),
            Kind::Heights => height::mean(&map, point.heights[0], point.heights[1], lambda()),
            Kind::Percentiles => percentile::mean(&map, lambda()),
            Kind::Component => slope::mean(&map, &point.visible, point.direction),
            Kind::Length => steepness::mean(&map, &point.visible),
        }
    }
}

fn point(random: &mut Random) -> Point {
    let [x, y] = [0, 1].map(|_| random.between(0.2, 0.3));
    let covariance = [x * x, 0.6 * (random.unit() - 0.5) * x * y, y * y];
    let mean = [0.4 * random.unit() - 0.2, 0.4 * random.unit() - 0.2];
    let upper = |random: &mut Random| {
        let (z, azimuth) = (0.3 + 0.7 * random.unit(), TAU * random.unit());
        let radius = (1.0 - z * z).sqrt();
        single([radius * azimuth.cos(), radius * azimuth.sin(), z])
    };
    let view = upper(random);
    let turn = TAU * random.unit();
    let value = |random: &mut Random| single([1.2 * random.unit() - 0.1, random.between(1e-3, 0.45)]);
    Point {
        values: [value(random), value(random)],
        heights: single([random.unit(), random.between(0.02, 0.4)]),
        visible: Visible { view, covariance: single(covariance), mean: single(mean) },
        light: upper(random),
        direction: single([turn.cos(), turn.sin()]),
        weight: random.pick([-1.0, 1.0, 0.25]),
    }
}

fn numbers(point: &Point, name: &str) -> Vec<f64> {
    match name {
        "grain_mean" => vec![point.values[0][0]],
        "grain_deviation" => vec![point.values[0][1]],
        "moss_mean" => vec![point.values[1][0]],
        "moss_deviation" => vec![point.values[1][1]],
        "mean" => vec![point.heights[0]],
        "deviation" => vec![point.heights[1]],
        "mean_slope" => point.visible.mean.to_vec(),
        "slope_covariance" => point.visible.covariance.to_vec(),
        "view" => point.visible.view.to_vec(),
        "light" => point.light.to_vec(),
        "direction" => point.direction.to_vec(),
        "wetness" => vec![point.weight],
        _ => vec![f64::NAN],
    }
}

/// Products of up to four layers and a weight, of sums and differences, with layers mentioned twice and single
/// channels, against the same of the integral of each layer.
#[test]
fn random_combinations_keep_their_bounds() -> Outcome {
    const POINTS: usize = 40;
    let device = Device::new()?;
    let mut worst = 0.0f64;
    for seed in 0..24 {
        let mut random = Random::new(seed);
        let channels = random.pick([3, 4]);
        let kinds = [
            Kind::Values(0),
            Kind::Values(1),
            random.pick([Kind::Heights, Kind::Percentiles]),
            random.pick([Kind::Component, Kind::Length]),
        ];
        let layers = kinds.into_iter().map(|kind| layer(&mut random, kind, channels)).collect::<Result<Vec<_>, _>>()?;
        let [grain, moss, high, steep] = [0, 1, 2, 3].map(|at| &layers[at].scene);
        let (number, channel, shape) = ((4.0 * random.unit() - 2.0) as f32, random.word() as usize % 3, seed % 4);
        let mask = |scene: &Scene| Combination::channel(scene, channel);
        let wet = || Combination::weight("wetness");
        let combination = match shape {
            0 => wet()? * grain * (1.0 - moss) * high * steep,
            1 => mask(grain)? * (high - number * steep) + grain * (0.5 - wet()?),
            2 => (grain + moss) * mask(high)? * steep - wet()? * (number * moss - high),
            _ => mask(grain)? * mask(steep)? * (moss * wet()? - number) * high + steep,
        };
        let shadowing = random.pick([true, false]);
        let surface = Microsurface { shadowing, ..Microsurface::default() };
        let module = Scene::new("hills").combination(combination).microsurface(surface).module()?;
        let points: Vec<_> = (0..POINTS).map(|_| point(&mut random)).collect();
        let colors = run(&device, &module, "hills_combined", POINTS, |at, name| numbers(&points[at], name))?;
        for (point, color) in points.iter().zip(colors) {
            let means: Vec<_> = layers.iter().map(|layer| layer.mean(point, shadowing)).collect();
            for at in 0..channels {
                let [g, m, h, s] = [0, 1, 2, 3].map(|layer| means[layer][at]);
                let [gc, hc, sc] = [0, 2, 3].map(|layer| means[layer][channel]);
                let (w, n) = (point.weight, f64::from(number));
                let truth = match shape {
                    0 => w * g * (1.0 - m) * h * s,
                    1 => gc * (h - n * s) + g * (0.5 - w),
                    2 => (g + m) * hc * s - w * (n * m - h),
                    _ => gc * sc * (m * w - n) * h + s,
                };
                let part = (f64::from(color[at]) - truth).abs() / f64::from(module.bound().value());
                assert!(part <= 1.0, "seed {seed}: {part} of {}\n{}", module.bound(), module.explain());
                worst = worst.max(part);
            }
        }
    }
    println!("the largest error is {worst:.2} of its bound");
    Ok(())
}
