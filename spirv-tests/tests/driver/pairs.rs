//! Question 3 for two normal distributions of an image's four moments, beside the one of its mean and deviation.

use prefilter::gpu::{Address, Device, Kernel};
use prefilter::reference::moments::Beyond;
use prefilter::table::Format;
use prefilter::{Distribution, Driver, Edge, FourMomentMipmap, Kernel as Form, Moments, Scene, Tier};
use spirv_tests::maps;

use crate::colors::{rms, Case, ENTRY, SEEDS, TAPS};
use crate::footprints::footprints;
use crate::{documented, photograph};

const DOCUMENTATION: &str = include_str!("../../../src/driver/moments.rs");

fn case(device: &Device, file: &str, map: &str, format: Format) -> Case {
    let (image, stored) = photograph(file, Beyond::Repeat);
    let pyramid = FourMomentMipmap::new(image.width as u32, image.height as u32, &stored, Edge::Repeat).unwrap();
    let texture = device.upload(&pyramid.table("image", format).unwrap(), Address::Repeat).unwrap();
    let map = maps::named(map).unwrap();
    let kernel = |taps| {
        let driver = Driver::Moments(Moments { taps, ..Moments::default() });
        let scene = Scene::new("rock").texture(map.clone()).tier(Tier::ClosedForm(Form::Exact)).driver(driver);
        let module = scene.distribution(Distribution::Pair).module().unwrap();
        Kernel::new(device, module.link(ENTRY).unwrap().wgsl(), "main").unwrap()
    };
    Case { image, textures: vec![texture], kernels: TAPS.map(kernel).into(), map: map.reference() }
}

#[test]
fn two_distributions_are_nearer_than_one() {
    let device = Device::new().unwrap();
    println!("RMS × 1e-3 over positions, directions and minor deviations 0.15, 0.6, 2.5 texels, 1 to 8 taps");
    let cases = [
        ("gravel.png", "steps6", "gravel, six hard steps"),
        ("gravel.png", "terrain", "gravel, terrain"),
        ("brick.png", "steps6", "brick, six hard steps"),
        ("brick.png", "terrain", "brick, terrain"),
        ("jacksboro_dem.png", "terrain", "elevations, terrain"),
    ];
    for (file, map, label) in cases {
        let one = Case::new(&device, file, map);
        let two = [Format::Rgba32Float, Format::Rgba16Float].map(|format| case(&device, file, map, format));
        for aspect in [1.0, 4.0, 16.0] {
            let measured = |case: &Case| {
                let errors =
                    |seed| [0.15, 0.6, 2.5].map(|minor| case.errors(&footprints(&case.image, seed, minor, aspect)));
                rms(SEEDS.map(errors))
            };
            let (normal, [pair, halves]) = (measured(&one), two.each_ref().map(measured));
            let label = format!("{label}, {aspect}:1");
            println!("{label:<30} {:6.1?} with one {:6.1?}, truth {:.1}", &pair[1..5], &normal[1..5], pair[5]);
            for taps in 1..5 {
                assert!(pair[taps] < normal[taps], "{label}");
                // Sixteen bits of standardized moments lose nothing.
                assert!((halves[taps] - pair[taps]).abs() < 0.2, "{label}: {} {}", halves[taps], pair[taps]);
            }
            assert!(pair[5] < pair[4] / 2.0, "the measurement is not good enough");
            let numbers = [&pair[1..5], &normal[1..5]].concat();
            let said = documented(DOCUMENTATION, &label);
            assert_eq!(said.len(), numbers.len(), "{label}");
            for (number, said) in numbers.iter().zip(said) {
                assert!((number - said).abs() < 1.0, "{label}: {number} where {said} is documented");
            }
        }
    }
}

/// The README's figures are those of the tables that the tests of both drivers measure.
#[test]
fn the_readme_quotes_the_tables() {
    let readme = include_str!("../../../README.md");
    let pair = documented(DOCUMENTATION, "brick, six hard steps, 4:1");
    let shares = documented(include_str!("../../../src/driver/indicators.rs"), "brick, 4:1");
    let said = format!(
        "err by an RMS of {:.3} with one normal distribution, {:.3} with two and {:.3} by shares",
        pair[4] / 1e3,
        pair[0] / 1e3,
        shares[0] / 1e3
    );
    assert!(readme.contains(&said), "the README does not say: {said}");
}
