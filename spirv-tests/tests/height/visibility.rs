//! The share that is lit, on the device against quadratures.

use prefilter::gpu::Device;
use prefilter::reference::visibility::shadowing;
use prefilter::{Export, HeightTier, Microsurface, Ranges, Scene};
use spirv_tests::exports::ExportKernel;
use spirv_tests::maps::named;
use spirv_tests::random::Random;

use crate::{calls, covariance, direction, Call, Outcome};

/// What an export says that shares are within, and up to which correlation of slopes.
fn promised(export: &Export) -> Option<[f64; 2]> {
    let text = export.documentation.split_whitespace().collect::<Vec<_>>().join(" ");
    let number = |phrase: &str| {
        let (_, rest) = text.split_once(phrase)?;
        rest.split(' ').next()?.trim_end_matches('.').parse().ok()
    };
    Some([number("Within ")?, number("correlations up to ")?])
}

/// What the shares of the seen that are lit are off by, with both grades of Λ, with and without a hotspot: as the
/// export itself says, for all correlations that it names.
#[test]
fn visibility_is_the_share_that_is_lit() -> Outcome {
    let device = Device::new()?;
    let bands = named("steps6")?;
    for (tier, hotspot) in [HeightTier::Gaussian, HeightTier::Exact].into_iter().flat_map(|t| [(t, false), (t, true)]) {
        let surface = Microsurface { hotspot, ..Microsurface::default() };
        let module = Scene::new("rock").height(bands.clone()).height_tier(tier).microsurface(surface).module()?;
        let export = &module.exports()[1];
        assert_eq!(export.signature, "fn rock_visibility(slope_covariance: vec3f, view: vec3f, light: vec3f) -> f32");
        let [error, correlation] = promised(export).ok_or_else(|| export.documentation.clone())?;
        let mut random = Random::new(3);
        let mut calls = calls(&mut random, &bands, Ranges::default(), 1e-2, 1000);
        for call in calls.iter_mut().step_by(2) {
            let [xx, xy, yy] = call.three(2);
            let most = (correlation * (f64::from(xx) * f64::from(yy)).sqrt()) as f32;
            *call = Call::new(0.0, 1.0, [xx, most.copysign(xy), yy], call.three(5), call.three(8));
        }
        let numbers: Vec<f32> = calls.iter().flat_map(|call| call.numbers[2..].to_vec()).collect();
        let shares = ExportKernel::new(&device, &module, export)?.run(&numbers)?;
        let mut worst = 0.0f64;
        assert_eq!(shares.len(), calls.len());
        for (share, call) in shares.iter().zip(calls) {
            let seen = call.parts[0];
            let lit = if hotspot { call.hot().lambda - seen } else { call.parts[1] };
            assert!((0.0..=1.0).contains(&share[0]));
            worst = worst.max((f64::from(share[0]) - shadowing(seen, lit)).abs());
        }
        println!("{tier}, hotspot {hotspot}: the share that is lit errs by {worst:.2e} of {error:.1e}");
        assert!(worst <= error, "{worst}");
    }
    Ok(())
}

/// With the hotspot everything that is seen along the light is lit, and the colors are those without shadows.
#[test]
fn the_hotspot_is_lit() -> Outcome {
    let device = Device::new()?;
    let scene = Scene::new("moon").height(named("steps6")?);
    let hot = scene.clone().microsurface(Microsurface { hotspot: true, ..Microsurface::default() }).module()?;
    let dark = scene.microsurface(Microsurface { shadowing: false, ..Microsurface::default() }).module()?;
    assert_eq!(dark.exports().len(), 1);
    let mut random = Random::new(2);
    let (mut with_light, mut without, mut shares) = (Vec::new(), Vec::new(), Vec::new());
    for _ in 0..1000 {
        let (covariance, view) = (covariance(&mut random), direction(&mut random));
        without.extend([&[0.4, 0.2][..], &covariance, &view].concat());
        with_light.extend([&[0.4, 0.2][..], &covariance, &view, &view].concat());
        shares.extend([covariance, view, view].concat());
    }
    let lit = ExportKernel::new(&device, &hot, &hot.exports()[1])?.run(&shares)?;
    assert!(lit.len() == 1000 && lit.iter().all(|share| share[0] > 0.999_999), "{lit:?}");
    let colors = ExportKernel::new(&device, &hot, &hot.exports()[0])?.run(&with_light)?;
    let alone = ExportKernel::new(&device, &dark, &dark.exports()[0])?.run(&without)?;
    for (one, other) in colors.iter().zip(alone) {
        assert!((0..3).all(|channel| (one[channel] - other[channel]).abs() <= 1e-5), "{one:?} {other:?}");
    }
    Ok(())
}
