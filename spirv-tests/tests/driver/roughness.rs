//! What the documentation of slopes says of a BRDF's roughness, by the distributions themselves.

use std::f64::consts::PI;

use prefilter::gpu::Device;
use prefilter::reference::footprint::variance_along;
use prefilter::reference::quadrature::integrate;
use spirv_tests::kernel::Function;

/// The density at slope 0 of a round distribution whose slopes are joined by normal ones of the variance `added`.
fn peak(density: impl Fn(f64) -> f64, added: f64) -> f64 {
    let deviation = added.sqrt();
    let ring = |slope: f64| {
        let normal = libm::exp(-slope * slope / (2.0 * added)) / (2.0 * PI * added);
        [2.0 * PI * slope * density(slope) * normal]
    };
    integrate(0.0, 12.0 * deviation, 0.1 * deviation.min(1.0), ring)[0]
}

fn beckmann(squared: f64, slope: f64) -> f64 {
    libm::exp(-slope * slope / squared) / (PI * squared)
}

fn ggx(squared: f64, slope: f64) -> f64 {
    squared / (PI * (squared + slope * slope).powi(2))
}

/// Roughness 1: other ones are the same in units of it.
#[test]
fn roughness_takes_variance_in_as_documented() {
    let mut most = 0f64;
    for step in 0..=40 {
        let added = 10f64.powf(-2.0 + 0.1 * f64::from(step));
        let joined = peak(|slope| beckmann(1.0, slope), added);
        assert!((joined / beckmann(1.0 + 2.0 * added, 0.0) - 1.0).abs() < 1e-9, "{added}: {joined}");

        let joined = peak(|slope| ggx(1.0, slope), added);
        let convention = ggx(1.0 + 2.0 * added, 0.0) / joined;
        most = most.max(convention);
        println!("{added:.3}: {convention:.4}, {:.4}", ggx(1.0 + 4.0 * added, 0.0) / joined);
        assert!(convention > 1.0 && (added < 50.0 || convention < 1.05), "{added}: {convention}");
        // Where σ is far below α₀.
        assert!(added > 0.06 || (ggx(1.0 + 4.0 * added, 0.0) / joined - 1.0).abs() < 0.02, "{added}");
    }
    assert!((1.24..1.25).contains(&most), "{most}");
    // Where 2σ² = α₀².
    let even = ggx(2.0, 0.0) / peak(|slope| ggx(1.0, slope), 0.5);
    assert!((1.235..1.245).contains(&even), "{even}");
}

/// The density at a slope of Beckmann's distribution with slopes of a covariance added, by their sum over a grid.
fn joined(roughness: f64, [xx, xy, yy]: [f64; 3], slope: [f64; 2]) -> f64 {
    let (column, rest) = (xx.sqrt(), (yy - xy * xy / xx).sqrt());
    let at = |index: i32| 0.1 * f64::from(index);
    let mut sum = 0.0;
    for (u, v) in (-70..=70).flat_map(|u| (-70..=70).map(move |v| (at(u), at(v)))) {
        let added = [column * u, xy / column * u + rest * v];
        let rest = (slope[0] - added[0]).hypot(slope[1] - added[1]);
        sum += libm::exp(-0.5 * (u * u + v * v)) / (2.0 * PI) * beckmann(roughness * roughness, rest);
    }
    0.01 * sum
}

/// Both axes of the shelf with their direction are Beckmann's distribution with the slopes added, whatever the slope.
#[test]
fn the_shelf_is_beckmann_with_slopes_added() {
    let device = Device::new().unwrap();
    let text = "struct rough { alpha: vec2f, axis: vec2f, round: f32 }
    fn asked(roughness: f32, covariance: vec3f) -> rough {
        return rough(roughness_axes(roughness, footprint_deviations(covariance)), footprint_direction(covariance),
            roughness_round(roughness, covariance));
    }";
    let shelf = Function::in_text(text, "asked").unwrap();
    for (roughness, covariance) in [(0.5, [0.09, 0.05, 0.06]), (0.3, [0.02, 0.0, 0.2]), (0.4, [0.1, -0.03, 0.1])] {
        let got = shelf.results(&device, &[], &[vec![roughness, covariance[0], covariance[1], covariance[2]]]).unwrap();
        let &[major, minor, x, y, round] = got[0].as_slice() else { panic!("five numbers") };
        for slope in [[0.0, 0.0], [0.3, 0.1], [-0.2, 0.4], [0.1, -0.7]] {
            let along = [slope[0] * x + slope[1] * y, slope[1] * x - slope[0] * y];
            let square = (along[0] / major).powi(2) + (along[1] / minor).powi(2);
            let density = libm::exp(-square) / (PI * major * minor);
            let truth = joined(roughness, covariance, slope);
            assert!((density / truth - 1.0).abs() < 1e-5, "{covariance:?} {slope:?}: {density} {truth}");
        }
        // The same mean square of the slope: α² along both axes together.
        let square = 0.5 * (major * major + minor * minor);
        assert!((round * round / square - 1.0).abs() < 1e-6, "{round} {major} {minor}");
        assert!((variance_along(covariance, [x, y]) - 0.5 * (major.powi(2) - roughness.powi(2))).abs() < 1e-6);
    }
}
