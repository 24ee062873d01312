//! Values that are not normal: Beta distributions in a table and two normal ones, on a device against their integrals,
//! and what the former are worth for values that have ends.

use std::error::Error;

use prefilter::gpu::Device;
use prefilter::reference::beta::Beta;
use prefilter::reference::mixture::Pair;
use prefilter::reference::texture::{mean, PiecewiseLinear};
use prefilter::{
    Accuracy, ColorMap, Colors, Combination, Custom, Distribution, Driver, Error as Refused, Kernel, Moments, Noise,
    Ranges, Scene, Taps, Tier,
};
use spirv_tests::any::number;
use spirv_tests::exports::ExportKernel;
use spirv_tests::maps::named;
use spirv_tests::random::Random;

type Outcome = Result<(), Box<dyn Error + Send + Sync>>;

/// Mean and deviation, and the color that a device has for them.
type Read = ([f64; 2], [f64; 4]);

const MAPS: [&str; 4] = ["terrain", "gist_earth", "viridis", "steps6"];

fn largest(one: [f64; 4], other: [f64; 4]) -> f64 {
    (0..3).map(|channel| (one[channel] - other[channel]).abs()).fold(0.0, f64::max)
}

fn beta(low: f32, high: f32) -> Distribution {
    Distribution::Beta { low, high }
}

/// Means and deviations over the range and beyond it, and the colors that a module has for them.
fn read(device: &Device, scene: Scene, seed: u32) -> Result<Vec<Read>, Box<dyn Error + Send + Sync>> {
    let (module, Ranges { mean: (low, high), deviation }) = (scene.module()?, scene.chosen_ranges());
    let mut random = Random::new(seed);
    let span = f64::from(high - low);
    let point = |_| {
        let mean = f64::from(low) + span * (1.2 * random.unit() - 0.1);
        [mean as f32, (1.1 * f64::from(deviation) * random.unit().powi(3)) as f32]
    };
    let points: Vec<f32> = (0..1500).flat_map(point).collect();
    let colors = ExportKernel::new(device, &module, &module.exports()[0])?.run(&points)?;
    let pairs = points.chunks_exact(2).zip(colors);
    Ok(pairs.map(|(point, color)| ([point[0].into(), point[1].into()], color.map(f64::from))).collect())
}

#[test]
fn a_device_returns_means_over_beta_distributions_within_the_bound() -> Outcome {
    let device = Device::new()?;
    for (name, [low, high]) in MAPS.into_iter().zip([[0.0, 1.0], [-0.2, 0.9], [0.0, 1.0], [0.1, 1.3]]) {
        for colors in [Colors::Constant, Colors::Dynamic] {
            let (map, scene) = (named(name)?, Scene::new("judged").distribution(beta(low, high)).tier(Tier::Table));
            let scene = scene.texture(map.clone()).colors(colors);
            let (bound, map) = (f64::from(scene.module()?.bound().value()), map.reference());
            let (mut worst, ends) = (0.0_f64, [f64::from(low), f64::from(high)]);
            for ([mean, deviation], color) in read(&device, scene, 7)? {
                let truth = Beta::new(ends, mean, deviation.max(1e-6)).mean_by_parts(&map);
                let error = largest(color, truth);
                worst = if error.is_nan() { f64::INFINITY } else { worst.max(error) };
            }
            println!("{name}, {colors:?}: {worst:.2e} of {bound:.2e}");
            assert!(worst <= bound && worst > 0.0, "{name}: {worst} {bound}");
        }
    }
    Ok(())
}

/// Mean and variance of sin over a normal distribution of phases, and the mean color.
fn over_sine(map: &PiecewiseLinear, phase: f64, deviation: f64) -> ([f64; 2], [f64; 4]) {
    const STEPS: u32 = 20_000;
    let (mut total, mut sum) = (0.0, [0.0; 6]);
    for step in 0..STEPS {
        let z = 16.0 * (f64::from(step) + 0.5) / f64::from(STEPS) - 8.0;
        let (weight, value) = (libm::exp(-0.5 * z * z), libm::sin(phase + deviation * z));
        let color = map.value(0.5 + 0.5 * value);
        let parts = [value, value * value, color[0], color[1], color[2], color[3]];
        sum.iter_mut().zip(parts).for_each(|(sum, part)| *sum += weight * part);
        total += weight;
    }
    let [first, second, a, b, c, d] = sum.map(|sum| sum / total);
    ([0.5 + 0.5 * first, 0.25 * (second - first * first)], [a, b, c, d])
}

