//! Do color and light that depend on the same slopes come out averaged together?

use std::f64::consts::{PI, TAU};

use prefilter::gpu::Device;
use prefilter::reference::combine::{mean, node};
use prefilter::reference::slopes::Visible;
use prefilter::reference::texture::PiecewiseLinear;
use prefilter::{ColorMap, Irradiance, IrradianceTier, Microsurface, Module, Reflectance, Scene};
use spirv_tests::environments::GRACE;
use spirv_tests::random::Random;

use crate::{run, Fault, Outcome};

/// A surface, seen and lit from above the horizon of the mean plane.
struct Case {
    visible: Visible,
    light: [f64; 3],
    direction: [f64; 2],
}

fn single<const N: usize>(values: [f64; N]) -> [f64; N] {
    values.map(|value| f64::from(value as f32))
}

fn cases(count: usize) -> Vec<Case> {
    let mut random = Random::new(0x1ead);
    let upper = |random: &mut Random, least: f64| {
        let (z, azimuth) = (least + (1.0 - least) * random.unit(), TAU * random.unit());
        let radius = (1.0 - z * z).sqrt();
        single([radius * azimuth.cos(), radius * azimuth.sin(), z])
    };
    let case = |_| {
        let [x, y] = [0, 1].map(|_| random.between(0.15, 0.7));
        let covariance = single([x * x, 0.7 * (2.0 * random.unit() - 1.0) * x * y, y * y]);
        let mean = single([0.8 * random.unit() - 0.4, 0.8 * random.unit() - 0.4]);
        let (view, light) = (upper(&mut random, 0.09), upper(&mut random, 0.05));
        let turn = TAU * random.unit();
        let visible = Visible { view, covariance, mean };
        Case { visible, light, direction: single([turn.cos(), turn.sin()]) }
    };
    (0..count).map(case).collect()
}

/// The numbers of a parameter: the tangent frame is the world's.
fn number(case: &Case, name: &str) -> Vec<f64> {
    match name {
        "mean_slope" => case.visible.mean.to_vec(),
        "slope_covariance" => case.visible.covariance.to_vec(),
        "view" => case.visible.view.to_vec(),
        "light" => case.light.to_vec(),
        "direction" => case.direction.to_vec(),
        "x" => vec![1.0, 0.0, 0.0],
        "y" => vec![0.0, 1.0, 0.0],
        "z" => vec![0.0, 0.0, 1.0],
        "radiance" => vec![PI; 3],
        _ => vec![f64::NAN],
    }
}

fn normal([x, y]: [f64; 2]) -> [f64; 3] {
    let length = (1.0 + x * x + y * y).sqrt();
    [-x / length, -y / length, 1.0 / length]
}

type Light = Box<dyn Fn(&Case, [f64; 2]) -> [f64; 3]>;

/// A color and a light over slopes, and the edges of the color along the direction.
struct Judged<'a> {
    module: &'a Module,
    /// The export that averages both, and that of the light alone in a module of its own.
    export: &'a str,
    bare: &'a Module,
    of: &'a str,
    map: PiecewiseLinear,
    steep: bool,
    light: Light,
}

/// Root mean squares over the cases and channels of what the product of both exact means errs by, that of the means on
/// the device, and the mean of the product there.
fn errors(device: &Device, judged: &Judged<'_>) -> Result<[f64; 3], Fault> {
    let cases = cases(120);
    let at = |point: usize, name: &str| number(&cases[point], name);
    let colors = run(device, judged.module, "rock_combined", cases.len(), at)?;
    let lights = run(device, judged.bare, judged.of, cases.len(), at)?;
    let lit = run(device, judged.module, judged.export, cases.len(), at)?;
    let edges: Vec<f64> = if judged.steep { Vec::new() } else { judged.map.knots.iter().map(|knot| knot.0).collect() };
    let mut squares = [0.0; 3];
    for (point, (case, lit)) in cases.iter().zip(&lit).enumerate() {
        let color = |slope: [f64; 2]| {
            let along = if judged.steep {
                libm::hypot(slope[0], slope[1])
            } else {
                slope[0] * case.direction[0] + slope[1] * case.direction[1]
            };
            judged.map.value(along)
        };
        let all: [f64; 9] = mean(&case.visible, case.direction, &edges, |slope| {
            let (c, l) = (color(slope), (judged.light)(case, slope));
            std::array::from_fn(|at| match at / 3 {
                0 => c[at % 3],
                1 => l[at % 3],
                _ => c[at % 3] * l[at % 3],
            })
        });
        for channel in 0..3 {
            let truth = all[6 + channel];
            // Lambert's cosine is one number.
            let light = lights[point][if judged.of.ends_with("lambert") { 0 } else { channel }];
            let product = f64::from(colors[point][channel]) * f64::from(light);
            let found = [all[channel] * all[3 + channel], product, f64::from(lit[channel])];
            squares.iter_mut().zip(found).for_each(|(square, found)| *square += (found - truth).powi(2));
            assert!(lit[channel].is_finite());
        }
    }
    Ok(squares.map(|sum: f64| (sum / (3 * cases.len()) as f64).sqrt()))
}

