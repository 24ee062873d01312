//! Irradiance over the normals that are seen.

use super::brute::Brute;
use super::case::{Case, Role, Row};
use super::slope::{seen, DRAWN, SAMPLE, SOURCE};
use crate::environments::SKY;
use crate::report::Error;
use prefilter::reference::normals::average;
use prefilter::{Irradiance, IrradianceTier, Scene};

/// The sky by every tier.
///
/// # Errors
/// None: the sky is fixed.
pub fn cases(_: usize) -> Result<Vec<Case>, Error> {
    let sky = Irradiance::from_harmonics(SKY)?;
    let scene = || Scene::new("judged").irradiance(sky);
    let of = |tier: IrradianceTier| scene().irradiance_tier(tier).module();
    let plain = Scene::new("plain").irradiance(sky).irradiance_tier(IrradianceTier::Normal).module()?;
    let mut rows = vec![
        Row::of(Role::Naive, "naive: the normal of the mean slope", of(IrradianceTier::Normal)?),
        Row::of(Role::Independent, "all slopes alike", of(IrradianceTier::FourGaussians)?).straight(),
    ];
    for tier in [IrradianceTier::Points, IrradianceTier::ThreeGaussians, IrradianceTier::FourGaussians] {
        rows.push(Row::of(Role::Tier, tier, of(tier)?));
    }
    let polynomial = sky.polynomial().map(|color| color.map(f64::from));
    Ok(vec![Case {
        stem: "irradiance_sky".to_owned(),
        map: "sky".to_owned(),
        rows: Row::with_default(rows, scene().module()?),
        drawn: DRAWN,
        share: 4,
        truth: Box::new(move |pixel| {
            average(&seen(pixel), |[sx, sy]| {
                let length = (1.0 + sx * sx + sy * sy).sqrt();
                let axes = pixel.frame;
                let [x, y, z] = [0, 1, 2].map(|i| (axes[2][i] - sx * axes[0][i] - sy * axes[1][i]) / length);
                let terms = [1.0, x, y, z, x * x, x * y, y * y, x * z, y * z];
                let sum = |channel: usize| polynomial.iter().zip(terms).map(|(c, term)| c[channel] * term).sum();
                [sum(0), sum(1), sum(2), 0.0]
            })
        }),
        sources: vec![SOURCE, include_str!("irradiance.rs"), include_str!("../../environments.rs")],
        brute: Brute {
            modules: vec![plain],
            parameters: "mean_slope: vec2f, slope_covariance: vec3f, view: vec3f, x: vec3f, y: vec3f, z: vec3f",
            before: String::new(),
            sample: SAMPLE.to_owned() + "let color = plain_irradiance(slope, vec3f(), view, x, y, z);",
        },
    }])
}