/// The figures of `Distribution::Beta`: color of a sine, half a unit about the middle of the map, over footprints of
/// these deviations in radians.
#[test]
fn sines_are_nearer_to_beta_distributions() -> Outcome {
    let (mut random, mut worst) = (Random::new(3), 0.0_f64);
    for (deviation, figures) in [(0.5, [0.038, 0.006]), (1.0, [0.071, 0.009]), (4.0, [0.065, 0.0])] {
        let (mut errors, mut count) = ([0.0; 2], 0.0);
        for name in MAPS {
            let map = named(name)?.reference();
            for _ in 0..64 {
                let ([middle, variance], truth) = over_sine(&map, std::f64::consts::TAU * random.unit(), deviation);
                let spread = variance.max(0.0).sqrt();
                let found = [mean(&map, middle, spread), Beta::new([0.0, 1.0], middle, spread).mean(&map)];
                errors.iter_mut().zip(found).for_each(|(sum, color)| *sum += largest(color, truth).powi(2));
                count += 1.0;
            }
        }
        let [normal, bounded] = errors.map(|sum: f64| (sum / count).sqrt());
        println!("sine, {deviation} radians: normal {normal:.4}, Beta {bounded:.4}");
        worst = worst.max((normal - figures[0]).abs()).max((bounded - figures[1]).abs());
    }
    assert!(worst < 6e-4, "{worst}");
    Ok(())
}

/// What a Beta table costs beside a normal one.
#[test]
fn a_module_says_what_it_holds_and_costs() -> Outcome {
    let scene =
        || Ok::<_, Box<dyn Error + Send + Sync>>(Scene::new("hill").texture(named("terrain")?).tier(Tier::Table));
    let (normal, bounded) = (scene()?.module()?, scene()?.distribution(beta(0.0, 1.0)).module()?);
    assert_eq!(normal.exports()[0].signature, bounded.exports()[0].signature);
    let [one, other] = [&normal, &bounded].map(|module| module.cost());
    println!("{one}; {other}");
    assert!(other.weight() <= one.weight() + 13 && other.table_bytes == one.table_bytes);
    for text in [bounded.wgsl().to_string(), bounded.explain().to_string()] {
        assert!(text.contains("a Beta distribution between 0 and 1"), "{text}");
    }
    Ok(())
}

/// The mean of a map over two normal distributions that have four moments together.
fn over_pair(map: &PiecewiseLinear, [middle, deviation, skewness, kurtosis]: [f64; 4]) -> [f64; 4] {
    let pair = Pair::with(skewness, kurtosis);
    let parts = [0, 1].map(|of| mean(map, middle + deviation * pair.offsets[of], deviation * pair.deviation));
    std::array::from_fn(|channel| pair.weights[0] * parts[0][channel] + pair.weights[1] * parts[1][channel])
}

#[test]
fn a_device_returns_means_over_two_normal_distributions() -> Outcome {
    let device = Device::new()?;
    let mut random = Random::new(13);
    let mut point = || {
        let skewness = 3.0 * random.unit() - 1.5;
        let kurtosis = skewness * skewness - 2.0 + random.between(0.05, 4.0);
        [random.unit(), random.between(1e-3, 0.5), skewness, kurtosis].map(|number| number as f32)
    };
    let points: Vec<f32> = (0..3000).flat_map(|_| point()).collect();
    for name in MAPS {
        let map = named(name)?;
        let scene = Scene::new("judged").texture(map.clone()).tier(Tier::ClosedForm(Kernel::Exact));
        let module = scene.distribution(Distribution::Pair).module()?;
        assert_eq!(module.exports()[1].name, "judged_pair");
        let found = ExportKernel::new(&device, &module, &module.exports()[1])?.run(&points)?;
        let mut worst = 0.0_f64;
        for (point, color) in points.chunks_exact(4).zip(&found) {
            let truth = over_pair(&map.reference(), std::array::from_fn(|number| point[number].into()));
            worst = worst.max(largest(color.map(f64::from), truth));
        }
        // A weight errs by 1e-7 or so, and an offset by as much of itself, times the steepest density of a step.
        println!("{name}: {worst:.2e}, of one distribution {:.2e}", module.bound().value());
        assert!(worst <= f64::from(module.bound().value()) + 3e-5 && worst > 0.0, "{name}: {worst}");
    }
    Ok(())
}

