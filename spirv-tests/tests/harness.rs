//! The harness must fail where it should: a wrong shader, an unwritten output, a NaN, a slack promise, a missing row or
//! clause, no case at all.

use prefilter::gpu::{Device, Kernel, Work};
use spirv_tests::contract::{Contract, Domain, Promise};
use spirv_tests::fill;
use spirv_tests::harness::{compare, finite, is_pinned, judge, Failure, Judgement};
use spirv_tests::kernel::Function;
use spirv_tests::rows::{self, Row};

const COUNT: usize = 1_000;

/// A function `double` with the given contract and body.
fn double(domain: &str, error: &str, body: &str) -> Function {
    let text = format!(
        "/// Twice a number.\n///\n/// Source: the definition.\n/// {domain}\n/// {error}\n\
         fn double(x: f32) -> f32 {{ {body} }}"
    );
    Function::in_text(&text, "double").unwrap()
}

fn good() -> Function {
    // Devices may flush the smallest numbers to zero: exact for floats holds only away from it.
    double("Domain: x in [1, 5].", "Error: exact.", "return 2.0 * x;")
}

fn row() -> Row {
    Row::new("double", |x| [x[0] + x[0]])
}

fn judged(function: &Function, row: Row) -> Result<Judgement, Failure> {
    judge(&Device::new().unwrap(), function, &[&row], COUNT)
}

#[test]
fn a_right_shader_passes_with_all_its_cases() {
    let judgement = judged(&good(), row().at([[1.5]])).unwrap();
    assert!(judgement.cases > COUNT && judgement.outside > 100, "{judgement}");
    assert_eq!(judgement.worst.error, 0.0);
}

#[test]
fn a_wrong_shader_fails_at_its_worst_point() {
    let wrong =
        double("Domain: x in [-3, 5].", "Error: 1e-3 absolute.", "return 2.0 * x + select(0.0, 0.01, x > 4.9);");
    let Err(Failure::Broken(judgement)) = judged(&wrong, row()) else { panic!("it passed") };
    assert!(judgement.worst.point[0] > 4.9 && (judgement.worst.error - 0.01).abs() < 1e-5, "{judgement}");
    let relative = double("Domain: x log in [1e-6, 1].", "Error: 1e-4 relative.", "return 2.0 * x + 1e-9;");
    let Err(Failure::Broken(judgement)) = judged(&relative, row()) else { panic!("it passed") };
    assert!(judgement.worst.error > 4e-4, "{judgement}");
}

#[test]
fn one_and_the_result_bound_small_results_absolutely_and_large_ones_relatively() {
    let error = "Error: 1e-3 of 1 + the result; for a reason.";
    let judged = |body: &str| judged(&double("Domain: x log in [1e-6, 1e6].", error, body), row());
    assert_eq!(judged("return 2.0 * x + 9e-4 * (1.0 + 2.0 * x);").unwrap().promise, Promise::Mixed(1e-3));
    let Err(Failure::Broken(judgement)) = judged("return 2.0 * x + 1.1e-3;") else { panic!("it passed") };
    assert!(judgement.worst.point[0] < 0.05, "{judgement}");
    let Err(Failure::Broken(judgement)) = judged("return 2.0022 * x;") else { panic!("it passed") };
    assert!(judgement.worst.point[0] > 5.0, "{judgement}");
    let pinned = is_pinned(&Device::new().unwrap());
    assert_eq!(matches!(judged("return 2.0 * x + 1e-4;"), Err(Failure::Slack(_))), pinned);
}

#[test]
fn a_wrong_edge_fails() {
    // Only the edge itself is wrong, which no fill meets.
    let wrong = double("Domain: x in [-3, 5].", "Error: exact.", "return select(2.0 * x, 0.0, x == 5.0);");
    assert!(matches!(judged(&wrong, row()), Err(Failure::Broken(_))));
    let zero = double("Domain: x in [-3, 5].", "Error: exact.", "return select(2.0 * x, 1.0, x == 0.0);");
    assert!(matches!(judged(&zero, row()), Err(Failure::Broken(_))));
    let breakpoint = double("Domain: x in [-3, 5].", "Error: exact.", "return select(2.0 * x, 1.0, x == 1.5);");
    assert!(matches!(judged(&breakpoint, row().at([[1.5]])), Err(Failure::Broken(_))));
}

#[test]
fn a_nan_fails_in_and_outside_the_domain() {
    let nan = "bitcast<f32>(0x7fc00000u + u32(x != x))";
    let inside =
        double("Domain: x in [-3, 5].", "Error: 1e30 absolute.", &format!("return select(2.0 * x, {nan}, x == 5.0);"));
    let Err(Failure::Broken(judgement)) = judged(&inside, row()) else { panic!("it passed") };
    assert_eq!(judgement.worst.error, f64::INFINITY);
    for wrong in [nan, "1.0 / (x - x)"] {
        let outside =
            double("Domain: x in [-3, 5].", "Error: exact.", &format!("return select(2.0 * x, {wrong}, x > 6.0);"));
        assert!(matches!(judged(&outside, row()), Err(Failure::NotFinite { .. })));
    }
}

