//! Where formulas of textbooks break, those of the shelf hold: a table of the report that cannot lie.

use prefilter::gpu::Device;
use spirv_tests::harness::is_pinned;
use spirv_tests::report::extremes::formulas::Formula;
use spirv_tests::report::extremes::pairs::{Pair, WORSE};
use spirv_tests::rows;

#[test]
fn the_shelf_holds_where_textbooks_fail() -> Result<(), String> {
    let device = Device::new().map_err(|error| error.to_string())?;
    let rows = rows::all();
    let mut failures = Vec::new();
    for formula in Formula::ALL {
        let pair = Pair::measure(&device, formula, &rows)?;
        let Pair { textbook_error, shelf_error, promise, .. } = &pair;
        println!("{}: {textbook_error:.1e}, the shelf {shelf_error:.1e} of {promise:.1e}", formula.why());
        // Sines of large phases are right on an NVIDIA H100, and wrong on the pinned driver.
        let right = formula.is_the_devices() && !is_pinned(&device) && shelf_error <= promise;
        if !pair.holds() && !right {
            failures.push(format!("{pair:?}"));
        }
    }
    assert!(failures.is_empty(), "{failures:#?}");
    Ok(())
}

/// A formula that is as good as the shelf's, and one of the shelf that breaks its promise, would be found out.
#[test]
fn what_does_not_fail_or_hold_is_told() -> Result<(), String> {
    let device = Device::new().map_err(|error| error.to_string())?;
    let pair = Pair::measure(&device, Formula::NarrowRamp, &rows::all())?;
    assert!(pair.holds());
    let fine = Pair { textbook_error: WORSE * pair.promise, ..pair.clone() };
    let broken = Pair { shelf_error: 1.1 * pair.promise, ..pair.clone() };
    let lost = Pair { shelf_error: f64::INFINITY, ..pair };
    assert!(!fine.holds() && !broken.holds() && !lost.holds());
    Ok(())
}
