//! Have noises the mean, the variance and the gradients that follow from their definitions, independent of each other
//! where seeds differ, and words of the lattice no pattern?

use std::f64::consts::PI;

use prefilter::gpu::Device;
use prefilter::reference::lattice::{weight, word};
use prefilter::reference::perlin::slope;
use prefilter::reference::quadrature::integrate;
use prefilter::reference::simplex::part;
use prefilter::reference::value::value;
use spirv_tests::random::Random;

use crate::{at, Outcome};

/// A noise, its variance and that of its derivatives over it, and its largest value.
struct Known {
    name: &'static str,
    periodic: bool,
    variance: f64,
    slopes: f64,
    most: f64,
}

/// The integral over one axis of a square of a function of the distance from a lattice point.
fn squared(function: impl Fn(f64) -> f64) -> f64 {
    let [sum] = integrate(0.0, 1.0, 0.25, |t| [function(t).powi(2) + function(t - 1.0).powi(2)]);
    sum
}

/// Variances by quadrature: sums over the lattice points about a place, of independent lines whose slopes have the
/// variance ½ along either axis, or of independent values of the variance ⅓.
fn known() -> [Known; 3] {
    let steep = |t: f64| -t.signum() * 30.0 * t * t * (1.0 - t.abs()).powi(2);
    let (w, xw) = (squared(weight), squared(|t| t * weight(t)));
    let (dw, dxw) = (squared(steep), squared(|t| weight(t) + t * steep(t)));
    let perlin = Known {
        name: "perlin_noise",
        periodic: true,
        variance: 0.5 * (xw * w + w * xw),
        slopes: (dxw * w + dw * xw) / (xw * w + w * xw),
        most: 0.5f64.sqrt(),
    };
    let value = Known { name: "value_noise", periodic: true, variance: w * w / 3.0, slopes: dw / w, most: 1.0 };
    // Over the area 1/√3 of a lattice point's cell; by polar coordinates, around which lines average to a half.
    let plane = |function: &dyn Fn(f64) -> f64| {
        let [sum] = integrate(0.0, 0.5f64.sqrt(), 0.1, |r| [2.0 * PI * r * function(r)]);
        3f64.sqrt() * sum
    };
    let line = |r: f64| part([r, 0.0], [1.0, 0.0]);
    let variance = plane(&|r| 0.5 * line(r).powi(2));
    // Per axis half of what is along and across the radius: the derivatives of the line, and of its turn.
    let rise = |r: f64| (line(r + 1e-5) - line(r - 1e-5)) / 2e-5;
    let gradients = plane(&|r| 0.25 * (rise(r).powi(2) + (line(r) / r).powi(2)));
    let simplex = Known { name: "simplex_noise", periodic: false, variance, slopes: gradients / variance, most: 1.0 };
    [perlin, value, simplex]
}

/// Mean square and its standard error.
fn square(values: impl Iterator<Item = f64> + Clone) -> [f64; 2] {
    let count = values.clone().count() as f64;
    let mean = values.clone().map(|value| value * value).sum::<f64>() / count;
    let spread = values.map(|value| (value * value - mean).powi(2)).sum::<f64>() / count;
    [mean, (spread / count).sqrt()]
}

/// The numbers that a noise takes at a place.
fn taken(known: &Known, place: [f64; 2], seed: f64) -> Vec<f64> {
    let [x, y] = place;
    if known.periodic {
        vec![x, y, 0.0, 0.0, seed]
    } else {
        vec![x, y, seed]
    }
}

/// Places all over a part of the plane.
fn places(seed: u32, count: usize) -> Vec<[f64; 2]> {
    let mut random = Random::new(seed);
    (0..count).map(|_| [0, 1].map(|_| f64::from((2e4 * (random.unit() - 0.5)) as f32))).collect()
}

