//! Question 3: colors of functions whose positions noise displaces, on a plane up to the horizon.

use prefilter::driver::pattern::Motif;
use prefilter::gpu::Device;
use prefilter::{Custom, Driver, Error, Kernel, Module, Noise, Pattern, Scene, SlopeMoments, Taps, Tier, Warp};
use spirv_tests::horizon::{colors, square};
use spirv_tests::maps::named;

use crate::plane::{filtered, Plane, Truth};
use crate::{octaves, Outcome};

const SEEDS: [u32; 4] = [1, 2, 3, 4];

fn warp(driver: Driver, seed: u32) -> Warp {
    Warp { size: 2.0, deviation: 0.4, octaves: 3, seed, ..Warp::of(driver) }
}

fn module(warp: &Warp) -> Result<Module, Box<dyn std::error::Error + Send + Sync>> {
    let scene = Scene::new("rock").texture(named("terrain")?).tier(Tier::ClosedForm(Kernel::Exact));
    Ok(scene.driver(Driver::Warp(warp.clone())).module()?)
}

fn noise(seed: u32, taps: Taps) -> Driver {
    Driver::Noise(Noise { octaves: 4, seed, taps, ..Noise::default() })
}

fn stripes(_: u32, taps: Taps) -> Driver {
    Driver::Pattern(Pattern { motif: Motif::Stripes { duty: 0.3 }, values: [0.3, 0.7], taps, ..Pattern::default() })
}

/// The displaced function by its definition: that of the driver, and Perlin's noise of the definition's variance.
fn definition(driver: &Driver, seed: u32) -> String {
    let own = match driver {
        Driver::Noise(noise) => octaves(noise).replace("truth_noise", "truth_undisplaced"),
        _ => "fn truth_undisplaced(position: vec2f) -> f32 {
    return select(0.3, 0.7, fract(position.x) < 0.3);
}"
        .to_owned(),
    };
    let base = seed.wrapping_mul(0x9e37_79b1);
    let (first, second) = (base ^ 0x27d4_eb2f, base ^ 0x1656_67b1);
    let scale = 0.4 / ((1.0 + 0.25 + 0.0625) * 181.0 / 231.0 * 535.0 / 9009.0f64).sqrt();
    format!(
        "{own}
fn truth_noise(position: vec2f) -> f32 {{
    var sum = vec2f();
    var at = position / 2.0;
    for (var octave = 0u; octave < 3u; octave++) {{
        let n = vec2f(
            perlin_noise(at, vec2f(), {first}u + octave).x,
            perlin_noise(at, vec2f(), {second}u + octave).x,
        );
        sum += {scale:?} / f32(1u << octave) * n;
        at = 2.0 * at + vec2f(0.618033989, 0.414213562);
    }}
    return truth_undisplaced(position + sum);
}}"
    )
}

/// The colors of a module whose footprints are not carried along.
fn uncarried(device: &Device, module: &Module, plane: &Plane) -> Result<Vec<[f64; 3]>, Error> {
    let text = "fn color(p: array<f32, 6>) -> vec3f {
    return rock_color(vec2f(p[0], p[1]), vec2f(p[2], p[3]), vec2f(p[4], p[5]));
}
fn as_it_was(across: vec2f, along: vec2f, a: vec2f, b: vec2f, c: f32) -> vec4f {
    return vec4f(across, along);
}";
    let linked = module.link(text)?;
    colors(device, &linked.wgsl().replace("= warp_vectors(", "= as_it_was("), &plane.points())
}

/// The documentation's row of a driver: errors in thousandths.
fn said(row: &str) -> Result<Vec<f64>, Box<dyn std::error::Error + Send + Sync>> {
    let text = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/../src/driver/warp.rs"))?;
    let line = text.lines().find(|line| line.contains(&format!("| {row}"))).ok_or("no such row")?;
    Ok(line.split('|').filter_map(|cell| cell.trim().parse().ok()).collect())
}

