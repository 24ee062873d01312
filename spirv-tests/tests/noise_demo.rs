//! Question 3 for noise: is the model good? A plane to the horizon and blocks with sharp edges, still and in motion,
//! against the noise itself.

use prefilter::gpu::{Device, Kernel, Work};
use prefilter::{Scene, Taps};
use spirv_tests::demo::motion::Motion;
use spirv_tests::gap::figure::Figure;
use spirv_tests::imaging::tally::{sizes, Of};
use spirv_tests::noise::input::Input;
use spirv_tests::noise::judge::{judge, Extent, Judged};
use spirv_tests::noise::method::Method;
use spirv_tests::noise::truth::numbers;
use spirv_tests::noise::{table, Error};
use spirv_tests::report::cache::Cache;

const EXTENT: Extent = Extent {
    still: [[48, 36], [60, 26]],
    moving: [[48, 36], [60, 26]],
    frames: 6,
    strata: [32, 16],
    seeds: 2,
    moved: 0,
};

const OURS: [Method; 3] = [Method::Ours(Taps::One), Method::Ours(Taps::Four), Method::Ours(Taps::Eight)];

fn judged(input: &Input) -> Result<Judged, Error> {
    let judged = judge(&Device::new()?, input, EXTENT, &Cache::none(), &|_| ())?;
    println!("{}", table::text(&judged));
    Ok(judged)
}

/// Whether the truth is known three times better than every figure.
fn truth_is_sharp(judged: &Judged) {
    let error = sizes(&judged.stills, Of::Truth, None).rms.value;
    for method in judged.input.methods() {
        let figure = judged.rms(method, None).value;
        assert!(3.0 * error < figure, "{}: {figure} against {error}", method.label());
    }
    for motion in Motion::ALL {
        let figures: Vec<Figure> = judged.input.methods().map(|method| judged.shimmer(method, motion)).collect();
        assert!(figures.iter().all(|figure| figure.stands()), "{figures:?}");
    }
    assert!(judged.motions.iter().all(|series| series.len() == EXTENT.seeds as usize));
}

/// One evaluation is nearer than any other one, and more taps are nearer yet and shimmer less.
fn taps_pay(judged: &Judged) {
    let others = [Method::Naive, Method::Mean, Method::Fading, Method::Clamping, Method::Hart, Method::Paper];
    let rms = |method| judged.rms(method, None).value;
    let [one, four, eight] = OURS.map(rms);
    for method in others {
        assert!(one < rms(method), "{}: {}, ours {one}", method.label(), rms(method));
    }
    assert!(four < one && eight < four, "{one} {four} {eight}");
    let [one, four, eight] = OURS.map(|method| judged.shimmer(method, Motion::Zoom).value);
    let paper = judged.shimmer(Method::Paper, Motion::Zoom).value;
    assert!(one < paper && four < one && eight < one, "{one} {four} {eight}, the paper's recipe {paper}");
}

/// How much a method shimmers on the zoom, over how much brute force of sixteen samples does.
fn shimmer(judged: &Judged, method: Method) -> f64 {
    let [ours, sampled] = [method, Method::Stratified(4)].map(|method| judged.shimmer(method, Motion::Zoom).value);
    ours / sampled
}

#[test]
fn a_plane_of_noise_to_the_horizon() -> Result<(), Error> {
    let (terrain, steps) = (judged(&Input::terrain()?)?, judged(&Input::steps()?)?);
    for judged in [&terrain, &steps] {
        truth_is_sharp(judged);
        taps_pay(judged);
        assert!(shimmer(judged, Method::Ours(Taps::Four)) < 0.8);
        // One evaluation that knows second derivatives: nearer in stills, too.
        assert!(shimmer(judged, Method::Curvature) < 1.0);
        let [curvature, one] =
            [Method::Curvature, Method::Ours(Taps::One)].map(|method| judged.rms(method, None).value);
        assert!(curvature < 0.9 * one, "{curvature} {one}");
    }
    assert!(shimmer(&steps, Method::Ours(Taps::One)) < 1.0);
    // Under a smooth map brute force converges faster: one tap is no better there, and over longer zooms worse.
    assert!(shimmer(&terrain, Method::Ours(Taps::One)) < 1.1);
    Ok(())
}

#[test]
fn blocks_of_solid_noise_near_and_far() -> Result<(), Error> {
    let judged = judged(&Input::blocks()?)?;
    truth_is_sharp(&judged);
    taps_pay(&judged);
    assert!(shimmer(&judged, Method::Ours(Taps::One)) < 0.5);
    Ok(())
}

/// What the truth samples is what the driver filters: over no footprint at all they are the same.
#[test]
fn the_definition_is_the_drivers_noise() -> Result<(), Error> {
    const HOST: &str = "
@group(0) @binding(0) var<storage, read_write> found: array<vec2f>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    if id.x < arrayLength(&found) {
        let seen = seen(pixel(id.x));
        let value = vec2f(noise_value(seen.position), surface_statistics(seen.position, Place(), Place()).x);
        found[id.x] = select(vec2f(noise_mean), value, seen.there);
    }
}";
    let device = Device::new()?;
    for input in Input::all()? {
        let driver = input.driver(Method::Ours(Taps::One));
        let module = Scene::new("surface").texture(input.map.clone()).driver(driver).module()?;
        let text = [input.world(), HOST.to_owned()].concat();
        let kernel = Kernel::new(&device, module.link(&text)?.wgsl(), "main")?;
        let lens = input.lens([48, 36]);
        let shot = numbers(&input, &lens, 3);
        let (invocations, output) = (lens.pixels(), 2 * lens.pixels());
        let found = kernel.run(&Work { inputs: &[&shot], textures: &[], invocations, output })?;
        let far = found.chunks_exact(2).map(|pair| (pair[0] - pair[1]).abs()).fold(0.0, f32::max);
        let spread = found.iter().fold(0.0f32, |most, value| most.max((value - 0.5).abs()));
        assert!(far < 2e-5 && spread > 0.3, "{}: {far}, {spread}", input.name);
    }
    Ok(())
}