#[test]
fn the_variances_are_those_of_the_definition() -> Outcome {
    let device = Device::new()?;
    let known = known();
    // As the shelf states them, by integrals in closed form.
    let stated = [
        (181.0 / 231.0 * 535.0 / 9009.0, 8.38395),
        ((181f64 / 231.0).powi(2) / 3.0, 3.64641),
        (4900.0 * 3f64.sqrt() * PI / 184_320.0, 160.0 / 7.0),
    ];
    for (known, (variance, slopes)) in known.iter().zip(stated) {
        assert!((known.variance / variance - 1.0).abs() < 1e-9, "{}: {}", known.name, known.variance);
        assert!((known.slopes / slopes - 1.0).abs() < 1e-6, "{}: {}", known.name, known.slopes);
        for seed in [1, 2, 3, 4] {
            let points: Vec<_> =
                places(seed, 250_000).into_iter().map(|place| taken(known, place, f64::from(100 * seed))).collect();
            let found = at(&device, known.name, &points)?;
            let mean = found.iter().map(|values| values[0]).sum::<f64>() / found.len() as f64;
            assert!(mean.abs() < 5.0 * (variance / found.len() as f64).sqrt(), "{}: mean {mean:e}", known.name);
            for (channel, expected) in [(0, variance), (1, slopes * variance), (2, slopes * variance)] {
                let [mean, error] = square(found.iter().map(|values| values[channel]));
                println!("{} seed {seed}: {mean:.6} ± {error:.1e}, expected {expected:.6}", known.name);
                assert!((mean - expected).abs() < 5.0 * error, "{} {channel}: {mean} ± {error}", known.name);
            }
            let most = found.iter().fold(0.0f64, |most, values| most.max(values[0].abs()));
            assert!(most <= known.most + 1e-6, "{}: {most}", known.name);
        }
    }
    Ok(())
}

/// Seeds that are neighbors, as octaves take them, have nothing in common: at the same place, and one cell aside.
#[test]
fn seeds_are_independent() -> Outcome {
    let device = Device::new()?;
    for known in known() {
        let places = places(5, 200_000);
        let of = |seed: f64, aside: f64| {
            let points: Vec<_> = places.iter().map(|[x, y]| taken(&known, [x + aside, *y], seed)).collect();
            at(&device, known.name, &points)
        };
        let home = of(11.0, 0.0)?;
        for (seed, aside) in [(12.0, 0.0), (13.0, 0.0), (12.0, 1.0), (10.0, 1.0), (43.0, 0.0), (4_294_967_295.0, 0.0)] {
            let other = of(seed, aside)?;
            let products = home.iter().zip(&other).map(|(a, b)| a[0] * b[0]);
            let mean = products.sum::<f64>() / (home.len() as f64 * known.variance);
            assert!(mean.abs() < 5.0 / (home.len() as f64).sqrt(), "{} seed {seed}: correlation {mean}", known.name);
        }
    }
    Ok(())
}

/// The words of neighbors on the lattice, of lines and of values, are uncorrelated at every distance up to 4.
#[test]
fn neighbors_on_the_lattice_are_independent() {
    const SIDE: i64 = 150;
    for seed in [0, 1, 77, 4_000_000_000] {
        for (x, y) in (0..=4).flat_map(|x| (-4..=4).map(move |y| (x, y))).filter(|apart| *apart > (0, 0)) {
            let mut sums = [0.0; 3];
            for (i, j) in (-SIDE..SIDE).flat_map(|i| (-SIDE..SIDE).map(move |j| (i, j))) {
                let (a, b) = (slope([i, j], seed), slope([i + x, j + y], seed));
                sums[0] += a[0] * b[0] + a[1] * b[1];
                sums[1] += a[0] * b[1] - a[1] * b[0];
                sums[2] += 3.0 * value([i, j], seed) * value([i + x, j + y], seed);
            }
            let count = (4 * SIDE * SIDE) as f64;
            let limit = 5.0 / count.sqrt();
            assert!(sums.iter().all(|sum| (sum / count).abs() < limit), "seed {seed} ({x}, {y}): {sums:?}");
        }
    }
    // Every direction as often as every other, within five standard errors.
    let mut counts = [0.0; 16];
    for (i, j) in (-SIDE..SIDE).flat_map(|i| (-SIDE..SIDE).map(move |j| (i, j))) {
        counts[(word([i, j], 3) >> 28) as usize] += 1.0;
    }
    let even = (4 * SIDE * SIDE) as f64 / 16.0;
    assert!(counts.iter().all(|count| (count - even).abs() < 5.0 * even.sqrt()), "{counts:?}");
}
