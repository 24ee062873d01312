//! Whatever the directions and the slopes: finite numbers, shares between 0 and 1, nothing below the horizon.

use std::f64::consts::PI;

use spirv_tests::any;

use crate::{direction, results, single, Random};

const CHAIN: &str = "
struct outcome { parameters: vec4f, lambdas: vec4f, shares: vec4f, both: vec4f }
fn judged(view: vec3f, light: vec3f, covariance: vec3f, mean_slope: vec2f) -> outcome {
    let a = vec2f(smith_parameter(view, covariance, mean_slope), smith_parameter(light, covariance, mean_slope));
    let others = vec2f(smith_parameter_level(view, covariance), smith_parameter_round(view, sqrt(covariance.x)));
    let fine = vec2f(smith_lambda(a.x), smith_lambda(a.y));
    let fast = vec2f(smith_lambda_fast(a.x), smith_lambda_fast(a.y));
    let independence = visibility_independence(view, light);
    let left = visibility_correlated(fine.x, fine.y, independence);
    let shares = vec4f(visibility_masking(fine.x), visibility_shadowing(fine.x, fine.y),
        visibility_shadowing(fast.x, fast.y), visibility_shadowing(fine.x, left));
    let both = vec4f(visibility_masking(fine.x + fine.y), visibility_masking(fine.x + left), independence,
        visibility_shadowing(fine.x, 0.0));
    return outcome(vec4f(a, others), vec4f(fine, fast), shares, both);
}";

/// What the chain returns, by name.
struct Outcome {
    parameters: [f64; 4],
    lambdas: [f64; 4],
    masking: f64,
    shadowing: f64,
    shadowing_fast: f64,
    correlated: f64,
    joint: f64,
    joint_correlated: f64,
    independence: f64,
    unshadowed: f64,
}

impl Outcome {
    fn all(points: &[Vec<f64>]) -> Vec<Self> {
        let outcome = |got: Vec<f64>| {
            let four = |from: usize| [got[from], got[from + 1], got[from + 2], got[from + 3]];
            let [masking, shadowing, shadowing_fast, correlated] = four(8);
            let [joint, joint_correlated, independence, unshadowed] = four(12);
            let (parameters, lambdas) = (four(0), four(4));
            Self {
                parameters,
                lambdas,
                masking,
                shadowing,
                shadowing_fast,
                correlated,
                joint,
                joint_correlated,
                independence,
                unshadowed,
            }
        };
        results(CHAIN, points).into_iter().map(outcome).collect()
    }
}

/// Points at a time.
const BATCH: usize = 200_000;

fn any_point(random: &mut Random) -> Vec<f64> {
    let view = any::direction(random);
    let other = any::direction(random);
    let light = random.pick([other, other, other, other, other, view, view, view.map(|x| -x)]);
    [&view[..], &light, &any::covariance(random), &any::slope(random)].concat()
}

#[test]
fn extreme_inputs_stay_in_their_ranges() {
    let mut random = Random::new(6);
    let (mut hidden, mut partly) = (0, 0);
    for _ in 0..any::inputs(1_000_000) / BATCH {
        let points: Vec<Vec<f64>> = (0..BATCH).map(|_| any_point(&mut random)).collect();
        let outcomes = Outcome::all(&points);
        assert_eq!(outcomes.len(), points.len());
        for (point, outcome) in points.iter().zip(&outcomes) {
            let Outcome { parameters, lambdas, masking, shadowing, shadowing_fast, correlated, .. } = outcome;
            let shares = [masking, shadowing, shadowing_fast, correlated, &outcome.joint, &outcome.joint_correlated];
            assert!(parameters.iter().all(|a| (0.0..=10.0).contains(a)), "{point:?}: {parameters:?}");
            assert!(lambdas.iter().all(|lambda| (0.0..=3e6).contains(lambda)), "{point:?}: {lambdas:?}");
            assert!(shares.iter().all(|share| (0.0..=1.0).contains(*share)), "{point:?}: {shares:?}");
            assert!((0.0..=0.934).contains(&outcome.independence), "{point:?}: {}", outcome.independence);
            if parameters[0] == 0.0 || parameters[1] == 0.0 {
                let [_, lit @ ..] = shares;
                assert!(lit.iter().all(|share| **share == 0.0), "{point:?}: {shares:?}");
                hidden += 1;
            } else {
                assert!(shares.iter().all(|share| **share > 0.0), "{point:?}: {shares:?}");
                assert_eq!(outcome.unshadowed, 1.0, "{point:?}");
                assert!(correlated >= &(shadowing - 2e-7), "{point:?}: {shares:?}");
                let (product, joint) = (masking * shadowing, outcome.joint);
                assert!((product - joint).abs() < 4e-7 * joint, "{point:?}: {product} and {joint}");
                partly += usize::from(*shadowing < 0.99);
            }
        }
    }
    assert!(hidden > 100_000 && partly > 100_000, "{hidden}, {partly}");
}

