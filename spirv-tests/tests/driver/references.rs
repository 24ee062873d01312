//! Question 1: is the reference of images right? Planes and jumps, whose moments are known.

use prefilter::reference::moments::{Beyond, Image};

fn plane(size: usize, slopes: [f64; 2], beyond: Beyond) -> Image {
    let value = |at: usize| slopes[0] * (at % size) as f64 + slopes[1] * (at / size) as f64;
    Image { width: size, height: size, values: (0..size * size).map(value).collect(), beyond }
}

#[test]
fn places_beyond_the_edges_are_those_of_samplers() {
    let across = |beyond| {
        let image = Image { height: 1, ..plane(3, [1.0, 0.0], beyond) };
        [-4, -1, 0, 2, 3, 5, 6].map(|place| image.value(f64::from(place) + 0.5, 0.5))
    };
    assert_eq!(across(Beyond::Clamp), [0.0, 0.0, 0.0, 2.0, 2.0, 2.0, 2.0]);
    assert_eq!(across(Beyond::Repeat), [2.0, 2.0, 0.0, 2.0, 0.0, 2.0, 0.0]);
    assert_eq!(across(Beyond::Mirror), [2.0, 0.0, 0.0, 2.0, 2.0, 0.0, 0.0]);
}

#[test]
fn a_plane_has_the_moments_of_its_slopes() {
    let image = plane(40, [0.3, -0.2], Beyond::Clamp);
    let covariance = [2.0, 0.5, 1.0];
    let [mean, square] = image.mean([20.3, 19.1], covariance, 200, |value| [value, value * value]);
    let expected = 0.3 * 19.8 - 0.2 * 18.6;
    let variance = 0.3 * 0.3 * 2.0 - 2.0 * 0.3 * 0.2 * 0.5 + 0.2 * 0.2;
    assert!((mean - expected).abs() < 1e-10, "{mean} {expected}");
    // The Gaussian ends at 4.5 deviations: 2e-4 of the variance is beyond.
    let found = square - mean * mean;
    assert!((found / variance - 1.0).abs() < 5e-4, "{found} {variance}");
    // Over one texel: the variance of a uniform variable along both sides.
    let [mean, own] = image.over_texel(20, 19);
    assert!((mean - (0.3 * 20.0 - 0.2 * 19.0)).abs() < 1e-12);
    assert!((own - (0.09 + 0.04) / 12.0).abs() < 1e-12);
}

#[test]
fn a_jump_over_one_texel_has_the_moments_of_its_ramps() {
    // Between 0, 1, 0 the reconstruction falls from 1 to ½ on either side: uniform on [½, 1].
    let image = Image { width: 3, height: 1, values: vec![0.0, 1.0, 0.0], beyond: Beyond::Clamp };
    let [mean, variance] = image.over_texel(1, 0);
    assert!((mean - 0.75).abs() < 1e-14 && (variance - 0.25 / 12.0).abs() < 1e-14);
}

/// A read's kernel has the footprint's variance on average over positions.
#[test]
fn reads_of_a_plane_have_its_mean_and_its_mean_variance() {
    let image = plane(64, [0.3, -0.2], Beyond::Clamp);
    let texels: Vec<_> = (0..64 * 64).map(|at| image.over_texel(at % 64, at / 64)).collect();
    for variance in [0.01, 1.0, 2.0, 4.0, 7.0] {
        let (mut sum, mut center) = (0.0, 0.0);
        for step in 0..1024 {
            // 32 × 32 positions in one texel of level 3, of which all levels used are periods.
            let [x, y] = [step % 32, step / 32].map(|part| (24.0 + 8.0 * (f64::from(part) + 0.5) / 32.0) / 64.0);
            let [mean, deviation] = image.read(&texels, [x, y], [variance, 0.0, variance]);
            center += mean - image.value(64.0 * x, 64.0 * y);
            sum += deviation * deviation;
        }
        let expected = 1024.0 * variance * (0.09 + 0.04);
        assert!(center.abs() < 1e-9, "{variance}: {center}");
        // The midpoint rule in n places of a texel gives the tent's variance, w²/6, an excess of w²/12n²: of w²/4, and
        // with the eight places of level 1, 1/192.
        assert!((sum / expected - 1.0).abs() < 1.01 / 192.0, "{variance}: {sum} {expected}");
    }
}
