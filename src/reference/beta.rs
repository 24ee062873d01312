//! Beta distributions between two ends by their mean and deviation, and the mean of a map over them by two methods.

use super::quadrature::integrate;
use super::texture::PiecewiseLinear;

/// Beyond this many units of the logit values are within 2e-11 of an end.
const LAST: f64 = 25.0;

/// Where x times the density is below e to this, what lies beyond x is less than rounding.
const RISE: f64 = -60.0;

/// The Beta distribution over a range, with what is left of it at the ends of its parameters.
///
/// Means count as the nearer end where they are outside, deviations as the largest that values in the range have.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Beta {
    low: f64,
    span: f64,
    /// The mean, where the low end is 0 and the high one 1.
    share: f64,
    kind: Kind,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Kind {
    /// All at the mean.
    Point,
    /// All at the two ends.
    Ends,
    /// The exponents of x and 1 − x, each with one more.
    Shapes(f64, f64),
}

impl Beta {
    /// The distribution over [low, high] with a mean and a deviation.
    pub fn new([low, high]: [f64; 2], mean: f64, deviation: f64) -> Self {
        let span = high - low;
        let share = ((mean - low) / span).clamp(0.0, 1.0);
        let variance = (deviation / span).powi(2);
        let both = share * (1.0 - share) / variance - 1.0;
        let kind = if deviation <= 0.0 {
            Kind::Point
        } else if share * both < 1e-12 || (1.0 - share) * both < 1e-12 {
            Kind::Ends
        } else {
            Kind::Shapes(share * both, (1.0 - share) * both)
        };
        Self { low, span, share, kind }
    }

    /// The mean of a map, over pieces of the logit of the value, by a quadrature of the density times the map.
    ///
    /// The logit's density is analytic and falls exponentially at both ends, whatever the shapes. Error below 1e-10 of
    /// the largest color.
    pub fn mean(&self, map: &PiecewiseLinear) -> [f64; 4] {
        let [low, high] = [self.low, self.low + self.span];
        let at_ends = [map.value(low), below(map, high)];
        let (a, b) = match self.kind {
            Kind::Point => return map.value(low + self.span * self.share),
            Kind::Ends => return std::array::from_fn(|c| at_ends[0][c] + self.share * (at_ends[1][c] - at_ends[0][c])),
            Kind::Shapes(a, b) => (a, b),
        };
        let (center, both) = (libm::log(self.share) - libm::log1p(-self.share), a + b);
        // Over its value at the mean, and how wide it is.
        let density = |t: f64| libm::exp(a * (t - center) - both * softened(t - center, self.share));
        let width = (1.0 / a + 1.0 / b).sqrt();
        let (from, to) = ((center - 9.0 * width - 40.0 / a).max(-LAST), (center + 9.0 * width + 40.0 / b).min(LAST));
        let value = |t: f64| low + self.span / (1.0 + libm::exp(-t));
        let mut sum = [0.0; 5];
        let mut add = |weight: f64, color: [f64; 4]| {
            sum.iter_mut().zip(color.into_iter().chain([1.0])).for_each(|(sum, part)| *sum += weight * part);
        };
        add(density(from) / a, at_ends[0]);
        add(density(to) / b, at_ends[1]);
        let inside = map.knots.iter().map(|knot| (knot.0 - low) / self.span).filter(|x| *x > 0.0 && *x < 1.0);
        let places = inside.map(|x| libm::log(x) - libm::log1p(-x)).filter(|t| *t > from && *t < to);
        let edges: Vec<f64> = [from].into_iter().chain(places).chain([to]).collect();
        for edge in edges.windows(2) {
            let piece: [f64; 5] = integrate(edge[0], edge[1], 2.0 * width.min(1.0), |t| {
                let (weight, color) = (density(t), map.value(value(t)));
                std::array::from_fn(|channel| if channel < 4 { weight * color[channel] } else { weight })
            });
            sum.iter_mut().zip(piece).for_each(|(sum, piece)| *sum += piece);
        }
        std::array::from_fn(|channel| sum[channel] / sum[4])
    }

    /// The same mean by parts: the map's last value minus the integral of the cumulative function over the changes.
    pub fn mean_by_parts(&self, map: &PiecewiseLinear) -> [f64; 4] {
        if self.kind == Kind::Point {
            return map.value(self.low + self.span * self.share);
        }
        let mut sum = map.knots.last().map_or([0.0; 4], |knot| knot.2);
        let mut subtract = |from: [f64; 4], to: [f64; 4], part: f64| {
            (0..4).for_each(|channel| sum[channel] -= (to[channel] - from[channel]) * part);
        };
        let integrals: Vec<[f64; 2]> = map.knots.iter().map(|knot| self.integrals(knot.0)).collect();
        for (number, knot) in map.knots.iter().enumerate() {
            let [share, area] = integrals[number];
            if knot.1 != knot.2 {
                subtract(knot.1, knot.2, share);
            }
            let Some(next) = map.knots.get(number + 1).filter(|next| next.0 > knot.0) else { continue };
            subtract(knot.2, next.1, (integrals[number + 1][1] - area) / (next.0 - knot.0));
        }
        sum
    }

