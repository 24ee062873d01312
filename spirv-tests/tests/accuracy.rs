//! Does what a budget chooses keep it, is it cheaper than the finest tier, and how wide are the bounds?

use prefilter::gpu::Device;
use spirv_tests::report::accuracy::filter::Filter;
use spirv_tests::report::accuracy::tally::Tally;
use spirv_tests::report::accuracy::trial::trial;
use spirv_tests::report::accuracy::trials;
use spirv_tests::report::cache::Cache;

type Outcome = Result<(), Box<dyn std::error::Error + Send + Sync>>;

/// Scenes of every filter, with hard edges, at the corners of their ranges; the report has fifty times as many.
#[test]
fn what_a_budget_chooses_keeps_it() -> Outcome {
    let trials = trials((&Device::new()?, &Cache::none()), 0, (200, 0.5), &|_| {})?;
    for filter in Filter::ALL {
        let own: Vec<_> = trials.iter().filter(|trial| trial.filter == filter).collect();
        println!("{}: {:?}", filter.name(), Tally::new(&own));
        assert!(!own.is_empty());
    }
    for trial in &trials {
        assert!(trial.bound <= trial.budget * 1.000_001, "{trial:?}");
        // Written so that NaN fails.
        assert!(trial.measured <= trial.bound, "{trial:?}");
        assert!(trial.measured > 0.0, "{trial:?}");
    }
    let whole = Tally::new(&trials.iter().collect::<Vec<_>>());
    println!("all: {whole:?}");
    assert!(whole.count == 200 && whole.exceeded == 0 && whole.median <= 10.0, "{whole:?}");
    // Of those for which anything that filters is cheaper and keeps 0.3.
    let (cheaper, counted) = whole.cheaper.ok_or("nothing is cheaper than anything")?;
    assert!(counted > 100 && 10 * cheaper >= 9 * counted, "{cheaper} of {counted} are cheaper than the finest tier");
    Ok(())
}

/// Scene 2310 of 10 000 was the one whose error, 0.162, exceeded the bound, 0.150: of a table with an edge inside of a
/// cell.
#[test]
fn an_edge_inside_of_a_cell_keeps_its_bound() -> Outcome {
    let trial = trial(&Device::new()?, &Cache::none(), 2310, 0.5)?;
    assert!(trial.measured <= trial.bound, "{trial:?}");
    Ok(())
}