#[test]
fn a_nan_of_the_reference_fails() {
    let row = Row::new("double", |x| [if x[0] > 4.9 { f64::NAN } else { 2.0 * x[0] }]);
    assert!(matches!(judged(&good(), row), Err(Failure::Broken(_))));
    let short = Row::new("double", |_| [0.0; 0]);
    assert!(matches!(judged(&good(), short), Err(Failure::Broken(_))));
}

#[test]
fn an_unwritten_output_fails() {
    let text = "@group(0) @binding(0) var<storage, read_write> output: array<f32>;
        @compute @workgroup_size(1) fn main() { output[0] = 2.0; }";
    let kernel = Kernel::new(&Device::new().unwrap(), text, "main").unwrap();
    let output = kernel.run(&Work { inputs: &[], textures: &[], invocations: 1, output: 2 }).unwrap();
    let results: Vec<Vec<f64>> = output.iter().map(|&value| vec![f64::from(value)]).collect();
    let points = [vec![1.0], vec![2.0]];
    let compared = compare(&good(), Promise::Absolute(1e30), &row(), &points, &results);
    let Err(Failure::Broken(judgement)) = compared else { panic!("it passed") };
    assert_eq!((judgement.worst.point.as_slice(), judgement.worst.error), ([2.0].as_slice(), f64::INFINITY));
    assert!(matches!(finite(&good(), &points, &results), Err(Failure::NotFinite { .. })));
}

#[test]
fn a_device_may_flush_subnormal_steps_but_no_others() {
    let tiny = Row::new("double", |x| [x[0]]);
    let compared = |expected: f64, got: f64| {
        compare(&good(), Promise::Relative(1e-6), &tiny, &[vec![expected]], &[vec![got]])
            .map(|judged| judged.worst.error)
    };
    assert_eq!(compared(1.1e-38, 0.0), Ok(0.0));
    // A factor of the result may have been subnormal.
    assert_eq!(compared(7e-37, 0.0), Ok(0.0));
    assert!(matches!(compared(8e-37, 0.0), Err(Failure::Broken(_))));
    assert!(matches!(compared(1.1e-38, 1e-37), Err(Failure::Broken(_))));
    assert!(matches!(compared(1.1e-38, f64::NAN), Err(Failure::Broken(_))));
}

#[test]
fn no_case_fails() {
    let compared =
        |points: &[Vec<f64>], results: &[Vec<f64>]| compare(&good(), Promise::Exact, &row(), points, results);
    assert!(matches!(compared(&[], &[]), Err(Failure::NoCases { cases: 0, .. })));
    assert!(matches!(compared(&[vec![1.0], vec![2.0]], &[vec![2.0]]), Err(Failure::NoCases { cases: 1, .. })));
    for condition in [|_: &[f64]| false, |point: &[f64]| point[0] < 1.5] {
        assert!(matches!(judged(&good(), row().only_where(condition)), Err(Failure::NoCases { .. })));
    }
    assert!(judged(&good(), row().only_where(|point| point[0] < 4.0)).is_ok());
}

#[test]
#[should_panic(expected = "a broken reference")]
fn a_reference_that_panics_fails() {
    let _ =
        judged(&good(), Row::new("double", |x| if x[0] > 4.9 { panic!("a broken reference") } else { [2.0 * x[0]] }));
}

#[test]
fn a_row_with_points_of_another_function_fails() {
    let message = "the row `double` has points of 2 numbers, not 1".to_owned();
    assert_eq!(judged(&good(), row().at([[1.0, 2.0]])), Err(Failure::Contract(message)));
}

#[test]
fn a_slack_promise_fails_on_the_pinned_driver() {
    let slack = double("Domain: x in [-3, 5].", "Error: 4.1e-3 absolute.", "return 2.0 * x + 0.001;");
    let tight = double("Domain: x in [-3, 5].", "Error: 3.9e-3 absolute.", "return 2.0 * x + 0.001;");
    assert!(judged(&tight, row()).is_ok());
    let pinned = is_pinned(&Device::new().unwrap());
    assert_eq!(matches!(judged(&slack, row()), Err(Failure::Slack(_))), pinned);
}

#[test]
fn a_missing_row_and_a_stray_row_fail() {
    let none = judge(&Device::new().unwrap(), &good(), &[], COUNT);
    assert_eq!(none, Err(Failure::NoRow("double".into())));
    let missing = rows::unmatched(&[good()], &[Row::new("triple", |x| [3.0 * x[0]])]);
    assert_eq!(missing.len(), 2, "{missing:?}");
    assert!(rows::unmatched(&[good()], &[row()]).is_empty());
}