    /// The probability of a value below `at`.
    pub fn cumulative(&self, at: f64) -> f64 {
        self.integrals(at)[0]
    }

    /// The probability of a value below `at`, and the integral of that from the low end.
    fn integrals(&self, at: f64) -> [f64; 2] {
        let x = (at - self.low) / self.span;
        if x <= 0.0 {
            return [0.0, 0.0];
        }
        if x >= 1.0 {
            return [1.0, self.span * (x - self.share)];
        }
        match self.kind {
            Kind::Point => [f64::from(x > self.share), self.span * (x - self.share).max(0.0)],
            Kind::Ends => [1.0 - self.share, self.span * x * (1.0 - self.share)],
            Kind::Shapes(a, b) => {
                let [share, rise] = incomplete(a, b, x);
                // ∫ F = x F − E[X; X < x], of which the last is the mean times the share for a + 1.
                [share, self.span * ((x - self.share) * share + self.share * rise / a)]
            }
        }
    }
}

/// The value of a map just below a position.
fn below(map: &PiecewiseLinear, at: f64) -> [f64; 4] {
    let on = map.knots.iter().find(|knot| knot.0 == at);
    on.map_or_else(|| map.value(at), |knot| knot.1)
}

/// ln(1 + share (eˢ − 1)): the logarithm of 1 + eᵗ over its value at the mean, s above the mean's logit.
fn softened(s: f64, share: f64) -> f64 {
    if s > 0.0 {
        s + libm::log1p((1.0 - share) * libm::expm1(-s))
    } else {
        libm::log1p(share * libm::expm1(s))
    }
}

/// The regularized incomplete beta function I(x; a, b), and xᵃ (1 − x)ᵇ/B(a, b).
///
/// Source: Press et al. 1992, "Numerical Recipes in C", section 6.4, the continued fraction by Lentz's method.
fn incomplete(a: f64, b: f64, x: f64) -> [f64; 2] {
    let both = a + b;
    let mean = a / both;
    let apart = a * libm::log1p((x - mean) / mean) + b * libm::log1p((mean - x) / (1.0 - mean));
    let scale = libm::log(a / both * b) - libm::log(2.0 * std::f64::consts::PI);
    let logarithm = apart + 0.5 * scale + correction(both) - correction(a) - correction(b);
    let upper = x >= mean;
    if logarithm < RISE {
        return [f64::from(upper), 0.0];
    }
    let rise = libm::exp(logarithm);
    if upper {
        [1.0 - rise * fraction(b, a, 1.0 - x) / b, rise]
    } else {
        [rise * fraction(a, b, x) / a, rise]
    }
}

/// The continued fraction of the incomplete beta function, for x up to about the mean.
fn fraction(a: f64, b: f64, x: f64) -> f64 {
    let floor = |value: f64| if value.abs() < 1e-300 { 1e-300 } else { value };
    let mut c = 1.0;
    let mut d = 1.0 / floor(1.0 - (a + b) * x / (a + 1.0));
    let mut product = d;
    for index in 1..10_000_000 {
        let m = f64::from(index);
        let even = m * (b - m) * x / ((a + 2.0 * m - 1.0) * (a + 2.0 * m));
        let odd = -(a + m) * (a + b + m) * x / ((a + 2.0 * m) * (a + 2.0 * m + 1.0));
        let mut factor = 1.0;
        for term in [even, odd] {
            d = 1.0 / floor(1.0 + term * d);
            c = floor(1.0 + term / c);
            factor = c * d;
            product *= factor;
        }
        if (factor - 1.0).abs() < 1e-15 {
            break;
        }
    }
    product
}

