//! Question 2: does every shelf function compute what it promises?

use prefilter::gpu::Device;
use spirv_tests::harness::{judge, FILL};
use spirv_tests::kernel::Function;
use spirv_tests::rows::{self, Row};

#[test]
fn every_function_has_a_row_and_every_row_a_function() {
    assert_eq!(rows::unmatched(&Function::shelf().unwrap(), &rows::all()), [""; 0]);
}

#[test]
fn every_function_keeps_its_promise() {
    let device = Device::new().unwrap();
    let (functions, rows) = (Function::shelf().unwrap(), rows::all());
    assert!(!functions.is_empty());
    println!("{}", device.label());
    let mut failures = Vec::new();
    for function in &functions {
        let rows: Vec<&Row> = rows.iter().filter(|row| row.name == function.name).collect();
        match judge(&device, function, &rows, FILL) {
            Ok(judgement) => println!("{judgement}"),
            Err(failure) => failures.push(failure.to_string()),
        }
    }
    assert!(failures.is_empty(), "\n{}", failures.join("\n"));
}