/// Skewness and excess kurtosis reach the filter from a driver, at one tap and at several, whose colors are averaged.
#[test]
fn drivers_say_the_shape() -> Outcome {
    let device = Device::new()?;
    let text = "fn skewed(position: vec2f, across: vec2f, along: vec2f) -> vec4f {
        return vec4f(0.45, 0.04, 0.9, -0.5);
    }";
    let map = named("terrain")?;
    let truth = over_pair(&map.reference(), [0.45, 0.2, 0.9, -0.5]);
    for taps in [Taps::One, Taps::Four] {
        let scene = Scene::new("hill").texture(map.clone()).tier(Tier::ClosedForm(Kernel::Exact));
        let scene = scene.driver(Driver::Custom(Custom { taps, ..Custom::new(text, "skewed") }));
        let normal = mean(&map.reference(), 0.45, 0.2);
        for (distribution, truth) in [(Distribution::Normal, normal), (Distribution::Pair, truth)] {
            let module = scene.clone().distribution(distribution).module()?;
            let export = module.exports().iter().find(|export| export.name == "hill_color").ok_or("no color")?;
            let color = ExportKernel::new(&device, &module, export)?.run(&[0.3, 0.2, 0.1, 0.0, 0.0, 0.1])?[0];
            assert!(largest(color.map(f64::from), truth) < 2e-5, "{color:?} {truth:?}");
        }
        assert!(largest(truth, normal) > 0.01);
    }
    let scene = Scene::new("hill").texture(map.clone()).distribution(Distribution::Pair);
    let unknown = scene.clone().driver(Driver::Noise(Noise::default())).module().expect_err("noise has no shape");
    assert!(unknown.to_string().contains("but not their shape"), "{unknown}");
    let images = scene.clone().driver(Driver::Moments(Moments::default())).module()?;
    assert!(images.wgsl().contains("return hill_pair(m.x, sqrt(max(m.y, 0.0)), m.z, m.w);"), "{}", images.wgsl());
    let layers = Scene::new("rock").combination(Combination::color([1.0; 3])? * &scene);
    let error = layers.module().expect_err("a layer has one distribution");
    assert!(error.to_string().contains("two normal distributions, of which layers have one"), "{error}");
    Ok(())
}

/// Ends of any place and width, about the map and far from it, make a finite table or an error.
#[test]
fn any_ends_are_a_table_or_an_error() -> Outcome {
    let mut random = Random::new(29);
    let map = ColorMap::gradient([(-0.5, [0.1, 0.5, 0.9]), (0.3, [0.9, 0.2, 0.1]), (0.3, [0.0; 3]), (2.0, [1.0; 3])])?;
    let mut made = 0;
    for _ in 0..48 {
        let any = [number(&mut random), number(&mut random)];
        let low = random.pick([-65504.0, -3.0, -0.5, 0.0, 0.29, 0.3, 2.0, 1000.0, any[0]]);
        let high = low + random.pick([0.0, 2e-3, 0.011, 1.0, 70.0, 1e5, any[1]]);
        match Scene::new("judged").texture(map.clone()).distribution(beta(low, high)).module() {
            Ok(module) => {
                let texels = &module.tables()[0].levels[0].texels;
                assert!(texels.iter().all(|texel| (0.0..=1.0).contains(texel)), "{low}, {high}");
                assert!(module.bound().value().is_finite(), "{low}, {high}");
                made += 1;
            }
            Err(error) => assert!(matches!(error, Refused::Value { .. }), "{low}, {high}: {error}"),
        }
    }
    assert!(made >= 10, "{made}");
    Ok(())
}

#[test]
fn what_does_not_go_with_the_distribution_is_refused() -> Outcome {
    let map = || named("terrain");
    let scene = || Ok::<_, Box<dyn Error + Send + Sync>>(Scene::new("hill").distribution(beta(0.0, 1.0)));
    let texture = || Ok::<_, Box<dyn Error + Send + Sync>>(scene()?.texture(map()?));
    let refused = [
        scene()?.height(map()?),
        scene()?.slope(map()?),
        scene()?.combination(Combination::color([1.0; 3])? * &Scene::new("sand").texture(map()?)),
        texture()?.tier(Tier::ClosedForm(Kernel::Exact)),
        texture()?.tier(Tier::Paper),
        texture()?.ranges(Ranges::default()),
        texture()?.accuracy(Accuracy::max_filter_error(0.1).without_tables()),
    ];
    for scene in refused {
        let error = scene.module().expect_err("the setting has no meaning");
        assert!(matches!(&error, Refused::Conflict(text) if text.contains("Beta distribution")), "{error}");
    }
    let swapped = Scene::new("hill").texture(map()?).distribution(beta(1.0, 0.0)).module();
    assert!(matches!(swapped, Err(Refused::Value { .. })));
    // What goes: a driver, dynamic colors, and a range beside the map.
    let far = Scene::new("hill").texture(map()?).distribution(beta(200.0, 900.0)).colors(Colors::Dynamic);
    assert!(far.module()?.explain().contains("means 200 to 900, deviations to 350"));
    let driven = texture()?.driver(Driver::Moments(Moments::default())).module()?;
    assert!(driven.explain().contains("from a Beta distribution"), "{}", driven.explain());
    let flat = ColorMap::gradient([(0.5, [0.2, 0.4, 0.6])])?;
    assert!(Scene::new("plain").texture(flat).distribution(beta(0.0, 1.0)).module().is_ok());
    Ok(())
}
