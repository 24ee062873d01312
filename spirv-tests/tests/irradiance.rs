//! Irradiance over visible normals on the device against quadratures, from a view to light.

use prefilter::gpu::Device;
use prefilter::reference::irradiance::{lambert, over};
use prefilter::reference::slopes::Visible;
use prefilter::{Colors, Irradiance, IrradianceTier, Scene};
use spirv_tests::any;
use spirv_tests::environments::GRACE;
use spirv_tests::exports::ExportKernel;
use spirv_tests::random::Random;

type Fault = Box<dyn std::error::Error + Send + Sync>;
type Outcome = Result<(), Fault>;

/// Radiance by order and degree, of red, green and blue.
type Harmonics = [[f32; 3]; 9];

/// The eucalyptus grove.
///
/// Source: Ramamoorthi and Hanrahan 2001, "An Efficient Representation for Irradiance Environment Maps", figure 2.
const EUCALYPTUS: Harmonics = [
    [0.38, 0.43, 0.45],
    [0.29, 0.36, 0.41],
    [0.04, 0.03, 0.01],
    [-0.10, -0.10, -0.09],
    [-0.06, -0.06, -0.04],
    [0.01, -0.01, -0.05],
    [-0.09, -0.13, -0.15],
    [-0.06, -0.05, -0.04],
    [0.02, 0.0, -0.05],
];

/// Order 2 of suns at 10, 30 and 60 degrees above the horizon, a channel each.
fn suns() -> Harmonics {
    let suns = [10.0f64, 30.0, 60.0].map(|degrees| {
        let (sin, cos) = degrees.to_radians().sin_cos();
        prefilter::reference::irradiance::harmonics([cos * 0.8, cos * 0.6, sin])
    });
    std::array::from_fn(|term| suns.map(|sun| sun[term] as f32))
}

/// A view of slopes and the axes of its tangent frame.
struct Case {
    visible: Visible,
    frame: [[f64; 3]; 3],
    deviation: f64,
}

impl Case {
    fn numbers(&self) -> Vec<f32> {
        let Visible { view, covariance, mean } = self.visible;
        [&mean[..], &covariance, &view, &self.frame.concat()].concat().into_iter().map(|value| value as f32).collect()
    }
}

/// The notes' grid: round slopes and slopes 4 to 1, level and tilted, from overhead to 5 degrees above the plane.
fn cases() -> Vec<Case> {
    let mut cases = Vec::new();
    let frames = [
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        [[0.6, 0.0, -0.8], [0.64, 0.6, 0.48], [0.48, -0.8, 0.36]],
    ];
    for deviation in [0.1, 0.3, 0.5, 0.7, 1.0f64] {
        for aspect in [1.0, 0.25f64] {
            for mean in [[0.0, 0.0], [0.2, 0.3]] {
                for (number, degrees) in [0.0f64, 30.0, 60.0, 75.0, 85.0].into_iter().enumerate() {
                    let (sin, cos) = degrees.to_radians().sin_cos();
                    let (turn_sin, turn_cos) = 0.35f64.sin_cos();
                    let (major, minor) = (deviation.powi(2), (deviation * aspect).powi(2));
                    let covariance = [
                        turn_cos * turn_cos * major + turn_sin * turn_sin * minor,
                        turn_cos * turn_sin * (major - minor),
                        turn_sin * turn_sin * major + turn_cos * turn_cos * minor,
                    ];
                    let view = [sin * 0.28, sin * 0.96, cos];
                    let visible = Visible { view, covariance, mean };
                    cases.push(Case { visible, frame: frames[number % 2], deviation });
                }
            }
        }
    }
    cases
}

/// An environment with the irradiance of every case and channel.
struct Hall {
    radiance: Harmonics,
    truths: Vec<[f64; 3]>,
}

impl Hall {
    fn new(radiance: Harmonics, cases: &[Case]) -> Self {
        let truth = |case: &Case, channel: usize| {
            over(&case.visible, radiance.map(|color| f64::from(color[channel])), case.frame)
        };
        Self { radiance, truths: cases.iter().map(|case| [0, 1, 2].map(|channel| truth(case, channel))).collect() }
    }

    /// The mean over all normals: that of order 0, which is scaled by π, times Y₀₀ = 1/(2 √π).
    fn mean(&self, channel: usize) -> f64 {
        0.5 * std::f64::consts::PI.sqrt() * f64::from(self.radiance[0][channel])
    }
}

