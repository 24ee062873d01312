//! The points at which a function is judged: a low-discrepancy fill of its domain, corners, edges, zeros, and points
//! outside, where only a finite result is asked for.

use std::f64::consts::{PI, TAU};

use crate::contract::{Domain, Range};
use crate::signature::Scalar;

/// Far outside every domain, yet with a square that a 32-bit float holds.
const FAR: f64 = 1e18;

/// Companions of a special coordinate, a point of the fill each.
const COMPANIONS: usize = 64;

/// Lists of the numbers that a function takes, as its parameters hold them after rounding.
#[derive(Clone, Debug, Default)]
pub struct Points {
    /// Where the contract's promise holds.
    pub inside: Vec<Vec<f64>>,
    /// Where a finite result is asked for.
    pub outside: Vec<Vec<f64>>,
}

/// The points of a domain: `count` of the fill and the special ones.
pub fn points(ranges: &[Range], count: usize) -> Points {
    let cube: usize = ranges.iter().map(coordinates).sum();
    let mut fill = Sequence::new(cube);
    let mut inside: Vec<Vec<f64>> = (0..count).map(|_| at(ranges, &fill.advance())).collect();
    // Beyond 12 coordinates some share their side, which keeps the corners to 4096.
    for corner in 0..1usize << cube.min(12) {
        let corner: Vec<f64> = (0..cube).map(|side| f64::from(u8::from(corner >> (side % 12) & 1 == 1))).collect();
        inside.push(at(ranges, &corner));
    }
    let mut companions = || -> Vec<Vec<f64>> { (0..COMPANIONS).map(|_| at(ranges, &fill.advance())).collect() };
    let mut outside = Vec::new();
    for (number, (range, scalar)) in components(ranges).enumerate() {
        let with = |values: &[f64], companions: Vec<Vec<f64>>, to: &mut Vec<Vec<f64>>| {
            for companion in companions {
                to.extend(values.iter().map(|&value| {
                    let mut point = companion.clone();
                    point[number] = value;
                    point
                }));
            }
        };
        with(&special(range, scalar), companions(), &mut inside);
        with(&beyond(range, scalar), companions(), &mut outside);
    }
    outside.extend(together(ranges));
    Points { inside, outside }
}

/// Every number of a function with its range.
fn components(ranges: &[Range]) -> impl Iterator<Item = (&Range, Scalar)> {
    ranges.iter().flat_map(|range| range.leaves.iter().map(move |leaf| (range, leaf.scalar)))
}

/// Free coordinates of a range.
fn coordinates(range: &Range) -> usize {
    match range.domain {
        Domain::Unit | Domain::UnitUpper => range.leaves.len() - 1,
        _ => range.leaves.len(),
    }
}

/// The point of the domain for a point of the unit cube.
fn at(ranges: &[Range], cube: &[f64]) -> Vec<f64> {
    let mut rest = cube;
    let mut point = Vec::new();
    for range in ranges {
        let (own, others) = rest.split_at(coordinates(range));
        rest = others;
        let values = match range.domain {
            Domain::Linear(low, high) => own.iter().map(|u| low + u * (high - low)).collect(),
            Domain::Logarithmic(low, high) => own.iter().map(|u| low * (high / low).powf(*u)).collect(),
            Domain::Integer(low, high) => {
                own.iter().map(|u| (low + u * (high - low + 1.0)).floor().min(high)).collect()
            }
            Domain::Unit => direction(own, -1.0),
            Domain::UnitUpper => direction(own, 0.0),
            Domain::Covariance(low, high, most) => covariance(own, low, high, most),
        };
        // The ends of a range may round to the outside: the contract's bounds are decimal numbers.
        point.extend(values.iter().zip(&range.leaves).map(|(&value, leaf)| rounded(value, leaf.scalar)));
    }
    point
}

fn direction(cube: &[f64], lowest: f64) -> Vec<f64> {
    match *cube {
        [angle] => {
            let turn = if lowest < 0.0 { TAU } else { PI };
            vec![(turn * angle).cos(), (turn * angle).sin()]
        }
        [height, azimuth] => {
            let z = lowest + height * (1.0 - lowest);
            let radius = (1.0 - z * z).max(0.0).sqrt();
            vec![radius * (TAU * azimuth).cos(), radius * (TAU * azimuth).sin(), z]
        }
        _ => Vec::new(),
    }
}

