//! Slopes of a transferred surface h = g(f), part by part of the values of f, without nodes.
//!
//! A normal f is independent of its slopes at the same place. Given f, slopes of h are normal with the mean g′ s̄ and
//! the covariance g′² Σ of those of f: all of them together are a mixture over the scales g′(f), by equations 23 to 26
//! of Heitz et al. 2014 before their mean is taken.
//!
//! What a view sees of a part is E[max(t, 0)] of its slopes times the share V(h) that is not hidden. Smith's argument,
//! that the chance to be hidden between two heights goes with the facets there that face away, gives −ln V(h) = ∫ λ(h′)
//! p(h′)/P(h′) dh′ over the heights above, P being the share of the surface below: P^Λ where λ is Λ everywhere. λ goes
//! with |g′| where steep facets face away, and is Λ (1 − c + c |g′| / E|g′|) here: how close c ought to be to 1 is for
//! brute force to tell. With c = 1 and areas 1 + λ the share seen below h is P(h) V(h), and all is seen of the plane.

use super::normal::cumulative;
use super::slopes::standard;

/// Values of f this many deviations from the mean have 1e-15 of all.
const FAR: f64 = 8.0;

/// Parts of a deviation, where nothing else is said.
const PARTS: usize = 64;

/// A part of the surface: values of f next to each other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Part {
    /// The value of f in its middle.
    pub value: f64,
    /// The share of the surface that it is.
    pub share: f64,
    /// The height h.
    pub height: f64,
    /// The scale g′.
    pub scale: f64,
}

/// The parts of a surface, by rising f.
#[derive(Clone, Debug, PartialEq)]
pub struct Transferred {
    /// The parts; their shares sum to 1.
    pub parts: Vec<Part>,
}

/// Slopes of f along the horizontal direction towards a viewer, and where that is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Along {
    /// The angle of the view from the normal of the mesh in radians, below π/2.
    pub angle: f64,
    /// The mean of the slopes of f along the view.
    pub mean: f64,
    /// Their deviation.
    pub deviation: f64,
}

/// A value of a standard normal variable, with the probability of one farther from 0 on its side.
type End = (f64, f64);

fn end(at: f64) -> End {
    (at, cumulative(-at.abs()))
}

/// Ends of parts in deviations of f, with their probabilities, for many surfaces.
#[derive(Clone, Debug)]
pub struct Ends(Vec<End>);

impl Ends {
    /// So many parts of each deviation.
    pub fn even(parts: usize) -> Self {
        Self::within(FAR as usize, parts)
    }

    /// The same up to so many deviations from the mean, beyond which nothing is.
    pub fn within(deviations: usize, parts: usize) -> Self {
        let far = deviations as f64;
        Self((0..=2 * deviations * parts).map(|index| end(index as f64 / parts as f64 - far)).collect())
    }
}

/// The probability between two values, a ≤ b.
fn between((a, below): End, (b, above): End) -> f64 {
    if a > 0.0 {
        below - above
    } else if b > 0.0 {
        (1.0 - above) - below
    } else {
        above - below
    }
}

impl Transferred {
    /// The surface over a normal f: the curve's height and slope at a value, and the values between which it is smooth.
    pub fn new(
        [mean, deviation]: [f64; 2],
        breaks: &[f64],
        height: impl Fn(f64) -> f64,
        slope: impl Fn(f64) -> f64,
    ) -> Self {
        Self::in_parts(PARTS, [mean, deviation], breaks, height, slope)
    }

    /// The same in fewer parts or more of each deviation.
    pub fn in_parts(
        parts: usize,
        [mean, deviation]: [f64; 2],
        breaks: &[f64],
        height: impl Fn(f64) -> f64,
        slope: impl Fn(f64) -> f64,
    ) -> Self {
        Self::between(&Ends::even(parts), [mean, deviation], breaks, |value| (height(value), slope(value)))
    }

