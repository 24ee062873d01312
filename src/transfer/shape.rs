//! The shapes of height transfers, checked and cut into pieces.

use super::color_map::{MAX_COLOR, MAX_KNOTS};
use super::polynomial::Piece;
use crate::Error;

/// The most risers of a terraced curve.
pub(super) const MAX_TERRACES: usize = 512;

/// The largest exponent of a power.
const MAX_EXPONENT: f32 = 8.0;

/// A curve before it is scaled, as it was asked for.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) enum Shape {
    Knots(Vec<(f32, f32)>),
    Samples { low: f32, high: f32, heights: Vec<f32> },
    Smoothstep { from: f32, to: f32 },
    Absolute,
    Terraces { count: usize, riser: f32 },
    Power { exponent: f32 },
}

impl Shape {
    /// The pieces from −∞ to ∞; none of a power that is no cubic.
    pub fn pieces(&self) -> Result<Vec<Piece>, Error> {
        match *self {
            Self::Knots(ref knots) => polygon(knots),
            Self::Samples { low, high, ref heights } => samples(low, high, heights),
            Self::Smoothstep { from, to } => {
                within("the low end of a smoothstep", from)?;
                within("the high end of a smoothstep", to)?;
                between("the slope of a smoothstep", [from.into(), to.into()], 1.5)?;
                let [from, to] = [from, to].map(f64::from);
                Ok(vec![flat_below(from, 0.0), Piece::hermite([from, to], [0.0, 1.0], [0.0; 2]), flat_above(to, 1.0)])
            }
            Self::Absolute => Ok(creased().to_vec()),
            Self::Terraces { count, riser } => terraces(count, riser),
            Self::Power { exponent } => power(exponent),
        }
    }
}

/// The distance from the origin, as a polynomial.
const LINE: [f64; 4] = [0.0, 1.0, 0.0, 0.0];

/// |f|
pub(super) fn creased() -> [Piece; 2] {
    [Piece::below(0.0, LINE.map(|coefficient| -coefficient)), Piece::above(0.0, LINE)]
}

fn flat_below(to: f64, height: f64) -> Piece {
    Piece::below(to, [height, 0.0, 0.0, 0.0])
}

fn flat_above(from: f64, height: f64) -> Piece {
    Piece::above(from, [height, 0.0, 0.0, 0.0])
}

fn polygon(knots: &[(f32, f32)]) -> Result<Vec<Piece>, Error> {
    count("the knots of a height transfer", knots.len(), 1, MAX_KNOTS)?;
    for (index, &(value, height)) in knots.iter().enumerate() {
        within(&format!("the value of knot {index}"), value)?;
        within(&format!("the height of knot {index}"), height)?;
    }
    let wide: Vec<[f64; 2]> = knots.iter().map(|&(value, height)| [value.into(), height.into()]).collect();
    let (first, last) = (wide[0], wide[wide.len() - 1]);
    let mut pieces = vec![flat_below(first[0], first[1])];
    for (index, pair) in wide.windows(2).enumerate() {
        let [[from, low], [to, high]] = [pair[0], pair[1]];
        between(&format!("the slope behind knot {index}"), [from, to], high - low)?;
        pieces.push(Piece::between(from, to, [low, high - low, 0.0, 0.0]));
    }
    pieces.push(flat_above(last[0], last[1]));
    Ok(pieces)
}

