//! What exports return, against the parts of the surface without nodes.

use prefilter::gpu::Device;
use prefilter::reference::slope_nodes::{Along, Transferred};
use prefilter::{ColorMap, HeightTransfer, Kernel, Module, Ranges, Scene, SlopeTier, Tier, TransferTier};
use spirv_tests::exports::ExportKernel;
use spirv_tests::maps::named;
use spirv_tests::random::Random;

use crate::Outcome;

/// Curves with level parts, with turns and with bends.
fn curves() -> Result<Vec<HeightTransfer>, prefilter::Error> {
    Ok(vec![
        HeightTransfer::smoothstep(0.0, 1.2)?,
        HeightTransfer::smoothstep(-1.0, 1.0)?,
        HeightTransfer::terraces(3, 0.4)?,
        HeightTransfer::absolute(),
        HeightTransfer::samples(-1.0, 1.0, &[0.2, 0.9, 0.1, 0.4, 1.0])?,
    ])
}

/// How far hiding follows the steepness in what is seen of slopes: the notes of `wgsl/visibility/slope_nodes.wgsl`.
const FOLLOWS: f64 = 0.25;

/// A pixel: statistics of f, and the angles of view and light from the normal, the light on the other side.
struct Pixel {
    mean: f64,
    deviation: f64,
    mean_slope: f64,
    deviations: [f64; 2],
    view: f64,
    light: f64,
}

impl Pixel {
    fn random(random: &mut Random, curve: &HeightTransfer) -> Self {
        let Ranges { mean: (low, high), deviation } = Ranges::of_transfer(curve);
        Self {
            mean: f64::from(low) + f64::from(high - low) * random.unit(),
            // From the distance of two columns of the nodes on: below, a bend between two is misread.
            deviation: random.between(f64::from(high - low) / 63.0, deviation.into()),
            mean_slope: 0.0,
            deviations: [random.between(0.1, 0.8), random.between(0.1, 0.8)],
            view: 1.45 * random.unit(),
            light: 1.45 * random.unit(),
        }
    }

    fn surface(&self, curve: &HeightTransfer) -> Transferred {
        Transferred::new([self.mean, self.deviation], &curve.bends(), |f| curve.height(f), |f| curve.slope(f))
    }

    fn along(&self, angle: f64) -> Along {
        Along { angle, mean: self.mean_slope, deviation: self.deviations[0] }
    }

    /// The numbers of an export's parameters.
    fn numbers(&self, parameters: &[(&str, &str)]) -> Vec<f32> {
        let toward = |angle: f64, side: f64| vec![side * angle.sin(), 0.0, angle.cos()];
        let [along, across] = self.deviations;
        let of = |name: &str| match name {
            "mean" => vec![self.mean],
            "deviation" => vec![self.deviation],
            "mean_slope" => vec![self.mean_slope, 0.0],
            "slope_covariance" => vec![along * along, 0.0, across * across],
            "view" => toward(self.view, 1.0),
            "light" => toward(self.light, -1.0),
            "direction" => vec![1.0, 0.0],
            _ => Vec::new(),
        };
        parameters.iter().flat_map(|(name, _)| of(name)).map(|value| value as f32).collect()
    }
}

/// The largest difference of the first export from a truth, over random pixels.
fn worst(
    device: &Device,
    module: &Module,
    pixels: &[Pixel],
    truth: impl Fn(&Pixel) -> [f64; 3],
) -> Result<f64, prefilter::Error> {
    let export = &module.exports()[0];
    let points: Vec<f32> = pixels.iter().flat_map(|pixel| pixel.numbers(&export.parameters())).collect();
    let found = ExportKernel::new(device, module, export)?.run(&points)?;
    let (mut worst, mut squares) = (0.0, 0.0);
    for (pixel, found) in pixels.iter().zip(found) {
        for (truth, found) in truth(pixel).into_iter().zip(found) {
            let apart = (truth - f64::from(found)).abs();
            squares += apart * apart;
            // Written so that NaN is the worst.
            worst = if apart <= worst { worst } else { apart };
        }
    }
    println!("RMS {:.1e}", (squares / (3 * pixels.len()) as f64).sqrt());
    Ok(worst)
}

#[test]
fn colors_of_heights_are_those_of_what_is_visible() -> Outcome {
    let device = Device::new()?;
    let map = named("terrain")?;
    let reference = map.reference();
    for curve in curves()? {
        let module = Scene::new("moss").height(map.clone()).transfer(curve.clone()).module()?;
        let mut random = Random::new(3);
        let pixels: Vec<Pixel> = (0..400).map(|_| Pixel::random(&mut random, &curve)).collect();
        let worst = worst(&device, &module, &pixels, |pixel| {
            let surface = pixel.surface(&curve);
            let lambda = surface.lambda(pixel.along(pixel.view)) + surface.lambda(pixel.along(pixel.light));
            let mut color = [0.0; 3];
            for (part, share) in surface.parts.iter().zip(surface.visible_heights(lambda)) {
                let value = reference.value(part.height);
                color.iter_mut().zip(value).for_each(|(sum, channel)| *sum += share * channel);
            }
            color
        })?;
        println!("{:?}: {worst:.1e} of {:.1e}", curve.range(-1.0, 1.0), module.bound().value());
        assert!(worst <= f64::from(module.bound().value()), "{worst:e}: {}", module.explain());
    }
    Ok(())
}

#[test]
fn steps_of_slopes_are_within_the_bound() -> Outcome {
    let device = Device::new()?;
    for curve in curves()? {
        for edge in [-0.3f32, 0.05, 0.4] {
            let step = ColorMap::bands([0.0; 3], [(edge, [1.0; 3])])?;
            for tier in [TransferTier::TwoNodes, TransferTier::ThreeNodes, TransferTier::FourNodes] {
                let scene = Scene::new("moss").slope(step.clone()).slope_tier(SlopeTier::Pair);
                // Risers are up to four times as steep as f.
                let scene = scene.ranges(Ranges { mean: (-1.0, 1.0), deviation: 4.0 });
                let scene = scene.tier(Tier::ClosedForm(Kernel::Exact)).transfer(curve.clone()).transfer_tier(tier);
                let module = scene.module()?;
                let mut random = Random::new(5);
                let pixels: Vec<Pixel> = (0..400).map(|_| Pixel::random(&mut random, &curve)).collect();
                let worst = worst(&device, &module, &pixels, |pixel| {
                    let surface = pixel.surface(&curve);
                    let along = pixel.along(pixel.view);
                    let shares = surface.shares(along, surface.lambda(along), FOLLOWS);
                    [1.0 - surface.below(along, &shares, &[edge.into()])[0]; 3]
                })?;
                println!("{tier} {edge}: {worst:.1e} of {:.1e}", module.bound().value());
                assert!(worst <= f64::from(module.bound().value()), "{worst:e}: {}", module.explain());
            }
        }
    }
    Ok(())
}