#[test]
fn a_broken_contract_names_the_function_and_the_clause() {
    let refused = |domain: &str, error: &str| Contract::of(&double(domain, error, "return x;")).unwrap_err();
    for (domain, error, message) in [
        ("Domain: x in [0, 1].", "", "`double`: the clause `Error:` is missing"),
        ("", "Error: exact.", "`double`: the clause `Domain:` is missing"),
        ("Domain: y in [0, 1].", "Error: exact.", "`double`: `Domain:` does not name `x`"),
        ("Domain: x in [0, 1], y in [0, 1].", "Error: exact.", "`double`: `Domain:` names `y`, which is no parameter"),
        ("Domain: x in [2, 1].", "Error: exact.", "bounds are not two numbers in rising order"),
        ("Domain: x in [0, one].", "Error: exact.", "says `one`, which is no number"),
        ("Domain: x log in [0, 1].", "Error: exact.", "logarithms begin above 0"),
        ("Domain: x unit.", "Error: exact.", "gives `x` a range that its type has not"),
        ("Domain: x psd(1, 2, 0.9).", "Error: exact.", "gives `x` a range that its type has not"),
        ("Domain: x near 1.", "Error: exact.", "says `x near 1`; known are"),
        ("Domain: x in [0, 1].", "Error: small.", "`double`: `Error:` says `small`; known are"),
        ("Domain: x in [0, 1].", "Error: 0 absolute.", "promises 0, which is no positive number"),
        ("Domain: x in [0, 1].", "Error: 1e-3 of it.", "known are `NUMBER absolute`"),
        ("Domain: x in [0, 1].", "Error: 0 of 1 + the result.", "promises 0, which is no positive number"),
    ] {
        let refused = refused(domain, error);
        assert!(refused.contains("`double`") && refused.contains(message), "{refused}");
    }
}

#[test]
fn contracts_fill_their_domains() {
    let text = "/// Source: the definition.
        /// Domain: n unit upper, c psd(0.5, 2, 0.9), s.d log in [0.1, 1],
        /// s.k integer in [-2, 3].
        /// Error: 1e-3 relative; for a reason.
        fn f(n: vec3f, c: vec3f, s: pair, t: texture_2d<f32>) -> f32 { return n.x; }
        struct pair { d: vec2f, k: i32 }";
    let text: String = text.lines().map(|line| format!("{}\n", line.trim_start())).collect();
    let function = Function::in_text(&text, "f").unwrap();
    let contract = Contract::of(&function).unwrap();
    assert_eq!((contract.promise, contract.source.as_str()), (Promise::Relative(1e-3), "the definition."));
    assert_eq!(contract.ranges[2].domain, Domain::Logarithmic(0.1, 1.0));
    let points = fill::points(&contract.ranges, 10_000).inside;
    assert!(points.len() > 10_000 && points.iter().all(|point| point.len() == 9));
    let mut seen = [false; 6];
    for point in &points {
        let &[x, y, z, xx, xy, yy, d, e, k] = point.as_slice() else { panic!("{point:?}") };
        assert!((x * x + y * y + z * z - 1.0).abs() < 1e-6 && z >= 0.0, "{point:?}");
        assert!((0.249..=4.01).contains(&xx) && (0.249..=4.01).contains(&yy), "{point:?}");
        assert!(xy.abs() <= 0.900_001 * (xx * yy).sqrt(), "{point:?}");
        assert!([d, e].iter().all(|value| (0.099..=1.01).contains(value)), "{point:?}");
        assert!(k == k.round() && (-2.0..=3.0).contains(&k), "{point:?}");
        seen[(k + 2.0) as usize] = true;
    }
    assert_eq!(seen, [true; 6]);
    // The fill is even: each half of an even axis holds half of the points.
    let upper = points[..10_000].iter().filter(|point| point[2] > 0.5).count();
    assert!((4_900..5_100).contains(&upper), "{upper}");
}

/// A structure from a function of the shelf stands for the function's parameters.
#[test]
fn a_structure_may_come_from_its_maker() {
    let rate = |domain: &str| {
        let text = format!(
            "/// The rate.\n///\n/// Source: the definition.\n/// Domain: {domain}.\n/// Error: 3e-7 relative.\n\
             fn rate(scale: f32, tails: height_tails) -> f32 {{ return scale * tails.rate; }}"
        );
        Function::in_text(&text, "rate")
    };
    let function = rate("scale in [1, 2], tails from height_skewed").unwrap();
    let contract = Contract::of(&function).unwrap();
    let names: Vec<&str> = contract.ranges.iter().map(|range| range.name.as_str()).collect();
    assert_eq!(names, ["scale", "tails.deviation", "tails.skewness"]);
    assert_eq!(contract.ranges[1].domain, Domain::Logarithmic(1e-6, 0.5));
    judged(&function, Row::new("rate", |x| [x[0] / x[1]])).unwrap();
    assert!(matches!(judged(&function, Row::new("rate", |x| [x[0] / x[2]])), Err(Failure::Broken(_))));
    for wrong in ["tails from height_made", "tails from normal_cdf", "scale from height_skewed"] {
        let message = rate(wrong).unwrap_err();
        assert!(message.contains(&format!("says `{wrong}`")), "{message}");
    }
}
