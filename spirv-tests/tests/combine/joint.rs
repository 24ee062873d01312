//! Are maps of height and steepness sums of a few products, and filtered as such?

use prefilter::gpu::Device;
use prefilter::reference::footprint::variance_along;
use prefilter::reference::slopes::Visible;
use prefilter::reference::smith::lambda;
use prefilter::reference::texture::PiecewiseLinear;
use prefilter::reference::{height, steepness};
use prefilter::{Combination, JointMap, Microsurface, Scene};
use spirv_tests::random::Random;

use crate::{run, Fault, Outcome};

const HEIGHTS: [f32; 5] = [0.0, 0.4, 0.5, 0.7, 1.0];
const STEEPNESSES: [f32; 5] = [0.0, 0.3, 0.5, 0.8, 1.2];

/// Snow that is high and flat, with grass below and rock where it is steep.
fn snow(height: f32, steepness: f32) -> [f32; 3] {
    let between = |value: f32, low: f32, high: f32| ((value - low) / (high - low)).clamp(0.0, 1.0);
    let (high, steep) = (between(height, 0.4, 0.7), between(steepness, 0.3, 0.8));
    let mix = |a: [f32; 3], b: [f32; 3], part: f32| std::array::from_fn(|i| a[i] + part * (b[i] - a[i]));
    mix(mix([0.15, 0.3, 0.08], [0.95, 0.95, 1.0], high), mix([0.3, 0.22, 0.15], [0.45, 0.42, 0.4], high), steep)
}

fn map() -> Result<JointMap, prefilter::Error> {
    JointMap::new(HEIGHTS, STEEPNESSES, snow)
}

/// The mean of the whole map: over heights for every steepness of a node, over slopes of what those make.
fn truth(visible: &Visible, mean: f64, deviation: f64) -> Result<[f64; 4], Fault> {
    let away = libm::hypot(visible.view[0], visible.view[1]);
    let along = [visible.view[0] / away, visible.view[1] / away];
    let seen = lambda(visible.view[2] / away / variance_along(visible.covariance, along).sqrt());
    let piecewise = |knots: Vec<(f64, [f64; 4])>| PiecewiseLinear {
        knots: knots.into_iter().map(|(at, color)| (at, color, color)).collect(),
    };
    let column = |steepness: f32| {
        let knots = HEIGHTS.map(|at| {
            let [r, g, b] = snow(at, steepness).map(f64::from);
            (f64::from(at), [r, g, b, 0.0])
        });
        (f64::from(steepness), height::mean(&piecewise(knots.to_vec()), mean, deviation, seen))
    };
    Ok(steepness::mean(&piecewise(STEEPNESSES.map(column).to_vec()), visible))
}

#[test]
fn snow_that_is_high_and_flat_is_a_sum_of_two_products() -> Outcome {
    let errors = map()?.errors().to_vec();
    println!("largest error by one to four products: {errors:?}");
    // Grass and snow, grass rock and snow rock: a 2 × 2 table of colors blended both ways.
    assert!(errors[0] > 0.05 && errors[1] < 1e-6 && errors.windows(2).all(|pair| pair[1] <= pair[0] + 1e-7));
    Ok(())
}

/// Against the mean of the whole map over the heights and slopes that are seen, taken one after the other.
#[test]
fn products_keep_the_bound_of_their_layers() -> Outcome {
    let device = Device::new()?;
    let flat = Microsurface { shadowing: false, ..Microsurface::default() };
    let scene = Scene::new("peak").combination(map()?.combination("snow", 2)?).microsurface(flat);
    let module = scene.module()?;
    let mut random = Random::new(0x50);
    let case = |_| {
        let [x, y] = [0, 1].map(|_| random.between(0.15, 0.3));
        let covariance = [x * x, 0.5 * x * y * (2.0 * random.unit() - 1.0), y * y];
        let mean = [0.4 * random.unit() - 0.2, 0.4 * random.unit() - 0.2];
        let (z, azimuth) = (0.3 + 0.7 * random.unit(), std::f64::consts::TAU * random.unit());
        let radius = (1.0 - z * z).sqrt();
        let view = [radius * azimuth.cos(), radius * azimuth.sin(), z];
        let round = |value: f64| f64::from(value as f32);
        let visible = Visible { view: view.map(round), covariance: covariance.map(round), mean: mean.map(round) };
        (visible, round(random.unit()), round(random.between(0.02, 0.4)))
    };
    let cases: Vec<_> = (0..200).map(case).collect();
    let colors = run(&device, &module, "peak_combined", cases.len(), |point, name| match name {
        "mean" => vec![cases[point].1],
        "deviation" => vec![cases[point].2],
        "mean_slope" => cases[point].0.mean.to_vec(),
        "slope_covariance" => cases[point].0.covariance.to_vec(),
        "view" => cases[point].0.view.to_vec(),
        _ => vec![f64::NAN],
    })?;
    let mut worst = 0.0f64;
    for ((visible, mean, deviation), color) in cases.iter().zip(&colors) {
        let truth = truth(visible, *mean, *deviation)?;
        for channel in 0..3 {
            let error = (f64::from(color[channel]) - truth[channel]).abs();
            assert!(error < module.bound().value().into(), "{error:e} {visible:?} {mean} {deviation}");
            worst = worst.max(error);
        }
    }
    println!("the worst of 200 views {worst:.1e}, {}", module.bound());
    // A step of steepness errs by 0.105 where axes are as 1 to 2, and this map varies by 0.3.
    assert!(worst < 0.035, "{worst:e}");
    Ok(())
}

#[test]
fn refuses_what_is_no_joint_map() -> Outcome {
    let gray = |_: f32, _: f32| [0.5; 3];
    for (heights, steepnesses, what) in [
        (vec![0.0], vec![0.0, 1.0], "heights"),
        (vec![0.0, 1.0], vec![1.0, 1.0], "steepnesses"),
        (vec![0.0, f32::NAN], vec![0.0, 1.0], "heights"),
    ] {
        let error = JointMap::new(heights, steepnesses, gray).map(|_| ()).expect_err(what);
        assert!(error.to_string().contains(what), "{error}");
    }
    assert!(JointMap::new([0.0, 1.0], [0.0, 1.0], |_, _| [f32::INFINITY; 3]).is_err());
    let map = JointMap::new([0.0, 1.0], [0.0, 1.0], gray)?;
    assert!(map.errors()[0] < 1e-6 && map.combination("gray", 0).is_err() && map.combination("gray", 5).is_err());
    assert!(Scene::new("peak").combination(map.combination("gray", 1)?).module().is_ok());
    let bare = Combination::channel(&Scene::new("bare"), 0);
    assert!(bare.is_err_and(|error| error.to_string() == "`bare` has no color map, whose channel could be a weight"));
    Ok(())
}