    /// The same between ends that are known, by a curve's height and slope at a value.
    pub fn between(
        Ends(even): &Ends,
        [mean, deviation]: [f64; 2],
        breaks: &[f64],
        at: impl Fn(f64) -> (f64, f64),
    ) -> Self {
        let part = |value: f64, share: f64| {
            let (height, scale) = at(value);
            Part { value, share, height, scale }
        };
        if deviation <= 0.0 {
            return Self { parts: vec![part(mean, 1.0)] };
        }
        let (first, last) = (even[0], even[even.len() - 1]);
        let mut ends = even.clone();
        for at in breaks.iter().map(|at| (at - mean) / deviation).filter(|at| first.0 < *at && *at < last.0) {
            let next = ends.partition_point(|end| end.0 < at);
            if ends[next].0 != at {
                ends.insert(next, end(at));
            }
        }
        let all = between(first, last);
        let part = |pair: &[End]| {
            let middle = 0.5 * (pair[0].0 + pair[1].0);
            part(mean + deviation * middle, between(pair[0], pair[1]) / all)
        };
        let parts = ends.windows(2).map(part);
        Self { parts: parts.collect() }
    }

    /// The mean of a function of the parts.
    pub fn average(&self, function: impl Fn(&Part) -> f64) -> f64 {
        self.parts.iter().map(|part| part.share * function(part)).sum()
    }

    /// How much hiding each part does, 1 in the mean: with |g′| by the share `follows`, alike by the rest.
    fn hiding(&self, follows: f64) -> Vec<f64> {
        let steepness = self.average(|part| part.scale.abs());
        let steep = |part: &Part| if steepness > 0.0 { part.scale.abs() / steepness } else { 1.0 };
        self.parts.iter().map(|part| 1.0 - follows + follows * steep(part)).collect()
    }

    /// The numbers of the parts from the highest down, with the shares of the surface below the top of each and below
    /// its bottom.
    fn downwards(&self) -> Vec<(usize, f64, f64)> {
        let mut order: Vec<usize> = (0..self.parts.len()).collect();
        order.sort_by(|&a, &b| self.parts[a].height.total_cmp(&self.parts[b].height));
        let mut below = 0.0;
        let mut stacked = Vec::with_capacity(order.len());
        for index in order {
            let top = below + self.parts[index].share;
            stacked.push((index, top, below));
            below = top;
        }
        stacked.reverse();
        stacked
    }

    /// −ln V/Λ of each part: how fast it is hidden as Λ grows, when hiding goes with |g′| by the share `follows`.
    pub fn rates(&self, follows: f64) -> Vec<f64> {
        let hiding = self.hiding(follows);
        let (mut above, mut rates) = (0.0, vec![0.0; self.parts.len()]);
        for (index, top, bottom) in self.downwards() {
            // From the top to the middle of the part, and through it.
            rates[index] = above + hiding[index] * (2.0 * top / (top + bottom)).ln();
            above += if bottom > 0.0 { hiding[index] * (top / bottom).ln() } else { 0.0 };
        }
        rates
    }

    /// The share of each part in the heights that are seen, for the sum of Smith's Λ of view and light, where areas and
    /// hiding go with |g′|: differences of F(h) = P(h) V(h). They sum to 1.
    pub fn visible_heights(&self, lambda: f64) -> Vec<f64> {
        let hiding = self.hiding(1.0);
        let (mut above, mut shares) = (0.0, vec![0.0; self.parts.len()]);
        for (index, top, bottom) in self.downwards() {
            let part = if bottom > 0.0 { hiding[index] * (top / bottom).ln() } else { f64::INFINITY };
            let lost = if lambda > 0.0 && hiding[index] > 0.0 { lambda * part } else { 0.0 };
            shares[index] = (-lambda * above).exp() * (top - bottom * (-lost).exp());
            above += if bottom > 0.0 { part } else { 0.0 };
        }
        shares
    }

