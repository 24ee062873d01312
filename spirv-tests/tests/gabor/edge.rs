//! Where two faces of a solid meet, the noise is the same on both, and filtered noise differs by the footprints alone.

use prefilter::gpu::Device;
use prefilter::reference::gabor::noise as exact;
use prefilter::reference::gabor_spectrum::Spectrum as Ranges;
use prefilter::{Gabor, GaborMethod};
use spirv_tests::random::Random;

use crate::{module, noise, rms, spectra, statistics, Outcome, CELL};

/// A turned cube: its axes at right angles, none along a coordinate.
const CUBE: [[f64; 3]; 3] = [[0.36, 0.48, 0.8], [0.8, -0.6, 0.0], [0.48, 0.64, -0.6]];

/// Places along the edge between the faces whose normals are the cube's first and second axis.
fn places(count: usize) -> Vec<[f64; 3]> {
    let mut random = Random::new(8);
    (0..count)
        .map(|_| {
            let along = 200.0 * random.unit() - 100.0;
            [0, 1, 2].map(|axis| f64::from((0.7 * CUBE[0][axis] + 0.4 * CUBE[1][axis] + along * CUBE[2][axis]) as f32))
        })
        .collect()
}

/// The footprint of a pixel on a face that is seen at a slant: short along the edge, long across it.
fn on(face: usize, deviation: f64) -> [[f64; 3]; 2] {
    let (inward, slant) = if face == 0 { (CUBE[1], 3.0) } else { (CUBE[0], 1.5) };
    [CUBE[2].map(|part| deviation * part), inward.map(|part| slant * deviation * part)]
        .map(|vector| vector.map(|part| f64::from(part as f32)))
}

#[test]
fn filtered_noise_differs_across_an_edge_by_its_footprints_alone() -> Outcome {
    let device = Device::new()?;
    let (_, spectrum) = spectra()[1];
    let gabor = noise(spectrum);
    let [ours, paper] = [GaborMethod::Exact, GaborMethod::Paper].map(|method| module(Gabor { method, ..gabor }));
    let (ours, paper) = (ours?, paper?);
    let places = places(2000);
    let ranges = Ranges { frequency: [1.3 * CELL, 0.0], azimuth: [0.0, std::f64::consts::TAU], height: [-1.0, 2.0] };
    let at = |module, footprint: [[f64; 3]; 2]| {
        let footprints: Vec<_> = places.iter().map(|&place| [place, footprint[0], footprint[1]]).collect();
        statistics(&device, module, &footprints)
    };
    for deviation in [0.0, 0.01, 0.05, 0.2] {
        let sides = [at(&ours, on(0, deviation))?, at(&ours, on(1, deviation))?];
        let truth = |face: usize| {
            let cells = on(face, deviation).map(|vector| vector.map(|part| part / CELL));
            places.iter().map(move |place| exact(place.map(|part| part / CELL), 2, 0, &ranges, cells).0)
        };
        let truths: Vec<f64> = truth(0).zip(truth(1)).map(|(a, b)| a - b).collect();
        let steps: Vec<f64> = sides[0].iter().zip(&sides[1]).map(|(a, b)| a[0] - b[0]).collect();
        let errors = rms(steps.iter().zip(&truths).map(|(step, truth)| step - truth));
        let [step, truth] = [&steps, &truths].map(|steps| rms(steps.iter().copied()));
        // The paper has no plane for a point.
        let other =
            if deviation > 0.0 { [at(&paper, on(0, deviation))?, at(&paper, on(1, deviation))?] } else { sides };
        let other = rms(other[0].iter().zip(&other[1]).zip(&truths).map(|((a, b), truth)| a[0] - b[0] - truth));
        println!(
            "σ {deviation}/a: step {step:.2e}, of the integrals {truth:.2e}; error {errors:.1e}, paper's {other:.1e}"
        );
        assert!(if deviation == 0.0 { step == 0.0 } else { step > 0.0 }, "{deviation}: {step}");
        // Kernels that end between f32 and f64 are 1 % of a deviation each, and rare.
        assert!(errors < 1e-3 && errors < 0.05 * other.max(1e-2), "{deviation}: {errors}");
    }
    Ok(())
}

/// What projecting along the normals does instead, as surface Gabor noise and wavelet noise: the same footprint of one
/// side is that of the other, and the noise jumps.
#[test]
fn noise_that_is_projected_along_normals_jumps() -> Outcome {
    let device = Device::new()?;
    let module = module(noise(spectra()[1].1))?;
    let projected = |face: usize| {
        let footprints: Vec<_> =
            places(2000).into_iter().map(|place| [place, CUBE[face].map(|part| 2.0 * part), [0.0; 3]]).collect();
        statistics(&device, &module, &footprints)
    };
    let (one, other) = (projected(0)?, projected(1)?);
    let own = rms(one.iter().map(|[value, _]| *value));
    let step = rms(one.iter().zip(&other).map(|(a, b)| a[0] - b[0])) / own;
    println!("projected along each face's normal: step of {step:.2} deviations");
    assert!(step > 0.5, "{step}");
    Ok(())
}