/// What Stirling's formula (z − ½) ln z − z + ½ ln 2π lacks of ln Γ(z).
///
/// Source: Abramowitz and Stegun 1964, equation 6.1.40.
fn correction(z: f64) -> f64 {
    if z > 12.0 {
        let square = z * z;
        return (1.0 / 12.0 - (1.0 / 360.0 - (1.0 / 1260.0 - 1.0 / (1680.0 * square)) / square) / square) / z;
    }
    libm::lgamma(z) - ((z - 0.5) * libm::log(z) - z + 0.5 * libm::log(2.0 * std::f64::consts::PI))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn map() -> PiecewiseLinear {
        let (black, white) = ([0.0, 0.3, 1.0, 1.0], [1.0, 0.4, 0.0, 1.0]);
        let knots = vec![(0.0, white, black), (0.3, white, black), (0.300_02, black, white), (1.0, white, black)];
        PiecewiseLinear { knots }
    }

    /// Abramowitz and Stegun 1964, sections 26.5.5 to 26.5.7 and by hand: polynomials, and the arcsine law.
    #[test]
    fn the_cumulative_function_is_that_of_known_ones() {
        let arcsine = |x: f64| libm::asin(x.sqrt()) * std::f64::consts::FRAC_2_PI;
        let two_three = |x: f64| x * x * (6.0 - 8.0 * x + 3.0 * x * x);
        for x in [0.03, 0.2, 0.5, 0.71, 0.97] {
            let uniform = Beta::new([0.0, 1.0], 0.5, (1.0f64 / 12.0).sqrt());
            assert!((uniform.cumulative(x) - x).abs() < 1e-13, "{}", uniform.cumulative(x));
            let ends = Beta::new([2.0, 4.0], 3.0, 0.5f64.sqrt());
            assert!((ends.cumulative(2.0 + 2.0 * x) - arcsine(x)).abs() < 1e-12);
            let skewed = Beta::new([0.0, 1.0], 0.4, 0.2);
            assert!((skewed.cumulative(x) - two_three(x)).abs() < 1e-13);
        }
    }

    #[test]
    fn both_means_agree_for_all_shapes() {
        let range = [-0.1, 1.1];
        for (mean, spread) in [(0.31, 1e-6), (0.3, 0.01), (0.9, 0.2), (0.45, 0.55), (0.02, 0.3), (1.09, 0.05)] {
            for part in [1e-3, 0.2, 0.9, 0.9999, 1.2] {
                let most = f64::sqrt((mean - range[0]) * (range[1] - mean));
                for deviation in [spread, part * most] {
                    let beta = Beta::new(range, mean, deviation);
                    let (one, other) = (beta.mean(&map()), beta.mean_by_parts(&map()));
                    for channel in 0..4 {
                        let apart = (one[channel] - other[channel]).abs();
                        assert!(apart < 1e-9, "{mean}, {deviation}: {one:?} {other:?}");
                    }
                }
            }
        }
    }

    /// The mean and the variance of the values themselves.
    #[test]
    fn means_and_deviations_are_those_asked_for() {
        let (low, high) = ([-0.5, 0.0, 0.0, 0.0], [2.0, 0.0, 0.0, 0.0]);
        let values = PiecewiseLinear { knots: vec![(-0.5, low, low), (2.0, high, high)] };
        for (mean, deviation) in [(0.1, 0.3), (1.7, 0.01), (0.5, 1.2), (1.9, 0.4), (0.0, 1e-6)] {
            let beta = Beta::new([-0.5, 2.0], mean, deviation);
            assert!((beta.mean(&values)[0] - mean).abs() < 1e-10);
            // E[X²] is 2 ∫ x (1 − F) about the low end.
            let most = integrate(-0.5, 2.0, 2.5 / 512.0, |x| [2.0 * (x + 0.5) * (1.0 - beta.cumulative(x))]);
            let variance = most[0] - (mean + 0.5).powi(2);
            let least = deviation.min(((mean + 0.5) * (2.0 - mean)).sqrt());
            assert!(deviation < 1e-3 || (variance - least * least).abs() < 1e-4, "{mean} {deviation}: {variance}");
        }
    }

    #[test]
    fn limits_are_a_point_and_the_two_ends() {
        let range = [0.0, 1.0];
        assert_eq!(Beta::new(range, 0.2, 0.0).mean(&map()), map().value(0.2));
        assert_eq!(Beta::new(range, -3.0, 0.1).mean(&map()), map().value(0.0));
        // Just below the jump at the high end.
        let (low, high) = (map().value(0.0), map().knots[3].1);
        let half = std::array::from_fn(|channel| 0.5 * (low[channel] + high[channel]));
        assert_eq!(Beta::new(range, 0.5, 3.0).mean(&map()), half);
        assert_eq!(Beta::new(range, 0.5, 3.0).mean_by_parts(&map()), half);
        let near = Beta::new(range, 0.5, 0.499_999_999).mean(&map());
        assert!((0..4).all(|channel| (near[channel] - half[channel]).abs() < 1e-6), "{near:?} {half:?}");
    }
}