#[test]
fn footprints_are_carried_along() -> Outcome {
    let device = Device::new()?;
    type Made = fn(u32, Taps) -> Driver;
    let cases: [(&str, Made); 2] = [("four octaves of noise", noise), ("stripes", stripes)];
    for (row, driver) in cases {
        let mut squares = [const { Vec::new() }; 6];
        for seed in SEEDS {
            let plane = Plane::new(seed);
            let text = definition(&driver(seed, Taps::One), seed);
            let [first, second] = [17, 4711].map(|jitter| Truth::new("terrain", &text, 24, jitter));
            let (first, second) = (first?, second?);
            let (one, two) = (first.mean(&device, &plane)?, second.mean(&device, &plane)?);
            let mean = |(a, b): (&[f64; 3], &[f64; 3])| [0, 1, 2].map(|channel| 0.5 * (a[channel] + b[channel]));
            let truth: Vec<[f64; 3]> = one.iter().zip(&two).map(mean).collect();
            let of = |taps: Taps| module(&warp(driver(seed, taps), seed));
            let carried = of(Taps::One)?;
            let found = [
                first.naive(&device, &plane)?,
                uncarried(&device, &carried, &plane)?,
                filtered(&device, &carried, &plane)?,
                filtered(&device, &of(Taps::Four)?, &plane)?,
                filtered(&device, &of(Taps::Eight)?, &plane)?,
            ];
            for (squares, found) in squares.iter_mut().zip(&found) {
                squares.push(square(found, &truth));
            }
            squares[5].push(square(&one, &two) / 4.0);
        }
        let rms = squares.map(|squares| 1e3 * (squares.iter().sum::<f64>() / squares.len() as f64).sqrt());
        println!("{row}: point, as it was, carried, 4 taps, 8 taps, truth in thousandths: {rms:.0?}");
        let [point, as_it_was, carried, four, eight, truth] = rms;
        assert!(truth < eight / 3.0, "{row}: not measured well enough");
        assert!(carried < 0.9 * as_it_was && carried < 0.6 * point && four < carried && eight < four, "{row}: {rms:?}");
        let said = said(row)?;
        assert_eq!(said.len(), 5);
        for (said, found) in said.iter().zip(&rms) {
            assert!((said - found).abs() < 0.51 + 0.05 * found, "{row}: said is {said}, found {found}");
        }
    }
    Ok(())
}

/// A displacement of nothing, and a pixel of nothing.
#[test]
fn limits_are_the_driver_itself() -> Outcome {
    let device = Device::new()?;
    let plane = Plane::new(7);
    let still = Warp { deviation: 0.0, ..warp(noise(5, Taps::One), 1) };
    let scene = Scene::new("rock").texture(named("terrain")?).tier(Tier::ClosedForm(Kernel::Exact));
    let plain = filtered(&device, &scene.driver(noise(5, Taps::One)).module()?, &plane)?;
    let found = filtered(&device, &module(&still)?, &plane)?;
    let apart = square(&found, &plain).sqrt();
    assert!(apart < 1e-5, "{apart}");
    let text = definition(&noise(5, Taps::One), 5);
    let truth = Truth::new("terrain", &text, 1, 1)?.naive(&device, &plane)?;
    let point = "fn color(p: array<f32, 6>) -> vec3f {
    return rock_color(vec2f(p[0], p[1]), vec2f(), vec2f());
}";
    let moving = module(&warp(noise(5, Taps::One), 5))?;
    let found = colors(&device, moving.link(point)?.wgsl(), &plane.points())?;
    let apart = square(&found, &truth).sqrt();
    assert!(apart < 1e-4, "{apart}");
    Ok(())
}

#[test]
fn what_cannot_be_displaced_is_refused() -> Outcome {
    let solid = "fn solid(position: vec3f, across: vec3f, along: vec3f) -> vec4f { return vec4f(); }";
    let whole = warp(noise(1, Taps::One), 1);
    let cases = [
        (Warp::of(Driver::Custom(Custom::new(solid, "solid"))), "warp a function of the plane"),
        (Warp::of(Driver::SlopeMoments(SlopeMoments::default())), "warp a function of the position"),
        (Warp { size: 0.0, ..whole.clone() }, "the warp's size"),
        (Warp { deviation: f32::NAN, ..whole.clone() }, "the warp's deviation"),
        (Warp { octaves: 17, ..whole.clone() }, "the warp's number of octaves"),
        (Warp::of(Driver::Noise(Noise { period: 4, rotation: 0.0, ..Noise::default() })), "a `period` of 0"),
        (Warp::of(noise(1, Taps::One)), ""),
        (Warp::of(Driver::Warp(whole)), ""),
    ];
    for (warp, part) in cases {
        let message = module(&warp).err().map(|error| error.to_string()).unwrap_or_default();
        assert!(message.contains(part) && message.is_empty() == part.is_empty(), "{message:?} is not {part:?}");
    }
    Ok(())
}
