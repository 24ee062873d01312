//! Curves are what they say, and refuse what they cannot be.

use prefilter::{Error, HeightTransfer, Ranges};
use spirv_tests::random::Random;

use crate::{curves, Outcome};

/// Slopes are the differences of heights over short ways, and heights do not jump.
#[test]
fn slopes_are_those_of_heights() -> Outcome {
    let mut random = Random::new(11);
    for (name, curve, [low, high]) in curves()? {
        let mut bends = 0;
        for _ in 0..2000 {
            let at = low + (high - low) * random.unit();
            let step = 1e-6;
            let [left, right] = [at - step, at + step].map(|value| curve.height(value));
            let (least, greatest) = curve.slopes(at - step, at + step);
            let slope = (right - left) / (2.0 * step);
            assert!(slope > least - 1e-8 && slope < greatest + 1e-8, "{name} at {at}: {slope}, {least} to {greatest}");
            if greatest - least > 1e-3 {
                bends += 1;
            } else {
                assert!((slope - curve.slope(at)).abs() < 2e-3, "{name} at {at}: {slope}, {}", curve.slope(at));
            }
        }
        assert!(bends < 20, "{name} bends at {bends} of 2000 places");
    }
    Ok(())
}

/// No height leaves the range of an interval, and both its ends are reached, to what a fine comb finds.
#[test]
fn ranges_are_reached() -> Outcome {
    let mut random = Random::new(12);
    for (name, curve, [low, high]) in curves()? {
        for _ in 0..100 {
            let ends = [random.unit(), random.unit()].map(|part| low + (high - low) * part);
            let (from, to) = (ends[0].min(ends[1]), ends[0].max(ends[1]));
            let comb = || (0..=4000).map(|part| from + (to - from) * f64::from(part) / 4000.0);
            let found = |f: &dyn Fn(f64) -> f64| {
                comb()
                    .map(f)
                    .fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), next| (least.min(next), most.max(next)))
            };
            let (heights, range) = (found(&|value| curve.height(value)), curve.range(from, to));
            assert!(range.0 <= heights.0 + 1e-12 && range.1 >= heights.1 - 1e-12, "{name}: {heights:?} {range:?}");
            assert!(range.0 > heights.0 - 2e-3 && range.1 < heights.1 + 2e-3, "{name}: {heights:?} {range:?}");
            let (slopes, range) = (found(&|value| curve.slope(value)), curve.slopes(from, to));
            assert!(range.0 <= slopes.0 + 1e-9 && range.1 >= slopes.1 - 1e-9, "{name}: {slopes:?} {range:?}");
            assert!(range.0 > slopes.0 - 0.05 && range.1 < slopes.1 + 0.05, "{name}: {slopes:?} {range:?}");
        }
    }
    Ok(())
}

#[test]
fn named_curves_are_what_they_say() -> Outcome {
    let step = HeightTransfer::smoothstep(0.0, 1.25)?;
    assert_eq!([-1.0, 0.625, 2.0].map(|f| step.height(f)), [0.0, 0.5, 1.0]);
    assert!((step.slope(0.625) - 1.2).abs() < 1e-7);
    assert_eq!(step.range(f64::NEG_INFINITY, f64::INFINITY), (0.0, 1.0));
    let absolute = HeightTransfer::absolute();
    assert_eq!([-0.3, 0.3].map(|f| (absolute.height(f), absolute.slope(f))), [(0.3, -1.0), (0.3, 1.0)]);
    assert_eq!(absolute.range(f64::NEG_INFINITY, f64::INFINITY), (0.0, f64::INFINITY));
    assert!(!absolute.is_monotone() && step.is_monotone());
    let terraces = HeightTransfer::terraces(4, 0.2)?;
    for level in 0..=4 {
        let (at, height) = (0.25 * f64::from(level), 0.25 * f64::from(level));
        assert!((terraces.height(at) - height).abs() < 1e-12 && terraces.slope(at) == 0.0, "{level}");
        let middle = terraces.height(at + 0.125);
        assert!((middle - (height + 0.125).min(1.0)).abs() < 1e-12, "{level}: {middle}");
    }
    for (exponent, height) in [(1.0, -0.7), (2.0, -0.49), (3.0, -0.343), (1.5, -0.7f64 * 0.7f64.sqrt())] {
        let power = HeightTransfer::power(exponent)?;
        assert!((power.height(-0.7) - height).abs() < 1e-12 && power.is_monotone());
    }
    let samples = HeightTransfer::samples(0.0, 1.0, &[0.0, 0.1, 0.5, 0.6])?;
    assert!(samples.is_monotone() && (samples.height(2.0 / 3.0) - 0.5).abs() < 1e-12);
    assert!((samples.slope(1.0 / 3.0) - 2.0 * 0.3 * 1.2 / 1.5).abs() < 1e-6, "{}", samples.slope(1.0 / 3.0));
    let scaled = HeightTransfer::knots([(0.0, 0.0), (1.0, 1.0)])?.scaled(2.0, 1.0)?.scaled(-1.0, 0.5)?;
    assert_eq!([0.0, 0.5, 1.0].map(|f| scaled.height(f)), [-0.5, -1.5, -2.5]);
    Ok(())
}

