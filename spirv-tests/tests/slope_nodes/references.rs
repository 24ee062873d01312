//! Question 1: is the reference right?

use prefilter::reference::heights::cumulative as visible_heights;
use prefilter::reference::normal::cumulative;
use prefilter::reference::slope_nodes::{bits, Along, Part, Transferred};
use prefilter::reference::slopes::standard;

const TILTED: Along = Along { angle: 1.2, mean: 0.0, deviation: 0.7 };

/// The heights of a surface that is not transferred are normal: visible are P^(1 + Λ) below a height and the slopes of
/// D_s, whatever hiding follows.
#[test]
fn the_identity_is_smiths_model() {
    let surface = Transferred::new([0.3, 0.2], &[], |value| value, |_| 1.0);
    let lambda = surface.lambda(TILTED);
    let (rise, reach) = TILTED.rise_and_reach(1.0);
    assert!((lambda - (reach * standard::weight(rise / reach) / rise - 1.0)).abs() < 1e-12, "{lambda}");
    for follows in [0.0, 0.3, 1.0] {
        let shares = surface.shares(TILTED, lambda, follows);
        let mut below = 0.0;
        for (part, share) in surface.parts.iter().zip(&shares) {
            below += 0.5 * share;
            let expected = visible_heights((part.value - 0.3) / 0.2, lambda);
            assert!((below - expected).abs() < 1e-4, "{follows}, {}: {below} {expected}", part.value);
            below += 0.5 * share;
        }
        let [edge, truth] = [-0.4, standard::cumulative(rise / reach, &[0.4 / 0.7])[0]];
        let [found] = surface.below(TILTED, &shares, &[edge])[..] else { panic!("one edge") };
        assert!((found - (1.0 - truth)).abs() < 1e-6, "{found} {truth}");
    }
    let seen = surface.visible_heights(lambda);
    for (share, expected) in seen.iter().zip(surface.shares(TILTED, lambda, 1.0)) {
        assert!((share - expected).abs() < 1e-6, "{share} {expected}");
    }
}

/// Heights that are seen are the density p (1 + λ) V, whose integral is F: their shares, summed part by part.
#[test]
fn visible_heights_are_areas_that_are_not_hidden() {
    let surface = Transferred::new([0.2, 0.6], &[0.0], |v| v.powi(3) - v, |v| 3.0 * v * v - 1.0);
    let steepness = surface.average(|part| part.scale.abs());
    let rates = surface.rates(1.0);
    for lambda in [0.0, 0.4, 5.0] {
        let seen = surface.visible_heights(lambda);
        let mut whole = 0.0;
        for ((part, rate), share) in surface.parts.iter().zip(&rates).zip(&seen) {
            let density = part.share * (1.0 + lambda * part.scale.abs() / steepness) * (-lambda * rate).exp();
            assert!(
                (share - density).abs() < 2e-3 * density.max(part.share) + 1e-13,
                "{lambda}, {part:?}: {share} {density}"
            );
            whole += share;
        }
        assert!((whole - 1.0).abs() < 1e-9, "{lambda}: {whole}");
    }
}

/// Where facets that face away go with |g′| as hiding does, all that the plane shows is seen: ∫ p (1 + λ) V = 1.
#[test]
fn area_is_conserved_where_hiding_follows_steepness() {
    let over = [0.4, 0.8];
    let wave = Transferred::new(over, &[], f64::sin, f64::cos);
    let square = Transferred::new(over, &[0.0], |v| v * v, |v| 2.0 * v);
    for surface in [wave, square, Transferred::new(over, &[0.0], f64::abs, f64::signum)] {
        let steepness = surface.average(|part| part.scale.abs());
        let rates = surface.rates(1.0);
        for lambda in [0.1, 1.0, 10.0] {
            let seen = |(part, rate): (&Part, &f64)| {
                part.share * (1.0 + lambda * part.scale.abs() / steepness) * (-lambda * rate).exp()
            };
            let whole: f64 = surface.parts.iter().zip(&rates).map(seen).sum();
            assert!((whole - 1.0).abs() < 1e-3, "{lambda}: {whole}");
        }
    }
}

/// Two levels joined by a cliff: the lower one is hidden by what is above it, the upper one never.
#[test]
fn rates_are_those_of_the_heights_above() {
    let height = |value: f64| value.clamp(-0.01, 0.01);
    let surface = Transferred::new([0.0, 1.0], &[-0.01, 0.01], height, |value| f64::from(u8::from(value.abs() < 0.01)));
    let rates = surface.rates(1.0);
    let (low, high) = (rates[10], rates[rates.len() - 10]);
    // The cliff is all of the steepness, P = ½ below it: 1/½ in sum.
    assert!((low - 2.0).abs() < 0.02 && high.abs() < 1e-12, "{low} {high}");
    // Without, rates are −ln P whatever the curve.
    for (part, rate) in surface.parts.iter().zip(surface.rates(0.0)).skip(300) {
        assert!((rate + cumulative(part.value).ln()).abs() < 2e-3 * (1.0 + rate), "{}: {rate}", part.value);
    }
}

/// The mean of e^(−ΛX) over a gamma distribution of mean 2 and variance 3, by its density x^(1/3) e^(−x/1.5).
#[test]
fn bits_are_those_of_a_gamma_distribution() {
    use prefilter::reference::quadrature::integrate;
    for lambda in [0.2, 1.0, 7.0] {
        let density = |x: f64| x.cbrt() * (-x / 1.5).exp();
        // In cubes: x = y³.
        let [whole, seen] = integrate(0.0, 4.0, 0.05, |y| {
            let x = y * y * y;
            let each = density(x) * 3.0 * y * y;
            [each, each * (-lambda * x).exp()]
        });
        let found = bits(lambda, 2.0, 1.5);
        assert!((found + (seen / whole).log2()).abs() < 1e-9, "{lambda}: {found} {}", -(seen / whole).log2());
    }
}
