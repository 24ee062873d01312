//! Question 3 for the tabulated driver: is the model good? Real images on a plane to the horizon, against brute force.

use prefilter::gpu::Device;
use prefilter::Taps;
use spirv_tests::demo::input::Input;
use spirv_tests::demo::judge::{judge, Judged, Sizes};
use spirv_tests::demo::method::Method;
use spirv_tests::demo::{table, Error};
use spirv_tests::maps;

const SIZES: Sizes = Sizes { still: [112, 96], moving: [56, 48], frames: 6 };

fn judged(input: &Input) -> Result<Judged, Error> {
    let judged = judge(&Device::new()?, input, SIZES, &|_| ())?;
    println!("{}", table::text(&judged));
    Ok(judged)
}

/// RMS of a method's still; NaN, which no comparison passes, where there is none.
fn rms(judged: &Judged, method: Method) -> f64 {
    judged.row(method).map_or(f64::NAN, |row| row.deviation.rms)
}

/// Whether the truth is known three times better than every figure that is compared.
fn truth_is_sharp(judged: &Judged) {
    let figures = judged.rows.iter().map(|row| row.deviation.rms).chain(judged.brute.iter().map(|brute| brute.1));
    for figure in figures {
        assert!(3.0 * judged.truth_error < figure, "a figure of {figure} against {}", judged.truth_error);
    }
    for (number, moving) in judged.motions.iter().enumerate() {
        for row in &judged.rows {
            let figure = row.shimmer[number];
            assert!(
                3.0 * moving.truth_error < figure,
                "{}: {figure} against {}",
                row.method.label(),
                moving.truth_error
            );
        }
    }
}

/// What one tap and eight taps owe to the others.
fn keeps_its_promises(judged: &Judged) {
    let [naive, paper] = [Method::Naive, Method::Paper].map(|method| rms(judged, method));
    let [one, eight] = [Taps::One, Taps::Eight].map(|taps| rms(judged, Method::Ours(taps)));
    assert!(one <= naive / 3.0, "one tap {one}, naive {naive}");
    assert!(one < paper, "one tap {one}, paper {paper}");
    assert!(eight <= paper / 2.0, "eight taps {eight}, paper {paper}");
    for number in 0..judged.motions.len() {
        let shimmer = |method| judged.row(method).map_or(f64::NAN, |row| row.shimmer[number]);
        let [one, eight] = [Taps::One, Taps::Eight].map(|taps| shimmer(Method::Ours(taps)));
        assert!(one < shimmer(Method::Paper) && eight < one, "{one} {eight} {}", shimmer(Method::Paper));
        assert!(one <= shimmer(Method::Naive) / 3.0, "{one} {}", shimmer(Method::Naive));
    }
    assert_eq!(judged.motions.len(), 2);
}

#[test]
fn a_terrain_to_the_horizon() -> Result<(), Error> {
    let judged = judged(&Input::terrain()?)?;
    truth_is_sharp(&judged);
    keeps_its_promises(&judged);
    Ok(())
}

#[test]
fn gravel_with_hard_edges_to_the_horizon() -> Result<(), Error> {
    let judged = judged(&Input::gravel()?)?;
    truth_is_sharp(&judged);
    keeps_its_promises(&judged);
    Ok(())
}

/// Six hard edges all over the gravel's range: the hardest map for a Gaussian.
#[test]
fn gravel_in_six_steps_to_the_horizon() -> Result<(), Error> {
    let map = maps::named("steps6").map_err(|error| Error::Map(error.to_string()))?;
    let judged = judged(&Input { map, title: "gravel in six steps", ..Input::gravel()? })?;
    truth_is_sharp(&judged);
    keeps_its_promises(&judged);
    Ok(())
}