/// Between crossings the curve stays on one side of the height, or on it, and it is on the height where they are.
#[test]
fn crossings_part_the_curve() -> Outcome {
    let mut random = Random::new(13);
    for (name, curve, [low, high]) in curves()? {
        let (least, most) = curve.range(low, high);
        // Those of treads and knots too.
        let heights = [0.2, 0.4, 0.6].into_iter().chain((0..50).map(|_| least + (most - least) * random.unit()));
        for height in heights.collect::<Vec<_>>() {
            let crossings = curve.crossings(low, high, height);
            assert!(
                crossings.is_sorted() && crossings.iter().all(|&at| low < at && at < high),
                "{name}: {crossings:?}"
            );
            for &at in &crossings {
                assert!((curve.height(at) - height).abs() < 1e-12, "{name}: {height} at {at}");
            }
            let ends: Vec<f64> = [low].into_iter().chain(crossings).chain([high]).collect();
            for pair in ends.windows(2) {
                let within = (1..50).map(|part| pair[0] + (pair[1] - pair[0]) * f64::from(part) / 50.0);
                let sides: Vec<f64> = within.map(|value| curve.height(value) - height).collect();
                let one = sides.iter().all(|&side| side > 0.0) || sides.iter().all(|&side| side < 0.0);
                assert!(one || sides.iter().all(|side| side.abs() < 1e-12), "{name}: {height}, {pair:?}: {sides:?}");
            }
        }
    }
    let terraces = HeightTransfer::terraces(2, 0.5)?;
    assert_eq!(terraces.crossings(-1.0, 2.0, 0.5), [0.375, 0.625]);
    assert_eq!(HeightTransfer::absolute().crossings(-1.0, 2.0, 0.0), [0.0]);
    // Ends without an end, and none: the search comes to one.
    let endless = [f64::NEG_INFINITY, f64::INFINITY];
    for (exponent, height, expected) in [(1.0, 0.25, 0.25), (2.0, 0.25, 0.5), (2.5, 32.0, 4.0)] {
        let found = HeightTransfer::power(exponent)?.crossings(endless[0], endless[1], height);
        assert!(found.len() == 1 && (found[0] - expected).abs() < 1e-12, "{found:?}");
    }
    let both = HeightTransfer::absolute().crossings(endless[0], endless[1], 2.0);
    assert!(both.len() == 2 && (both[0] + 2.0).abs() < 1e-12 && (both[1] - 2.0).abs() < 1e-12, "{both:?}");
    assert!(HeightTransfer::absolute().crossings(f64::NAN, 1.0, f64::NAN).is_empty());
    Ok(())
}

#[test]
fn ranges_are_those_given_or_of_the_bends() -> Outcome {
    let step = HeightTransfer::smoothstep(0.5, 1.5)?;
    assert_eq!(Ranges::of_transfer(&step), Ranges { mean: (0.0, 2.0), deviation: 0.5 });
    let given = step.over((-1.0, 3.0), 0.25).scaled(2.0, 0.0)?;
    assert_eq!(Ranges::of_transfer(&given), Ranges { mean: (-1.0, 3.0), deviation: 0.25 });
    assert_eq!(serde_json::from_str::<HeightTransfer>(&serde_json::to_string(&given)?)?, given);
    let absolute = HeightTransfer::absolute();
    assert_eq!(Ranges::of_transfer(&absolute), Ranges { mean: (-2.0, 2.0), deviation: 1.0 });
    Ok(())
}

#[test]
fn what_has_no_slope_is_refused() {
    let wrong = |curve: Result<HeightTransfer, Error>, part: &str| match curve {
        Err(error) => assert!(error.to_string().contains(part), "{error}"),
        Ok(curve) => panic!("{curve:?} was accepted"),
    };
    wrong(HeightTransfer::knots([(0.0, 0.0), (0.5, 0.2), (0.5, 0.8)]), "the slope behind knot 1");
    wrong(HeightTransfer::knots([(0.0, 0.0), (-0.5, 0.2)]), "the slope behind knot 0");
    wrong(HeightTransfer::knots([(0.0, 0.0), (1e-7, 0.2)]), "a cliff has no slope");
    wrong(HeightTransfer::knots([]), "the knots of a height transfer");
    wrong(HeightTransfer::knots([(f32::NAN, 0.0)]), "the value of knot 0");
    wrong(HeightTransfer::knots([(0.0, f32::INFINITY)]), "the height of knot 0");
    wrong(HeightTransfer::samples(0.0, 1.0, &[0.5]), "the samples");
    wrong(HeightTransfer::samples(1.0, 1.0, &[0.5, 0.6]), "the slope behind sample 0");
    wrong(HeightTransfer::samples(0.0, 1.0, &[0.5, f32::NAN]), "sample 1");
    wrong(HeightTransfer::smoothstep(0.5, 0.5), "the slope of a smoothstep");
    wrong(HeightTransfer::smoothstep(0.5, 0.2), "the slope of a smoothstep");
    wrong(HeightTransfer::terraces(0, 0.5), "the risers of terraces");
    wrong(HeightTransfer::terraces(3, 0.0), "a riser's share");
    wrong(HeightTransfer::terraces(3, f32::NAN), "a riser's share");
    wrong(HeightTransfer::power(0.5), "the exponent");
    wrong(HeightTransfer::absolute().scaled(f32::NAN, 0.0), "the amplitude");
    wrong(HeightTransfer::absolute().scaled(1.0, f32::INFINITY), "the offset");
}

/// What is read back is the curve, and what is read back wrong is refused.
#[test]
fn curves_go_through_text() -> Outcome {
    for (name, curve, _) in curves()? {
        let text = serde_json::to_string(&curve)?;
        assert_eq!(serde_json::from_str::<HeightTransfer>(&text)?, curve, "{name}: {text}");
    }
    let text = serde_json::to_string(&HeightTransfer::smoothstep(0.25, 0.5)?)?;
    let read = serde_json::from_str::<HeightTransfer>(&text.replace("0.25", "0.75"));
    assert!(read.is_err_and(|error| error.to_string().contains("smoothstep")));
    Ok(())
}
