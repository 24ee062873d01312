//! The binary `evaluate`, as a user runs it.

use std::io::Write;
use std::process::{Command, Stdio};

use spirv_tests::kernel::Function;

/// Standard output, standard error and success of a run with the given input.
fn run(arguments: &[&str], input: &str) -> (String, String, bool) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_evaluate"));
    let command = command.args(arguments).stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().unwrap();
    // A run that refuses its arguments reads no input.
    let _ = child.stdin.take().unwrap().write_all(input.as_bytes());
    let output = child.wait_with_output().unwrap();
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
    (text(output.stdout), text(output.stderr), output.status.success())
}

fn refused(arguments: &[&str], input: &str) -> String {
    let (output, error, success) = run(arguments, input);
    assert!(!success && output.is_empty(), "{arguments:?} gave {output}");
    error
}

#[test]
fn lists_every_function_with_its_signature_on_a_line() {
    let (output, _, success) = run(&["--list"], "");
    let functions = Function::shelf().unwrap();
    assert!(success);
    assert_eq!(output.lines().count(), functions.len());
    assert!(output.lines().any(|line| line == "fn normal_cdf(x: f32) -> f32"), "{output}");
    assert!(!output.contains("( ") && !output.contains(", )"), "{output}");
    assert!(output.lines().all(|line| line.starts_with("fn ") && line.contains(") -> ")), "{output}");
}

#[test]
fn evaluates_points_and_prints_nine_digits() {
    let (output, error, success) = run(&["normal_cdf"], "0\n\n  -1.25 \n1e1\nnan\n");
    assert!(success, "{error}");
    let lines: Vec<&str> = output.lines().collect();
    assert_eq!((lines.len(), lines[0], lines[2]), (4, "5.00000000e-1", "1.00000000e0"));
    // Abramowitz and Stegun 1964, table 26.1: P(1.25) = 0.89435 02263 33145.
    assert!((lines[1].parse::<f64>().unwrap() - (1.0 - 0.894_350_226_333_145)).abs() < 4e-7, "{}", lines[1]);
    for line in &lines[..3] {
        assert_eq!(line.split('e').next().unwrap().trim_start_matches('-').len(), 10, "{line}");
    }
    assert_eq!(run(&["normal_cdf"], ""), (String::new(), String::new(), true));
}

#[test]
fn flattens_vectors_and_their_results() {
    // J = diag(2, 3), σ = ½: variances 1 and 2.25.
    let (output, error, success) = run(&["footprint_covariance_round"], "2 0 0 3 0.5\n");
    assert!(success, "{error}");
    assert_eq!(output, "1.00000000e0 0.00000000e0 2.25000000e0\n");
}

#[test]
fn without_a_device_it_fails_with_the_way_to_get_one() {
    let mut command = Command::new(env!("CARGO_BIN_EXE_evaluate"));
    let command = command.arg("normal_cdf").stdin(Stdio::null());
    let output = command.env("VK_ICD_FILENAMES", "/nowhere").env("VK_DRIVER_FILES", "/nowhere").output().unwrap();
    let error = String::from_utf8(output.stderr).unwrap();
    assert!(!output.status.success() && output.stdout.is_empty());
    assert!(error.contains("no graphics device answers; on Debian or Ubuntu install"), "{error}");
}

#[test]
fn says_what_is_wrong_and_where() {
    let error = refused(&["normal_cfd"], "0\n");
    assert!(error.contains("no function `normal_cfd`") && error.contains("`normal_cdf`"), "{error}");
    let error = refused(&["texture_kink"], "0 1\n0.5 1 2\n");
    assert!(error.contains("line 2: 3 numbers, expected 2: distance deviation"), "{error}");
    for (input, message) in [
        ("0\none\n", "line 2: `one` for x is no number"),
        ("# 0\n", "line 1: 2 numbers, expected 1: x"),
        ("1e39\n", "line 1: `1e39` for x is no number that a 32-bit float holds"),
    ] {
        let error = refused(&["normal_cdf"], input);
        assert!(error.contains(message), "{error}");
    }
    let error = refused(&["texture_knots"], "0 1\n");
    assert!(error.contains("`texture_knots` reads textures"), "{error}");
    assert!(refused(&[], "").contains("<FUNCTION>"));
    assert!(refused(&["--list", "normal_cdf"], "").contains("cannot be used with"));
}
