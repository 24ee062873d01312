//! The hard cases of the report: results are numbers in the hull of what there is, and bounds hold where they are
//! promised.

use prefilter::gpu::Device;
use spirv_tests::report::cache::Cache;
use spirv_tests::report::extremes::cases::Case;
use spirv_tests::report::extremes::drivers::{self, Source};
use spirv_tests::report::extremes::filters::Filter;
use spirv_tests::report::extremes::judge;
use spirv_tests::report::extremes::outcome::Outcome;
use spirv_tests::report::extremes::POINTS;

/// Asks that all hold, and says what was measured.
fn all_hold(outcomes: &[Outcome]) {
    let mut failures = Vec::new();
    for outcome in outcomes {
        let Outcome { subject, case, points, judged, error, promised, promised_error, bound, .. } = outcome;
        let bound = bound.map_or(String::new(), |bound| format!(", {promised_error:.1e} of {bound:.1e} at {promised}"));
        println!("{subject}, {}: {error:.1e} at {judged} of {points} points{bound}", case.name());
        if !outcome.holds() {
            failures.push(format!("{outcome:?}"));
        }
    }
    assert!(failures.is_empty(), "{failures:#?}");
}

#[test]
fn filters_hold_in_hard_cases() -> Result<(), String> {
    let device = Device::new().map_err(|error| error.to_string())?;
    let mut outcomes = Vec::new();
    for filter in Filter::ALL {
        let found = judge::outcomes(&device, &Cache::none(), filter, POINTS[1])?;
        // Of every filter some case is within what its bound covers.
        let promised = found.iter().map(|outcome| outcome.promised).sum::<usize>();
        assert!(promised > 0, "{}", filter.name());
        outcomes.extend(found);
    }
    all_hold(&outcomes);
    Ok(())
}

#[test]
fn drivers_hold_in_hard_cases() -> Result<(), String> {
    let device = Device::new().map_err(|error| error.to_string())?;
    let mut outcomes = Vec::new();
    for source in Source::ALL {
        outcomes.extend(drivers::outcomes(&device, source, POINTS[1])?);
    }
    all_hold(&outcomes);
    Ok(())
}

/// Every case is met by something, and a result that is none is told.
#[test]
fn what_does_not_hold_is_told() {
    for case in Case::ALL {
        let filters = Filter::ALL.iter().any(|filter| filter.map(case).is_some());
        let drivers = Source::ALL.iter().any(|source| source.meets(case));
        assert!(filters || drivers, "{}", case.name());
    }
    let fine = |error: f64| {
        let mut outcome = Outcome::new("made", Case::Grazing);
        outcome.count(&"a point", true);
        outcome.judge(&"a point", &[0.5 + error], &[0.5], Some((&[0.5], 0.1)));
        outcome
    };
    assert!(fine(0.05).holds() && !fine(0.2).holds() && !fine(f64::NAN).holds());
    assert!(!Outcome::new("made", Case::Grazing).holds());
    let mut outside = fine(0.0);
    outside.count(&"another", false);
    assert!(!outside.holds());
}
