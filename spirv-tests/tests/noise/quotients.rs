//! Do lattices wrap on devices that divide by a reciprocal?
//!
//! WGSL lets a quotient be 2.5 units in the last place off, and GPUs use that: on an NVIDIA H100 600/300 is below 2.
//! The pinned driver divides exactly, so that here quotients are made as wrong as they may be.

use super::Outcome;
use prefilter::gpu::Device;
use prefilter::reference::lattice::wrapped;
use spirv_tests::kernel::Function;

/// 1 ± 2.5 units in the last place of a quotient: of one next to 1, where they are largest.
const QUOTIENTS: [&str; 3] = ["0.9999997", "1.0", "1.0000003"];

/// The longest period that the contracts promise.
const LONGEST: i64 = 300;

/// Places that far away still tell a point from the next by a whole number and half of one.
const FAR: i64 = 1_200_000;

/// A function of the shelf by another name, whose quotients are all off by a factor.
fn off(name: &str, factor: &str) -> Result<Function, String> {
    let found = prefilter_wgsl::mentioned(name).into_iter().find(|(_, declaration)| declaration.name == name);
    let (_, declaration) = found.ok_or("no such function")?;
    let quotient = format!(" * {factor} / ");
    let text = declaration.text.replace(name, "off").replace(" / ", &quotient);
    assert_eq!(text.matches(&quotient).count(), 1, "{text}");
    Function::in_text(&text, "off")
}

/// Places with periods: all that the contracts promise, and next to the ends of tiles as long as `Noise` takes them.
fn places() -> Vec<(i64, i64)> {
    let promised = (1..=LONGEST).flat_map(|period| (-1000..=1000).map(move |place| (place, period)));
    let longer = [1_000, 4_095, 65_535, 1_000_003, 1 << 20].into_iter().flat_map(|period| {
        let ends = (-(FAR / period)..=FAR / period).map(move |tile| tile * period);
        ends.flat_map(move |end| (-1..=1).map(move |beside| (end + beside, period)))
    });
    promised.chain(longer).collect()
}

#[test]
fn points_wrap_by_every_quotient_that_wgsl_permits() -> Outcome {
    let device = Device::new()?;
    let places = places();
    for factor in QUOTIENTS {
        for (name, axes) in [("lattice_corners", 2), ("lattice_solid_wrapped", 3)] {
            let point = |(place, period): &(i64, i64)| [vec![*place as f64; axes], vec![*period as f64; axes]].concat();
            let points: Vec<Vec<f64>> = places.iter().map(point).collect();
            let found = off(name, factor)?.results(&device, &[], &points)?;
            assert_eq!(found.len(), places.len());
            for ((place, period), found) in places.iter().zip(found) {
                let near = wrapped([*place], [*period])[0] as f64;
                let far = wrapped([*place + 1], [*period])[0] as f64;
                // In the plane behind the point there is the next one.
                let expected = if axes == 2 { vec![near, near, far, far] } else { vec![near; 3] };
                assert_eq!(found, expected, "{name} of {place} in {period}, quotients times {factor}");
            }
        }
    }
    Ok(())
}