#[test]
fn seen_along_the_light_every_point_is_lit() {
    let mut random = Random::new(7);
    let points = (0..10_000).map(|_| {
        let toward = direction(random.between(1e-6, 1.0), 2.0 * PI * random.unit());
        let [x, y] = [random.between(0.01, 3.0), random.between(0.01, 3.0)];
        let covariance = single([x * x, 0.9 * (2.0 * random.unit() - 1.0) * x * y, y * y]);
        [&toward[..], &toward, &covariance, &[0.0; 2]].concat()
    });
    let points: Vec<Vec<f64>> = points.collect();
    let mut halves = 0;
    for (point, outcome) in points.iter().zip(Outcome::all(&points)) {
        // The paper's sum, for contrast, goes down to one half.
        let [lambda, ..] = outcome.lambdas;
        assert!((outcome.correlated - 1.0).abs() < 2e-6, "{point:?}: {}", outcome.correlated);
        assert!((outcome.shadowing - (1.0 + lambda) / (1.0 + 2.0 * lambda)).abs() < 2e-7, "{point:?}");
        halves += usize::from(outcome.shadowing < 0.51);
    }
    assert!(halves > 1_000, "{halves}");
}

#[test]
fn horizons_and_flat_surfaces() {
    let usual = [0.25, 0.05, 0.16];
    let up = [0.0, 0.0, 1.0];
    let case = |view: [f64; 3], light: [f64; 3], covariance: [f64; 3], mean_slope: [f64; 2]| {
        let point = [&single(view)[..], &single(light), &single(covariance), &single(mean_slope)].concat();
        Outcome::all(&[point]).remove(0)
    };
    for z in [-1.0, -0.3, -1e-6, -1e-30, 0.0, -0.0] {
        let below = direction(z, 0.7);
        let unlit = case(up, below, usual, [0.0; 2]);
        assert_eq!((unlit.masking, unlit.shadowing, unlit.correlated, unlit.joint), (1.0, 0.0, 0.0, 0.0), "{z}");
        let unseen = case(below, up, usual, [0.0; 2]);
        assert_eq!((unseen.masking, unseen.shadowing, unseen.correlated, unseen.joint), (0.0, 0.0, 0.0, 0.0), "{z}");
        // A flat surface has the same horizon.
        assert_eq!(case(up, below, [0.0; 3], [0.0; 2]).shadowing, 0.0, "{z}");
    }
    for z in [1e-17, 1e-6, 0.3, 1.0] {
        let flat = case(direction(z, 0.7), direction(z, 2.0), [0.0; 3], [0.0; 2]);
        assert_eq!((flat.masking, flat.shadowing, flat.correlated), (1.0, 1.0, 1.0), "{z}");
    }
    // A plane that rises by 1 along x stands in the way of what comes flatter from there, and of nothing from behind.
    assert_eq!(case([0.8, 0.0, 0.6], up, usual, [1.0, 0.0]).masking, 0.0);
    assert!(case([0.6, 0.0, 0.8], up, usual, [1.0, 0.0]).masking > 0.0);
    assert!(case([-0.8, 0.0, 0.6], up, usual, [1.0, 0.0]).masking > 0.99);
    // Roughness along x alone does not hide what is seen along y.
    let ridges = case([0.0, 0.999_95, 0.01], [0.999_95, 0.0, 0.01], [0.25, 0.0, 0.0], [0.0; 2]);
    assert_eq!(ridges.masking, 1.0);
    assert!(ridges.shadowing < 0.1, "{}", ridges.shadowing);
}
