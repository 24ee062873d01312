//! Question 1: is the reference right? No device.

use prefilter::reference::slope::{mean, mean_by_parts};
use prefilter::reference::slopes::Visible;
use prefilter::reference::texture;

use crate::{maps, view, Outcome, Random};

#[test]
fn two_methods_agree() -> Outcome {
    let mut random = Random::new(41);
    let mut worst = 0.0f64;
    for (map, _) in maps()? {
        let map = map.reference();
        for _ in 0..25 {
            let (visible, direction) = view(&mut random);
            let (one, other) = (mean(&map, &visible, direction), mean_by_parts(&map, &visible, direction));
            for channel in 0..4 {
                let apart = (one[channel] - other[channel]).abs();
                // Where no slope across the view adds to it, the cumulative function begins with a kink within a panel.
                assert!(apart < 3e-7, "{visible:?}, {direction:?}: {one:?} {other:?}");
                worst = worst.max(apart);
            }
        }
    }
    println!("largest difference {worst:.1e}");
    Ok(())
}

/// The definition by the two-dimensional quadrature, for a map whose kinks its panels hardly see.
#[test]
fn the_mean_is_that_over_all_visible_slopes() -> Outcome {
    let (map, _) = maps()?.remove(0);
    let map = map.reference();
    let mut random = Random::new(42);
    for _ in 0..20 {
        let (visible, direction) = view(&mut random);
        let component = |slope: [f64; 2]| direction[0] * slope[0] + direction[1] * slope[1];
        let plain = visible.average(|slope| map.value(component(slope)));
        let found = mean(&map, &visible, direction);
        for channel in 0..4 {
            assert!((plain[channel] - found[channel]).abs() < 1e-3, "{visible:?}: {plain:?} {found:?}");
        }
    }
    Ok(())
}

#[test]
fn along_the_normal_it_is_the_filter_of_values() -> Outcome {
    let visible = Visible { view: [0.0, 0.0, 1.0], covariance: [0.3, 0.1, 0.2], mean: [0.2, -0.1] };
    let variance: f64 = 0.36 * 0.3 + 0.96 * 0.1 + 0.64 * 0.2;
    for (map, _) in maps()? {
        let map = map.reference();
        let plain = texture::mean(&map, 0.6 * 0.2 - 0.8 * 0.1, variance.sqrt());
        for (found, plain) in mean(&map, &visible, [0.6, 0.8]).into_iter().zip(plain) {
            assert!((found - plain).abs() < 1e-12, "{found} {plain}");
        }
    }
    Ok(())
}
