//! The share that is lit, on the device against quadratures.

use prefilter::gpu::Device;
use prefilter::reference::visibility::shadowing;
use prefilter::{HeightTier, Microsurface, Ranges, Scene};
use spirv_tests::exports::ExportKernel;
use spirv_tests::maps::named;
use spirv_tests::random::Random;

use crate::{calls, covariance, direction, lambda, Outcome};

/// What the shares of the seen that are lit are off by, with both grades of Λ.
#[test]
fn visibility_is_the_share_that_is_lit() -> Outcome {
    let device = Device::new()?;
    let bands = named("steps6")?;
    for (tier, figure) in [(HeightTier::Gaussian, 1e-4), (HeightTier::Exact, 4e-6)] {
        let module = Scene::new("rock").height(bands.clone()).height_tier(tier).module()?;
        let export = &module.exports()[1];
        assert_eq!(export.signature, "fn rock_visibility(slope_covariance: vec3f, view: vec3f, light: vec3f) -> f32");
        let calls = calls(&mut Random::new(3), &bands, Ranges::default(), 1e-2, 4000);
        let numbers: Vec<f32> = calls.iter().flat_map(|call| call.numbers[2..].to_vec()).collect();
        let shares = ExportKernel::new(&device, &module, export)?.run(&numbers)?;
        let mut worst = 0.0f64;
        assert_eq!(shares.len(), calls.len());
        for (share, numbers) in shares.iter().zip(numbers.chunks_exact(9)) {
            let triple = |at: usize| [numbers[at], numbers[at + 1], numbers[at + 2]];
            let truth = shadowing(lambda(triple(3), triple(0)), lambda(triple(6), triple(0)));
            assert!((0.0..=1.0).contains(&share[0]));
            worst = worst.max((f64::from(share[0]) - truth).abs());
        }
        println!("{tier}: the share that is lit errs by {worst:.2e}");
        assert!(worst <= figure, "{worst}");
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
