//! What the documentation of slopes says of a BRDF's roughness, by the distributions themselves.

use std::f64::consts::PI;

use prefilter::reference::quadrature::integrate;

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
