//! Question 3 for color by height and steepness in the light of a sky: is the model good? A mountainous ground near and
//! far, from overhead to grazing, against rays to all of it.

use prefilter::gpu::Device;
use spirv_tests::cliffs::judge::{judge, Extent, Judged, Panel, Row};
use spirv_tests::cliffs::method::Method;
use spirv_tests::cliffs::model::gaps;
use spirv_tests::cliffs::{table, Error};
use spirv_tests::imaging::region::Region;
use spirv_tests::imaging::tally::{sizes, Of};

const EXTENT: Extent = Extent { size: [112, 56], strata: 16, places: 1, modeled: 101 };

/// Whether the truth is known three times better than every figure.
fn truth_is_sharp(row: &Row) {
    for method in Method::ALL {
        let (figure, error) = (row.rms(method, None), sizes(&row.places, Of::Truth, None).rms.value);
        assert!(3.0 * error < figure, "{}, {}: {figure} against {error}", row.view.name, method.label());
    }
}

/// Straight down all is seen: light over all heights and slopes is that over what is seen, but for rounding.
fn all_is_seen_from_overhead(panel: &Panel) {
    let [alike, factored] = [Method::Alike, Method::Factored].map(|method| &panel.shown[method as usize]);
    let channels = alike.pixels.as_flattened().iter().zip(factored.pixels.as_flattened());
    let far = channels.map(|(one, other)| (one - other).abs()).fold(0.0, f32::max);
    assert!(far < 1e-4, "{far}");
}

/// Filters pay, and most where they make all of the light; what is seen pays where not all is.
fn filters_pay(row: &Row) {
    for region in [None, Some(Region::Far)] {
        let [naive, alike, factored, joint] = Method::ALL.map(|method| row.rms(method, region));
        assert!(2.0 * factored < naive && 2.0 * joint < naive, "{}: {naive} {factored} {joint}", row.view.name);
        let seen = if row.view.name == "overhead" { 1.01 } else { 0.95 };
        assert!(factored < seen * alike, "{}: {alike} {factored}", row.view.name);
    }
    let far = Some(Region::Far);
    let [naive, factored] = [Method::Naive, Method::Factored].map(|method| row.rms(method, far));
    assert!(3.0 * factored < naive, "{}: {naive} {factored}", row.view.name);
    let samples = row.samples(Method::Factored, far);
    assert!(samples.is_ok_and(|samples| samples > 4.0), "{}: {samples:?}", row.view.name);
}

/// Where color and light are correlated, the product of their means is three times as far from the filters' model as
/// the mean of the product.
fn light_is_averaged_with_color(judged: &Judged) {
    let gaps = gaps(judged.rows.iter().flat_map(|row| &row.taps), true);
    let [factored, joint] = Method::FILTERED.map(|method| gaps.methods[method as usize]);
    println!("{} correlated taps: {factored} apart, {joint} together", gaps.count);
    assert!(gaps.count > 20 && 3.0 * joint < factored, "{}: {factored} {joint}", gaps.count);
}

#[test]
fn mountains_near_and_far() -> Result<(), Error> {
    let judged: Judged = judge(&Device::new()?, EXTENT, &|| ())?;
    println!("{}\n{}", table::text(&judged), table::model_text(&judged));
    judged.rows.iter().for_each(truth_is_sharp);
    judged.rows.iter().for_each(filters_pay);
    light_is_averaged_with_color(&judged);
    let overhead = judged.panels.iter().filter(|panel| panel.view.name == "overhead");
    assert_eq!(overhead.map(all_is_seen_from_overhead).count(), 2);
    Ok(())
}
