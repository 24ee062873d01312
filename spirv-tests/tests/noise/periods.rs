//! Does a period repeat the noise, and without a seam?

use prefilter::gpu::Device;
use prefilter::reference::{perlin, value};
use spirv_tests::random::Random;

use crate::{at, Outcome};

#[test]
fn periods_repeat_without_a_seam() -> Outcome {
    let device = Device::new()?;
    let mut random = Random::new(9);
    // Binary fractions of 2^-16 move by whole numbers without rounding.
    let places: Vec<[f64; 2]> =
        (0..1000).map(|_| [0, 1].map(|_| (7.0 * 65536.0 * random.unit()).round() / 65536.0)).collect();
    for (name, reference) in [("perlin_noise", perlin::noise as fn(_, _, _) -> f64), ("value_noise", value::noise)] {
        let moved = |apart: [f64; 2], period: [f64; 2]| {
            let place = |place: &[f64; 2]| vec![place[0] + apart[0], place[1] + apart[1], period[0], period[1], 7.0];
            at(&device, name, &places.iter().map(place).collect::<Vec<_>>())
        };
        let home = moved([0.0; 2], [3.0, 5.0])?;
        assert!(home == moved([-3.0, 10.0], [3.0, 5.0])?, "a period does not repeat {name}");
        assert!(home != moved([-3.0, 10.0], [0.0; 2])?, "{name} repeats without a period");
        assert!(home != moved([-3.0, 9.0], [3.0, 5.0])?, "{name} repeats with less than a period");
        for edge in [0.0, 3.0, -3.0] {
            let sides = [edge - 1e-9, edge + 1e-9].map(|x| reference([x, 0.37], [3, 5], 7));
            assert!((sides[0] - sides[1]).abs() < 1e-8, "{name} has a seam at {edge}: {sides:?}");
        }
    }
    Ok(())
}
