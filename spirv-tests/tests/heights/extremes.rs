//! Finite results for any input: random bit patterns, which are huge, tiny, denormal, infinite and of both signs.

use prefilter::gpu::{Device, Texture};
use spirv_tests::any;
use spirv_tests::kernel::Function;
use spirv_tests::random::Random;
use spirv_tests::rows;

/// Points at a time.
const BATCH: usize = 250_000;

/// What takes any number, of files of the shelf; visibility has a test of its own.
const OURS: [&str; 2] = ["visibility/heights.wgsl", "filter/percentile.wgsl"];

/// What takes tails: of heights up to the largest numbers with a square, as a scene clamps what it is given.
const TAILS: &str = "
fn judged(distance: f32, width: f32, deviation: f32, skewness: f32) -> vec4f {
    let tails = height_skewed(clamp(deviation, 0.0, 1e18), skewness);
    let d = clamp(distance, -1e18, 1e18);
    let w = clamp(width, 1e-38, 1e18);
    return vec4f(height_excess(d, tails), height_kink(d, tails), height_step(d, tails), height_ramp(d, w, tails));
}";

/// The same of shorter ones.
const SHORT: &str = "
fn judged(distance: f32, width: f32, deviation: f32, skewness: f32) -> vec4f {
    let tails = tails_skewed(clamp(deviation, 0.0, 1e18), skewness);
    let d = clamp(distance, -1e18, 1e18);
    let w = clamp(width, 1e-38, 1e18);
    return vec4f(tails_excess(d, tails), tails_kink(d, tails), tails_step(d, tails), tails_ramp(d, w, tails));
}";

/// Asks for finite results of a function at random points.
fn finite(device: &Device, function: &Function, textures: &[&Texture], seed: u32) -> Result<(), String> {
    let mut random = Random::new(seed);
    let inputs = function.signature.inputs().len();
    let mut count = 0;
    while count < any::inputs(1_000_000) {
        let mut point = || (0..inputs).map(|_| f64::from(any::number(&mut random))).collect();
        let points: Vec<Vec<f64>> = (0..BATCH).map(|_| point()).collect();
        let results = function.results(device, textures, &points)?;
        assert_eq!(results.len(), BATCH);
        for (point, result) in points.iter().zip(&results) {
            assert!(result.iter().all(|value| value.is_finite()), "{}: {point:?} gives {result:?}", function.name);
        }
        count += BATCH;
    }
    println!("{}: {count} finite results", function.name);
    Ok(())
}

#[test]
fn every_result_is_finite() -> Result<(), String> {
    let device = Device::new().map_err(|error| error.to_string())?;
    let (functions, rows) = (Function::shelf()?, rows::all());
    let ours = |function: &&Function| OURS.contains(&function.path.as_str()) || function.name == "normal_surprisal";
    let mut found = [0; OURS.len()];
    for (seed, function) in (1..).zip(functions.iter().filter(ours)) {
        let row = rows.iter().find(|row| row.name == function.name).ok_or("no row")?;
        let textures = row.tables.iter().map(|(table, address)| device.upload(table, *address));
        let textures: Vec<Texture> = textures.collect::<Result<_, _>>().map_err(|error| error.to_string())?;
        finite(&device, function, &textures.iter().collect::<Vec<_>>(), seed)?;
        if let Some(at) = OURS.iter().position(|path| *path == function.path) {
            found[at] += 1;
        }
    }
    assert!(found.iter().all(|count| *count >= 4), "{found:?}");
    finite(&device, &Function::in_text(TAILS, "judged")?, &[], 99)?;
    finite(&device, &Function::in_text(SHORT, "judged")?, &[], 98)
}
