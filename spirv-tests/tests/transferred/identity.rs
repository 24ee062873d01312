//! The curve h = f leaves every filter as it is, by every tier.

use prefilter::gpu::Device;
use prefilter::{
    ColorMap, HeightTier, HeightTransfer, Irradiance, Kernel, Scene, SlopeDomain, SlopeMap, SlopeTaps, SlopeTier, Tier,
    TransferTier,
};
use spirv_tests::exports::ExportKernel;
use spirv_tests::maps::named;
use spirv_tests::random::Random;

use crate::Outcome;

const FAST: Tier = Tier::ClosedForm(Kernel::Fast);

/// What halves of a table of nodes add to slopes and what a table of heights adds to colors, between its slices.
const STORED: f32 = 2e-2;

/// A statistic or a direction of an export, by the name of its parameter.
fn number(random: &mut Random, name: &str) -> Vec<f32> {
    let unit = |random: &mut Random| random.unit() as f32;
    let upper = |random: &mut Random| {
        let (z, azimuth) = (0.15 + 0.8 * unit(random), 6.2 * unit(random));
        let radius = (1.0 - z * z).sqrt();
        vec![radius * azimuth.cos(), radius * azimuth.sin(), z]
    };
    match name {
        "mean" => vec![unit(random)],
        "deviation" => vec![0.02 + 0.3 * unit(random)],
        "mean_slope" => vec![0.4 * unit(random) - 0.2, 0.4 * unit(random) - 0.2],
        "slope_covariance" => {
            let (x, y) = (0.2 + 0.3 * unit(random), 0.2 + 0.3 * unit(random));
            vec![x * x, x * y * (unit(random) - 0.5), y * y]
        }
        "view" | "light" => upper(random),
        "direction" => {
            let azimuth = 6.2 * unit(random);
            vec![azimuth.cos(), azimuth.sin()]
        }
        "x" => vec![0.0, 1.0, 0.0],
        "y" => vec![0.0, 0.0, 1.0],
        _ => vec![1.0, 0.0, 0.0],
    }
}

/// The largest difference of each export of a scene with the curve from that without.
fn apart(device: &Device, scene: &Scene, curved: &Scene, tier: TransferTier) -> Result<f32, prefilter::Error> {
    let plain = scene.module()?;
    let curve = HeightTransfer::power(1.0)?.over((-0.5, 1.5), 0.5);
    let curved = curved.clone().transfer(curve).transfer_tier(tier).module()?;
    let mut largest = 0.0f32;
    for export in plain.exports() {
        let Some(other) = curved.exports().iter().find(|other| other.name == export.name) else {
            return Err(prefilter::Error::Conflict(format!("no {}", export.name)));
        };
        let (mut points, mut others, mut random) = (Vec::new(), Vec::new(), Random::new(7));
        for _ in 0..2000 {
            let values: Vec<(&str, Vec<f32>)> =
                other.parameters().iter().map(|(name, _)| (*name, number(&mut random, name))).collect();
            let of = |name: &str| values.iter().find(|(own, _)| *own == name).map_or(&[][..], |(_, value)| value);
            let textures = |kind: &str| kind.starts_with("texture") || kind == "sampler";
            for (name, _) in export.parameters().iter().filter(|(_, kind)| !textures(kind)) {
                points.extend(of(name));
            }
            for (name, _) in other.parameters().iter().filter(|(_, kind)| !textures(kind)) {
                others.extend(of(name));
            }
        }
        let expected = ExportKernel::new(device, &plain, export)?.run(&points)?;
        let found = ExportKernel::new(device, &curved, other)?.run(&others)?;
        for (expected, found) in expected.iter().zip(found) {
            for channel in 0..4 {
                // Written so that NaN is larger.
                let apart = (expected[channel] - found[channel]).abs();
                largest = if apart <= largest { largest } else { apart };
            }
        }
    }
    Ok(largest)
}

#[test]
fn every_filter_stays_as_it_is() -> Outcome {
    let device = Device::new()?;
    let map = named("terrain")?;
    let sky =
        Irradiance::from_harmonics(std::array::from_fn(|order| [0.9, 0.7, 0.5].map(|part| part / (order + 1) as f32)))?;
    let wheel =
        SlopeMap::from_function(64, SlopeDomain::All, |[x, y]| [0.5 + 0.3 * x.atan(), 0.5 + 0.3 * y.atan(), 0.5])?;
    let smooth = ColorMap::gradient([(-0.6, [0.1, 0.8, 0.3]), (0.6, [0.9, 0.2, 0.4])])?;
    let rock = || Scene::new("rock").height(map.clone());
    let rest = [
        Scene::new("dune").slope(smooth.clone()).slope_tier(SlopeTier::Pair).tier(FAST),
        Scene::new("aspect").slope_map(wheel).slope_tier(SlopeTier::Pair).slope_taps(SlopeTaps::Three),
        Scene::new("cliff").steepness(smooth),
        Scene::new("hill").irradiance(sky),
    ];
    // Nodes bring a tier of heights of their own.
    let heights = [(rock().height_tier(HeightTier::Skewed), rock())];
    for (scene, curved) in rest.map(|scene| (scene.clone(), scene)).into_iter().chain(heights) {
        for tier in [TransferTier::Paper, TransferTier::TwoNodes, TransferTier::ThreeNodes, TransferTier::FourNodes] {
            let apart = apart(&device, &scene, &curved, tier)?;
            println!("{tier}: {apart:.1e}");
            assert!(apart < STORED, "{tier}: {apart:e}");
        }
    }
    Ok(())
}