/// What a user does otherwise, multiplying both exports, errs by three times as much and more.
#[test]
fn light_and_color_are_averaged_together() -> Outcome {
    let device = Device::new()?;
    let sky = Irradiance::from_harmonics(GRACE)?;
    let flat = Microsurface { shadowing: false, ..Microsurface::default() };
    let step = ColorMap::gradient([(0.05, [0.1, 0.2, 0.9]), (0.05, [0.8, 0.7, 0.1])])?;
    let ramp = ColorMap::gradient([(-0.4, [0.1, 0.2, 0.9]), (0.4, [0.8, 0.7, 0.1])])?;
    let cliff = ColorMap::gradient([(0.4, [0.1, 0.2, 0.9]), (0.8, [0.8, 0.7, 0.1])])?;
    let sloped = |map: &ColorMap| Scene::new("layer").slope(map.clone());
    let layers = [
        ("a step", sloped(&step), &step, false),
        ("a ramp", sloped(&ramp), &ramp, false),
        ("steepness", Scene::new("layer").steepness(cliff.clone()), &cliff, true),
    ];
    let bare = Scene::new("rock").irradiance(sky).irradiance_tier(IrradianceTier::FourGaussians).module()?;
    for (name, layer, map, steep) in layers {
        let scene = Scene::new("rock").combination(&layer).microsurface(flat);
        let module = scene.irradiance(sky).reflectance(Reflectance::Lambert).module()?;
        for (export, of, light) in [
            ("rock_lit", "rock_irradiance", Box::new(move |_: &Case, slope| environment(&sky, slope)) as Light),
            ("rock_radiance", "rock_lambert", Box::new(cosine)),
        ] {
            let judged = Judged { module: &module, export, bare: &bare, of, map: map.reference(), steep, light };
            let [exact, apart, together] = errors(&device, &judged)?;
            println!("{export} of {name}: exact means apart {exact:.2e}, apart {apart:.2e}, together {together:.2e}");
            assert!(together <= apart / 3.0, "{export} of {name}");
        }
    }
    Ok(())
}

fn environment(sky: &Irradiance, slope: [f64; 2]) -> [f64; 3] {
    sky.value(normal(slope).map(|part| part as f32)).map(f64::from)
}

fn cosine(case: &Case, slope: [f64; 2]) -> [f64; 3] {
    let facing: f64 = normal(slope).iter().zip(case.light).map(|(n, l)| n * l).sum();
    [facing.max(0.0); 3]
}

#[test]
fn nodes_have_the_moments_of_what_they_stand_for() {
    for skewness in [0.0, 0.3, 0.63, 1.0] {
        let nodes = [0, 1, 2, 3, 4].map(|number| node(number, skewness));
        let sum = |of: &dyn Fn(&[f64; 3]) -> f64| nodes.iter().map(|node| node[2] * of(node)).sum::<f64>();
        let close = |value: f64, expected: f64| assert!((value - expected).abs() < 1e-12, "{value} is not {expected}");
        close(sum(&|_| 1.0), 1.0);
        for (first, second) in [(0, 0), (0, 1), (1, 1)] {
            close(sum(&|node| node[first]), 0.0);
            let own = if first == second { 0.49 } else { 0.0 };
            close(own + sum(&|node| node[first] * node[second]), if first == second { 1.0 } else { 0.0 });
        }
        close(sum(&|node| node[0].powi(3)), 0.75 * skewness);
        close(sum(&|node| node[1].powi(3)), 0.0);
    }
}
