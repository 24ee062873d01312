//! Does an octave lose over a footprint what its filter says, and is the filter's fit near enough?

use prefilter::gpu::Device;
use prefilter::reference::retained::Noise as Octave;
use spirv_tests::random::Random;

use crate::{at, Outcome};

/// A noise: its name, what it takes besides position and seed, its definition, its variance.
const NOISES: [(&str, &[f64], Octave, f64); 3] = [
    ("perlin", &[0.0, 0.0], Octave::Perlin, 0.046_531_150_4),
    ("value", &[0.0, 0.0], Octave::Value, 0.204_650_087_8),
    ("simplex", &[], Octave::Simplex, 0.144_655_222_7),
];

/// Two points in footprints with these deviations, turned at random, everywhere.
fn pairs(random: &mut Random, deviations: [f64; 2], count: usize) -> Vec<[[f64; 2]; 3]> {
    let mut normal = || {
        let radius = (-2.0 * (1.0 - random.unit()).ln()).sqrt();
        let (sin, cos) = (std::f64::consts::TAU * random.unit()).sin_cos();
        [radius * cos, radius * sin]
    };
    let pair = |_| {
        let [x, y] = normal().map(|part| 300.0 * part);
        let [along, across] = normal();
        let turn = across.atan2(along);
        let offset = |[a, b]: [f64; 2]| {
            let (sin, cos) = turn.sin_cos();
            let [a, b] = [a * deviations[0], b * deviations[1]];
            [x + cos * a - sin * b, y + sin * a + cos * b]
        };
        [[x, y], offset(normal()), offset(normal())].map(|place| place.map(|part| f64::from(part as f32)))
    };
    (0..count).map(pair).collect()
}

fn column(pairs: &[[[f64; 2]; 3]], which: usize, further: &[f64]) -> Vec<Vec<f64>> {
    let point = |pair: &[[f64; 2]; 3]| pair[which].iter().chain(further).copied().chain([5.0]).collect();
    pairs.iter().map(point).collect()
}

/// Half the mean square of the difference of two points of a footprint is the variance within it.
#[test]
fn lost_variances_are_those_of_samples() -> Outcome {
    const COUNT: usize = 600_000;
    let device = Device::new()?;
    let mut random = Random::new(3);
    for (name, further, _, variance) in NOISES {
        for deviation in [0.05, 0.1, 0.2, 0.3, 0.5, 0.7, 1.0, 2.0] {
            let pairs = pairs(&mut random, [deviation; 2], COUNT);
            let [center, a, b] =
                [0, 1, 2].map(|which| at(&device, &format!("{name}_noise"), &column(&pairs, which, further)));
            let (center, a, b) = (center?, a?, b?);
            let halves: Vec<f64> = a.iter().zip(&b).map(|(a, b)| 0.5 * (a[0] - b[0]).powi(2) / variance).collect();
            let mean = halves.iter().sum::<f64>() / COUNT as f64;
            let spread = halves.iter().map(|half| (half - mean).powi(2)).sum::<f64>() / COUNT as f64;
            let error = (spread / COUNT as f64).sqrt() / mean;
            let wider = 2f64.sqrt() * deviation;
            let lost = at(&device, &format!("{name}_lost"), &[vec![wider, wider]])?[0][0];
            // The multiplier is the regression of the footprint on its center.
            let products = center.iter().zip(&a).map(|(center, a)| center[0] * a[0]).sum::<f64>();
            let multiplier = products / (COUNT as f64 * variance);
            let filter = at(&device, &format!("{name}_filter"), &[vec![deviation; 2]])?[0].clone();
            println!(
                "{name} {deviation}: lost {lost:.5}, sampled {mean:.5} ± {:.2}%; multiplier {:.4}, {multiplier:.4}",
                100.0 * error,
                filter[0]
            );
            assert!(error < 0.02 / 3.0, "{name} {deviation}: not measured well enough, {error}");
            assert!((lost / mean - 1.0).abs() < 0.02, "{name} {deviation}: {lost} is not {mean}");
            assert!((filter[0] - multiplier).abs() < 0.01, "{name} {deviation}: {} is not {multiplier}", filter[0]);
        }
    }
    Ok(())
}

/// Retained power against quadrature, for round footprints and long ones along the lattice, wherever it changes.
#[test]
fn retained_power_is_that_of_the_autocorrelation() -> Outcome {
    let device = Device::new()?;
    let solid = [("perlin_solid", Octave::PerlinSolid)];
    for (name, octave) in NOISES.map(|(name, _, octave, _)| (name, octave)).into_iter().chain(solid) {
        let deviations =
            |aspect: f64| (0..200).map(move |step| 0.004 * 1.05f64.powi(step)).map(move |s| [s, aspect * s]);
        let all: Vec<[f64; 2]> = [1.0, 0.3, 0.03].into_iter().flat_map(deviations).collect();
        let points: Vec<Vec<f64>> = all.iter().map(|s| s.map(|s| 2f64.sqrt() * s).to_vec()).collect();
        let found = at(&device, &format!("{name}_lost"), &points)?;
        let errors = all.iter().zip(&found).map(|(s, lost)| (1.0 - lost[0] - octave.retained(*s)).abs());
        let worst = errors.fold(0.0, f64::max);
        println!("{name}: retained power within {worst:.1e}");
        assert!(worst < 6e-4, "{name}: {worst:e}");
        // λ, by differences and as the shelf writes it.
        let slopes = match octave {
            Octave::Perlin => 8.383_952_08,
            Octave::Value => 3.646_408_84,
            Octave::Simplex => 160.0 / 7.0,
            Octave::PerlinSolid => 6.804_770_99,
        };
        assert!((octave.slopes() / slopes - 1.0).abs() < 1e-5, "{name}: {}", octave.slopes());
    }
    Ok(())
}

/// The lattice's axes are those of the fits: how much less or more footprints across them retain.
#[test]
fn turned_footprints_retain_about_as_much() -> Outcome {
    const COUNT: usize = 400_000;
    let device = Device::new()?;
    let mut random = Random::new(8);
    for (name, further, _, variance) in NOISES {
        for deviations in [[0.2, 0.05], [0.5, 0.1], [1.0, 0.1], [2.0, 0.3]] {
            let pairs = pairs(&mut random, deviations, COUNT);
            let [a, b] = [1, 2].map(|which| at(&device, &format!("{name}_noise"), &column(&pairs, which, further)));
            let (a, b) = (a?, b?);
            let mean =
                a.iter().zip(&b).map(|(a, b)| 0.5 * (a[0] - b[0]).powi(2) / variance).sum::<f64>() / COUNT as f64;
            let wider = deviations.map(|deviation| 2f64.sqrt() * deviation).to_vec();
            let lost = at(&device, &format!("{name}_lost"), &[wider])?[0][0];
            println!("{name} {deviations:?}: lost {lost:.4}, sampled over all turns {mean:.4}");
            assert!((lost - mean).abs() < 0.015, "{name} {deviations:?}: {lost} is not {mean}");
        }
    }
    Ok(())
}