/// The largest errors over the mean irradiance of all normals: for slope deviations up to 0.3, and all.
fn errors(device: &Device, tier: IrradianceTier, colors: Colors, halls: &[Hall]) -> Result<[f64; 2], Fault> {
    let cases = cases();
    let numbers: Vec<f32> = cases.iter().flat_map(Case::numbers).collect();
    let mut worst = [0.0f64; 2];
    for hall in halls {
        let scene = Scene::new("hall").irradiance(Irradiance::from_harmonics(hall.radiance)?).colors(colors);
        let module = scene.irradiance_tier(tier).module()?;
        let found = ExportKernel::new(device, &module, &module.exports()[0])?.run(&numbers)?;
        assert_eq!(found.len(), cases.len());
        for ((found, case), truth) in found.iter().zip(&cases).zip(&hall.truths) {
            let covered = case.deviation <= 0.3 || tier != IrradianceTier::Points;
            for channel in 0..3 {
                // Order 2 of a sun rings below 0, where no light is.
                let error = (f64::from(found[channel]) - truth[channel].max(0.0)).abs();
                assert!(!covered || error <= f64::from(module.bound().value()), "{tier}: {error}, {}", module.bound());
                let relative = error / hall.mean(channel);
                worst[0] = if case.deviation <= 0.3 { worst[0].max(relative) } else { worst[0] };
                worst[1] = worst[1].max(relative);
            }
        }
    }
    Ok(worst)
}

#[test]
fn irradiance_keeps_the_figures_of_its_tiers() -> Outcome {
    let device = Device::new()?;
    let halls = [GRACE, EUCALYPTUS, suns()].map(|radiance| Hall::new(radiance, &cases()));
    for (tier, near, far) in [
        (IrradianceTier::Normal, 1.8, 2.8),
        (IrradianceTier::Points, 1.1e-2, 0.14),
        (IrradianceTier::ThreeGaussians, 6.5e-3, 9.1e-3),
        (IrradianceTier::FourGaussians, 7e-4, 1.1e-3),
    ] {
        for colors in [Colors::Constant, Colors::Dynamic] {
            let found = errors(&device, tier, colors, &halls)?;
            println!("{tier}: {:.2e} of the mean for deviations up to 0.3, {:.2e} up to 1", found[0], found[1]);
            assert!(found[0] <= near && found[1] <= far, "{tier}: {found:?}");
            // What is not filtered errs by more than the mean itself.
            assert!(tier != IrradianceTier::Normal || found[1] > 2.6);
        }
    }
    Ok(())
}

#[test]
fn lambert_errs_by_less_than_three_hundredths() -> Outcome {
    let device = Device::new()?;
    let mut random = Random::new(5);
    let scene = Scene::new("hall").irradiance(Irradiance::from_harmonics(GRACE)?);
    let module = scene.irradiance_tier(IrradianceTier::FourGaussians).module()?;
    let export = &module.exports()[1];
    assert_eq!(export.name, "hall_lambert");
    let mut direction = |least: f64| {
        let z = least + (1.0 - least) * random.unit();
        let (radius, azimuth) = ((1.0 - z * z).sqrt(), std::f64::consts::TAU * random.unit());
        [radius * azimuth.cos(), radius * azimuth.sin(), z]
    };
    // Views up to 88 degrees from the normal, lights up to 89.
    let pairs: Vec<_> = (0..6000).map(|_| (direction(0.0349), direction(0.0175))).collect();
    let (mut numbers, mut truths) = (Vec::new(), Vec::new());
    for (view, light) in pairs {
        let (deviation, angle) = (0.05 + 0.95 * random.unit(), std::f64::consts::TAU * random.unit());
        let mean = [0.3 * angle.cos(), 0.3 * angle.sin()].map(|part| part * random.unit());
        let minor = deviation * random.pick([1.0, 0.25]);
        let covariance = [deviation * deviation, 0.0, minor * minor];
        numbers.extend([&mean[..], &covariance, &view, &light].concat().into_iter().map(|value| value as f32));
        truths.push(lambert(&Visible { view, covariance, mean }, light));
    }
    let found = ExportKernel::new(&device, &module, export)?.run(&numbers)?;
    assert_eq!(found.len(), 6000);
    let errors: Vec<f64> =
        found.iter().zip(&truths).map(|(found, truth)| (f64::from(found[0]) - truth).abs()).collect();
    let rms = (errors.iter().map(|error| error * error).sum::<f64>() / 6000.0).sqrt();
    let worst = errors.into_iter().fold(0.0, f64::max);
    println!("Lambert's cosine errs by {worst:.2e}, RMS {rms:.1e}");
    assert!(worst <= 0.03);
    Ok(())
}

/// Of a bright sky that is nearly even, rounding is more than what the means of normals add.
#[test]
fn bright_skies_keep_their_bounds() -> Outcome {
    let device = Device::new()?;
    let mut bright = [[1e-3f32; 3]; 9];
    bright[0] = [60_000.0, 977.7, 0.123];
    let hall = Hall::new(bright, &cases());
    for tier in [IrradianceTier::Points, IrradianceTier::FourGaussians] {
        for colors in [Colors::Constant, Colors::Dynamic] {
            errors(&device, tier, colors, std::slice::from_ref(&hall))?;
        }
    }
    Ok(())
}

/// What was stored and read back is checked as what is made, and tells which color was wrong.
#[test]
fn stored_irradiance_is_checked() -> Outcome {
    let light = Irradiance::from_harmonics(GRACE)?;
    let text = serde_json::to_string(&light)?;
    assert_eq!(serde_json::from_str::<Irradiance>(&text)?, light);
    let wrong = r#"{"polynomial":[[1,1,1],[0,0,1e39],[0,0,0],[0,0,0],[0,0,0],[0,0,0],[0,0,0],[0,0,0],[0,0,0]]}"#;
    let error = serde_json::from_str::<Irradiance>(wrong).err().ok_or("no error")?.to_string();
    assert!(error.contains("the color of term 1 of the irradiance is inf"), "{error}");
    Ok(())
}