/// The cubics through evenly spaced heights that never leave the heights at their ends.
///
/// Source: Fritsch and Butland 1984, "A method for constructing local monotone piecewise cubic interpolants", whose
/// slopes are the harmonic means of those on both sides; flat where these differ in sign, and at both ends of the
/// curve.
fn samples(low: f32, high: f32, heights: &[f32]) -> Result<Vec<Piece>, Error> {
    count("the samples of a height transfer", heights.len(), 2, MAX_KNOTS)?;
    within("the low end of the samples", low)?;
    within("the high end of the samples", high)?;
    for (index, &height) in heights.iter().enumerate() {
        within(&format!("sample {index}"), height)?;
    }
    let (start, parts) = (f64::from(low), (heights.len() - 1) as f64);
    let span = f64::from(high) - start;
    let place = |index: usize| start + span * index as f64 / parts;
    let height = |index: usize| f64::from(heights[index]);
    let rise = |index: usize| height(index + 1) - height(index);
    let slope = |index: usize| -> f64 {
        if index == 0 || index == heights.len() - 1 {
            return 0.0;
        }
        let [before, after] = [rise(index - 1), rise(index)];
        let mean = if before * after > 0.0 { 2.0 * before * after / (before + after) } else { 0.0 };
        mean * parts / span
    };
    let mut pieces = vec![flat_below(start, height(0))];
    for index in 0..heights.len() - 1 {
        let ends = [place(index), place(index + 1)];
        // No cubic of these is more than twice as steep as the line between its ends.
        between(&format!("the slope behind sample {index}"), ends, 2.0 * rise(index))?;
        let cubic = Piece::hermite(ends, [height(index), height(index + 1)], [slope(index), slope(index + 1)]);
        pieces.push(cubic);
    }
    pieces.push(flat_above(f64::from(high), height(heights.len() - 1)));
    Ok(pieces)
}

fn terraces(number: usize, riser: f32) -> Result<Vec<Piece>, Error> {
    count("the risers of terraces", number, 1, MAX_TERRACES)?;
    if !(riser > 0.0 && riser <= 1.0) {
        return Err(Error::value("a riser's share of a terrace", riser, "above 0 and at most 1"));
    }
    let (steps, half) = (number as f64, 0.5 * f64::from(riser));
    between("the slope of terraces", [0.5 - half, 0.5 + half], 1.5)?;
    let mut pieces = Vec::new();
    let mut reached = f64::NEG_INFINITY;
    for index in 0..number {
        let [low, high] = [index, index + 1].map(|level| level as f64 / steps);
        let [from, to] = [-half, half].map(|side| (index as f64 + 0.5 + side) / steps);
        if index == 0 {
            pieces.push(flat_below(from, low));
        } else if from > reached {
            pieces.push(Piece::between(reached, from, [low, 0.0, 0.0, 0.0]));
        }
        // Risers that fill the terraces begin where the one before ends, to the last digit.
        let from = if riser < 1.0 || index == 0 { from } else { reached };
        pieces.push(Piece::hermite([from, to], [low, high], [0.0; 2]));
        reached = to;
    }
    pieces.push(flat_above(reached, 1.0));
    Ok(pieces)
}

fn power(exponent: f32) -> Result<Vec<Piece>, Error> {
    if !(1.0..=MAX_EXPONENT).contains(&exponent) {
        return Err(Error::value("the exponent of a height transfer", exponent, format!("1 to {MAX_EXPONENT}")));
    }
    let square = |sign: f64| [0.0, 0.0, sign, 0.0];
    Ok(match exponent {
        1.0 => vec![Piece::everywhere(LINE)],
        2.0 => vec![Piece::below(0.0, square(-1.0)), Piece::above(0.0, square(1.0))],
        3.0 => vec![Piece::everywhere([0.0, 0.0, 0.0, 1.0])],
        _ => Vec::new(),
    })
}

/// Whether a value or a height is in the limits.
fn within(what: &str, value: f32) -> Result<(), Error> {
    if value.abs() <= MAX_COLOR {
        return Ok(());
    }
    Err(Error::value(what, value, format!("a number from -{MAX_COLOR} to {MAX_COLOR}")))
}

/// Whether values rise, and so far that a rise between them is no cliff.
fn between(what: &str, [from, to]: [f64; 2], rise: f64) -> Result<(), Error> {
    let slope = rise / (to - from);
    if to > from && slope.abs() <= f64::from(MAX_COLOR) {
        return Ok(());
    }
    let allowed = format!("a number from -{MAX_COLOR} to {MAX_COLOR}, between values that rise: a cliff has no slope");
    Err(Error::value(what, slope as f32, allowed))
}

fn count(what: &str, count: usize, least: usize, most: usize) -> Result<(), Error> {
    if (least..=most).contains(&count) {
        return Ok(());
    }
    Err(Error::Size { what: what.into(), count, allowed: format!("{least} to {most}") })
}
