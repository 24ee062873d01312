//! Have singular footprints a minor deviation of next to nothing on devices that divide by a reciprocal?
//!
//! WGSL lets a quotient be 2.5 units in the last place off, and each component of a vector by a part of its own.

use std::f64::consts::PI;

use prefilter::gpu::Device;
use spirv_tests::kernel::Function;

/// Parts by which quotients of three components are off, and of one.
const OFF: [(&str, &str); 3] = [
    ("vec3f(1.0)", "1.0"),
    ("vec3f(1.0000003, 0.9999997, 1.0000003)", "1.0000003"),
    ("vec3f(0.9999997, 1.0, 0.9999997)", "0.9999997"),
];

/// `footprint_deviations` with quotients off by such parts.
fn off((three, one): (&str, &str)) -> Result<Function, String> {
    const NAME: &str = "footprint_deviations";
    let found = prefilter_wgsl::mentioned(NAME).into_iter().find(|(_, declaration)| declaration.name == NAME);
    let text = found.ok_or("no such function")?.1.text.replace(NAME, "off");
    let vectors = text.replace("covariance / ", &format!("covariance * {three} / "));
    let text = vectors.replace("1.0 / ", &format!("{one} / ")).replace(") / ", &format!(") * {one} / "));
    assert!(text.matches(one).count() >= 2, "{text}");
    Function::in_text(&text, "off")
}

/// As its contract promises: up to 4e-4 of the major one.
#[test]
fn singular_footprints_are_thin_by_every_quotient_that_wgsl_permits(
) -> Result<(), Box<dyn std::error::Error + Send + Sync>> {
    let device = Device::new()?;
    let lines: Vec<Vec<f64>> = (0..20_000)
        .map(|turn| {
            let (sin, cos) = (PI * f64::from(turn) / 20_000.0).sin_cos();
            let long = 1e-4 * 1.001f64.powi(turn);
            [cos * cos, cos * sin, sin * sin].map(|entry| f64::from((long * entry) as f32)).to_vec()
        })
        .collect();
    for factors in OFF {
        let found = off(factors)?.results(&device, &[], &lines)?;
        assert_eq!(found.len(), lines.len());
        let worst = found.iter().map(|deviations| deviations[1] / deviations[0]).fold(0.0, f64::max);
        println!("{factors:?}: {worst:.2e}");
        assert!(worst <= 4e-4, "{factors:?}: {worst:e}");
    }
    Ok(())
}