fn covariance(cube: &[f64], low: f64, high: f64, most: f64) -> Vec<f64> {
    let &[x, y, correlation] = cube else { return Vec::new() };
    let [x, y] = [x, y].map(|u| low * (high / low).powf(u));
    vec![x * x, most * (2.0 * correlation - 1.0) * x * y, y * y]
}

/// The number as its parameter holds it.
pub fn rounded(value: f64, scalar: Scalar) -> f64 {
    match scalar {
        Scalar::Float => f64::from(value as f32),
        Scalar::Signed => f64::from(value as i32),
        Scalar::Unsigned => f64::from(value as u32),
        Scalar::Bool => f64::from(u8::from(value != 0.0)),
    }
}

/// A value and its two neighbors among the 32-bit floats.
pub fn neighbors(value: f64) -> [f64; 3] {
    let value = value as f32;
    [value.next_down(), value, value.next_up()].map(f64::from)
}

/// Edges, their neighbors, zeros and the smallest numbers of a component, where they lie in its range.
fn special(range: &Range, scalar: Scalar) -> Vec<f64> {
    match (range.domain, scalar) {
        (Domain::Linear(low, high), Scalar::Float) => {
            let tiny = f64::from(f32::from_bits(1));
            let zeros = [0.0, -0.0, tiny, -tiny, f64::from(f32::MIN_POSITIVE), -f64::from(f32::MIN_POSITIVE)];
            let zeros = zeros.into_iter().filter(|&zero| low <= zero && zero <= high);
            [low, high].into_iter().flat_map(neighbors).chain(zeros).collect()
        }
        (Domain::Logarithmic(low, high), Scalar::Float) => [low, high].into_iter().flat_map(neighbors).collect(),
        (Domain::Linear(low, high) | Domain::Logarithmic(low, high) | Domain::Integer(low, high), _) => {
            [low, low + 1.0, high - 1.0, high].into_iter().filter(|&at| low <= at && at <= high).collect()
        }
        (Domain::Unit | Domain::UnitUpper | Domain::Covariance(..), _) => Vec::new(),
    }
}

/// Values of a component that its range does not hold, from the smallest to the largest.
fn beyond(range: &Range, scalar: Scalar) -> Vec<f64> {
    let (low, high) = match range.domain {
        Domain::Linear(low, high) | Domain::Logarithmic(low, high) | Domain::Integer(low, high) => (low, high),
        Domain::Unit | Domain::UnitUpper => (-1.0, 1.0),
        Domain::Covariance(_, high, _) => (-high * high, high * high),
    };
    let span = high - low;
    let whole = match scalar {
        Scalar::Float => {
            let tiny = f64::from(f32::from_bits(1));
            let near = [low - span, high + span, low - 10.0 * span, high + 10.0 * span];
            return near.into_iter().chain([0.0, -0.0, tiny, -tiny, 1e-30, -1e-30, FAR, -FAR]).collect();
        }
        Scalar::Signed => vec![low - 1.0, high + 1.0, f64::from(i32::MIN), -1.0, 0.0, f64::from(i32::MAX)],
        Scalar::Unsigned => vec![high + 1.0, 0.0, f64::from(u32::MAX)],
        Scalar::Bool => Vec::new(),
    };
    whole.into_iter().map(|value| rounded(value, scalar)).collect()
}

/// Points whose numbers are all out of the ordinary at once.
fn together(ranges: &[Range]) -> Vec<Vec<f64>> {
    [0.0, -0.0, 1.0, -1.0, 1e-30, -1e-30, 1e6, -1e6]
        .into_iter()
        .map(|value| components(ranges).map(|(_, scalar)| rounded(value, scalar)).collect())
        .collect()
}

/// Roberts' additive sequence: coordinate i advances by g^−(i+1) mod 1, g being the root of g^(d+1) = g + 1.
///
/// Source: M. Roberts 2018, "The Unreasonable Effectiveness of Quasirandom Sequences". Low discrepancy in a few
/// dimensions, irrational steps in all.
struct Sequence {
    steps: Vec<f64>,
    count: f64,
}

impl Sequence {
    fn new(dimensions: usize) -> Self {
        let power = dimensions as f64 + 1.0;
        let root = (0..64).fold(2.0f64, |root, _| (1.0 + root).powf(1.0 / power));
        Self { steps: (1..=dimensions).map(|number| root.powi(-(number as i32))).collect(), count: 0.0 }
    }

    fn advance(&mut self) -> Vec<f64> {
        self.count += 1.0;
        // An offset of ½ would put the first points on symmetric positions.
        self.steps.iter().map(|step| (0.137 + self.count * step).fract()).collect()
    }
}