    /// E[max(t, 0)] of each part: the area of its facets in the picture for a unit of area of the mesh.
    pub fn areas(&self, along: Along) -> Vec<f64> {
        let area = |part: &Part| {
            let (rise, reach) = along.rise_and_reach(part.scale);
            // Far from the horizon all facets face one way, 1e-17 of them aside.
            if rise.abs() > 9.0 * reach {
                rise.max(0.0)
            } else {
                reach * standard::weight(rise / reach)
            }
        };
        self.parts.iter().map(area).collect()
    }

    /// Smith's Λ: the area that faces the view over that of the mean surface, less 1. Infinite below its horizon.
    pub fn lambda(&self, along: Along) -> f64 {
        let rise = self.average(|part| along.rise_and_reach(part.scale).0);
        let area: f64 = self.parts.iter().zip(self.areas(along)).map(|(part, area)| part.share * area).sum();
        if rise > 0.0 {
            area / rise - 1.0
        } else {
            f64::INFINITY
        }
    }

    /// The share of each part in what is seen, for the Λ of the view alone or with that of a light.
    pub fn shares(&self, along: Along, lambda: f64, follows: f64) -> Vec<f64> {
        let rates = self.rates(follows);
        let areas = self.areas(along);
        let seen = self.parts.iter().zip(rates).zip(areas).map(|((part, rate), area)| {
            let seen = part.share * area * (-lambda * rate).exp();
            if seen > 0.0 {
                seen
            } else {
                0.0
            }
        });
        let seen: Vec<f64> = seen.collect();
        let sum: f64 = seen.iter().sum();
        seen.into_iter().map(|share| share / sum).collect()
    }

    /// The probability that a slope along the view is below each of some rising edges, when `shares` of the parts are
    /// seen. Level parts have the slope 0, an edge at which they are below.
    pub fn below(&self, along: Along, shares: &[f64], edges: &[f64]) -> Vec<f64> {
        let mut sums = vec![0.0; edges.len()];
        for (part, share) in self.parts.iter().zip(shares).filter(|(_, share)| **share > 0.0) {
            let (rise, reach) = along.rise_and_reach(part.scale);
            let (mean, deviation) = (part.scale * along.mean, part.scale.abs() * along.deviation);
            if deviation <= 0.0 {
                sums.iter_mut().zip(edges).for_each(|(sum, edge)| *sum += if mean <= *edge { *share } else { 0.0 });
                continue;
            }
            // Towards the view, u is against slopes: it lies above where a slope lies below.
            let turned: Vec<f64> = edges.iter().rev().map(|edge| (mean - edge) / deviation).collect();
            let above = standard::cumulative((rise / reach.max(1e-300)).min(1e6), &turned);
            sums.iter_mut().zip(above.iter().rev()).for_each(|(sum, above)| *sum += share * (1.0 - above));
        }
        sums
    }
}

impl Along {
    /// The mean of t over slopes of a scale, and its deviation.
    pub fn rise_and_reach(&self, scale: f64) -> (f64, f64) {
        let (sin, cos) = libm::sincos(self.angle);
        (cos - sin * scale * self.mean, sin * scale.abs() * self.deviation)
    }
}

/// The share that is not hidden of heights h whose −ln P(h) has a gamma distribution of mean `rate` and variance
/// `rate` · `spread`, in bits: its derivative by Λ is the mean that is left, rate / (1 + Λ spread), integrated.
pub fn bits(lambda: f64, rate: f64, spread: f64) -> f64 {
    // Even in the logarithm of 1 + Λ spread.
    let end = (lambda * spread).ln_1p();
    let [area] = super::quadrature::integrate(0.0, end, 1.0, |at| {
        let grown = (at.exp_m1()) / spread;
        [rate / (1.0 + grown * spread) * at.exp() / spread]
    });
    area * std::f64::consts::LOG2_E
}