/// An image of the environment gives the coefficients of what it shows, and bad ones are refused with their place.
#[test]
fn images_become_polynomials() -> Outcome {
    let (width, height) = (128, 64);
    let mut texels = Vec::new();
    for row in 0..height {
        for column in 0..width {
            let (polar, azimuth) = (
                (row as f64 + 0.5) / height as f64 * std::f64::consts::PI,
                (column as f64 + 0.5) / width as f64 * std::f64::consts::TAU,
            );
            let direction = [polar.sin() * azimuth.cos(), polar.sin() * azimuth.sin(), polar.cos()];
            let harmonics = prefilter::reference::irradiance::harmonics(direction);
            texels.push([0, 1, 2].map(|channel| {
                let sum: f64 = EUCALYPTUS.iter().zip(harmonics).map(|(color, y)| f64::from(color[channel]) * y).sum();
                1.0 + sum as f32
            }));
        }
    }
    let found = Irradiance::from_equirectangular(width, height, &texels)?;
    let known = Irradiance::from_harmonics(EUCALYPTUS)?;
    for normal in [[0.0, 0.0, 1.0], [0.6, 0.0, -0.8], [0.48, 0.64, 0.6]] {
        let (found, known) = (found.value(normal), known.value(normal));
        for channel in 0..3 {
            assert!((found[channel] - known[channel] - std::f32::consts::PI).abs() < 5e-3, "{found:?} {known:?}");
        }
    }
    let mut dark = texels.clone();
    dark[130][1] = -1.0;
    let error = Irradiance::from_equirectangular(width, height, &dark).unwrap_err().to_string();
    assert!(error.contains("column 2 of row 1"), "{error}");
    assert!(Irradiance::from_equirectangular(width, height + 1, &texels).is_err());
    assert!(Irradiance::from_harmonics([[f32::NAN; 3]; 9]).is_err());
    // The brightest image that is allowed, all around and on one side, is one that is stored, too.
    for bright in [|_: usize| true, |row: usize| row < 16] {
        let texels: Vec<[f32; 3]> = (0..64 * 32).map(|at| [if bright(at / 64) { 65504.0 } else { 0.0 }; 3]).collect();
        let light = Irradiance::from_equirectangular(64, 32, &texels)?;
        let up = light.value([0.0, 0.0, 1.0])[0] / 65504.0;
        assert!((up - std::f32::consts::PI).abs() < 0.2, "{up}");
        assert_eq!(serde_json::from_str::<Irradiance>(&serde_json::to_string(&light)?)?, light);
    }
    Ok(())
}

/// Whatever the slopes and views: huge, denormal, infinite, of any rank and from below, light is finite and no more
/// than normals of unit length receive.
#[test]
fn any_input_gives_a_light() -> Outcome {
    let device = Device::new()?;
    let mut random = Random::new(17);
    let light = Irradiance::from_harmonics(GRACE)?;
    let most = [0, 1, 2].map(|channel| light.polynomial().iter().map(|color| color[channel].abs()).sum::<f32>());
    let up = [1.0f32, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0];
    let count = 100_000;
    let tiers =
        [IrradianceTier::Normal, IrradianceTier::Points, IrradianceTier::ThreeGaussians, IrradianceTier::FourGaussians];
    for tier in tiers.into_iter().flat_map(|tier| vec![tier; any::inputs(count) / count]) {
        let module = Scene::new("hall").irradiance(light).irradiance_tier(tier).module()?;
        let (mut skies, mut suns) = (Vec::new(), Vec::new());
        for index in 0..count {
            let (slope, covariance) = (any::slope(&mut random), any::covariance(&mut random));
            let [view, sun] = [any::direction(&mut random), any::direction(&mut random)];
            let mut surface: Vec<f32> =
                [&slope[..], &covariance, &view].concat().into_iter().map(|value| value as f32).collect();
            if index % 4 == 0 {
                surface[2..5].fill_with(|| any::number(&mut random));
            }
            skies.extend(surface.iter().chain(&up));
            suns.extend(surface.into_iter().chain(sun.map(|part| part as f32)));
        }
        let kernel = |export: usize| ExportKernel::new(&device, &module, &module.exports()[export]);
        let (skies_found, suns_found) = (kernel(0)?.run(&skies)?, kernel(1)?.run(&suns)?);
        assert!(skies_found.len() == count && suns_found.len() == count);
        for (found, point) in skies_found.iter().zip(skies.chunks_exact(17)) {
            for channel in 0..3 {
                assert!((0.0..=1.01 * most[channel]).contains(&found[channel]), "{tier}: {point:?} gives {found:?}");
            }
        }
        for (found, point) in suns_found.iter().zip(suns.chunks_exact(11)) {
            assert!((0.0..=1.0).contains(&found[0]), "{tier}: {point:?} gives {found:?}");
        }
    }
    Ok(())
}
