//! What the documentation of a shelf function promises: `Source:`, `Domain:` and `Error:`.
//!
//! `Domain:` names every parameter that is not a texture or a sampler, members of structures one by one
//! (`cell.fraction in [0, 1]`), each with one of the ranges of [`Domain`], or with the function of the shelf that makes
//! the structure (`tails from height_skewed`), whose ranges are the maker's. `Error:` is a number with `absolute`,
//! `relative` or `of 1 + the result`, or `exact`; a reason may follow behind a semicolon.

use crate::kernel::Function;
use crate::signature::{Leaf, Shape};

/// The range of a parameter, a number of every component.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Domain {
    /// `in [a, b]`: each component evenly.
    Linear(f64, f64),
    /// `log in [a, b]`: each component evenly in its logarithm.
    Logarithmic(f64, f64),
    /// `integer in [a, b]`: each component a whole number.
    Integer(f64, f64),
    /// `unit`: directions of the whole sphere (three components) or circle (two).
    Unit,
    /// `unit upper`: directions whose last component is not negative.
    UnitUpper,
    /// `psd(σmin, σmax, ρmax)`: covariances (xx, xy, yy), deviations even in their logarithm, correlations up to ±ρmax.
    Covariance(f64, f64, f64),
}

/// How far a result may be from the reference.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Promise {
    /// At most this far in every component.
    Absolute(f64),
    /// At most this share of the expected result's largest component, in every component.
    Relative(f64),
    /// `of 1 + the result`: at most this share of one more than the expected result's largest component, in every
    /// component; absolute for small results and relative for large ones.
    Mixed(f64),
    /// The reference itself.
    Exact,
}

/// A parameter, or a member of one, with its range and its components.
#[derive(Clone, Debug, PartialEq)]
pub struct Range {
    /// The name, with members behind points.
    pub name: String,
    /// The values that the contract is about.
    pub domain: Domain,
    /// Its components among the numbers that the function takes.
    pub leaves: Vec<Leaf>,
}

/// The promise of one function.
#[derive(Clone, Debug, PartialEq)]
pub struct Contract {
    /// Where the function's definition comes from.
    pub source: String,
    /// A range for all the numbers that the function takes, in their order.
    pub ranges: Vec<Range>,
    /// What is promised within them.
    pub promise: Promise,
}

impl Contract {
    /// The contract in a function's documentation.
    ///
    /// # Errors
    /// A message that names the function and the clause that is missing or not understood.
    pub fn of(function: &Function) -> Result<Self, String> {
        let fail = |what: String| format!("`{}`: {what}", function.name);
        let clause = |label: &str| {
            paragraph(&function.documentation, label).ok_or_else(|| fail(format!("the clause `{label}` is missing")))
        };
        let source = clause("Source:")?;
        let promise = promise(&clause("Error:")?).map_err(|error| fail(format!("`Error:` {error}")))?;
        let domain = if function.signature.inputs().is_empty() { String::new() } else { clause("Domain:")? };
        let mut named = Vec::new();
        for part in parts(domain.trim_end_matches('.')) {
            named.push(named_range(part).map_err(|error| fail(format!("`Domain:` {error}")))?);
        }
        let mut ranges = Vec::new();
        for (name, shape) in &function.signature.parameters {
            place(name, shape, &mut named, &mut ranges).map_err(|error| fail(format!("`Domain:` {error}")))?;
        }
        match named.first() {
            Some((name, _)) => Err(fail(format!("`Domain:` names `{name}`, which is no parameter"))),
            None => Ok(Self { source, ranges, promise }),
        }
    }
}

/// The text behind a label, up to the next label or the end of the paragraph.
fn paragraph(documentation: &str, label: &str) -> Option<String> {
    let mut lines = documentation.lines().skip_while(|line| !line.starts_with(label));
    let first = lines.next()?.strip_prefix(label)?;
    let labels = ["Source:", "Domain:", "Error:"];
    let rest = lines.take_while(|line| !line.is_empty() && !labels.iter().any(|label| line.starts_with(label)));
    let words = std::iter::once(first).chain(rest).flat_map(str::split_whitespace);
    Some(words.collect::<Vec<_>>().join(" ")).filter(|text| !text.is_empty())
}

/// The parts between commas outside brackets.
pub(crate) fn parts(text: &str) -> Vec<&str> {
    let mut depth = 0;
    let split = text.split(move |mark| {
        depth += match mark {
            '[' | '(' => 1,
            ']' | ')' => -1,
            _ => 0,
        };
        mark == ',' && depth == 0
    });
    split.map(str::trim).filter(|part| !part.is_empty()).collect()
}

fn named_range(part: &str) -> Result<(String, Domain), String> {
    let unknown = || {
        let known = "`NAME in [a, b]`, `log in`, `integer in`, `unit`, `unit upper`, `psd(σmin, σmax, ρmax)`";
        format!("says `{part}`; known are {known}")
    };
    let (name, range) = part.split_once(' ').ok_or_else(unknown)?;
    let interval = |text: &str, domain: fn(f64, f64) -> Domain| {
        let inside = text.trim().strip_prefix('[').and_then(|text| text.strip_suffix(']')).ok_or_else(unknown)?;
        match numbers(inside)?.as_slice() {
            &[low, high] if low <= high => Ok(domain(low, high)),
            _ => Err(format!("says `{part}`, whose bounds are not two numbers in rising order")),
        }
    };
    let domain = match range {
        "unit" => Domain::Unit,
        "unit upper" => Domain::UnitUpper,
        _ => match (range.split_once("in "), range.strip_prefix("psd(").and_then(|text| text.strip_suffix(')'))) {
            (_, Some(inside)) => match numbers(inside)?.as_slice() {
                &[low, high, most] if 0.0 < low && low < high && 0.0 < most && most <= 1.0 => {
                    Domain::Covariance(low, high, most)
                }
                _ => {
                    return Err(format!("says `{part}`; deviations rise from above 0 and the correlation is in (0, 1]"))
                }
            },
            (Some(("", bounds)), None) => interval(bounds, Domain::Linear)?,
            (Some(("integer ", bounds)), None) => interval(bounds, Domain::Integer)?,
            (Some(("log ", bounds)), None) => match interval(bounds, Domain::Logarithmic)? {
                Domain::Logarithmic(low, _) if low <= 0.0 => {
                    return Err(format!("says `{part}`; logarithms begin above 0"))
                }
                domain => domain,
            },
            _ => return Err(unknown()),
        },
    };
    Ok((name.to_owned(), domain))
}

fn numbers(text: &str) -> Result<Vec<f64>, String> {
    let number =
        |word: &str| word.trim().parse::<f64>().map_err(|_| format!("says `{}`, which is no number", word.trim()));
    text.split(',').map(number).collect()
}

/// Moves the range of a parameter, or the ranges of its members, from the named ones to the ordered ones.
fn place(name: &str, shape: &Shape, named: &mut Vec<(String, Domain)>, ranges: &mut Vec<Range>) -> Result<(), String> {
    let components = match shape {
        Shape::Texture | Shape::Volume | Shape::Sampler => return Ok(()),
        Shape::Structure(_, members) => {
            return members
                .iter()
                .try_for_each(|(member, shape)| place(&format!("{name}.{member}"), shape, named, ranges));
        }
        Shape::Scalar(_) => 1,
        Shape::Vector(size, _) => *size,
        Shape::Matrix(..) => 0,
    };
    let at = named.iter().position(|(other, _)| other == name).ok_or_else(|| format!("does not name `{name}`"))?;
    let (_, domain) = named.remove(at);
    let fits = match domain {
        Domain::Unit | Domain::UnitUpper => components == 2 || components == 3,
        Domain::Covariance(..) => components == 3,
        Domain::Linear(..) | Domain::Logarithmic(..) | Domain::Integer(..) => true,
    };
    if !fits {
        return Err(format!("gives `{name}` a range that its type has not"));
    }
    ranges.push(Range { name: name.to_owned(), domain, leaves: shape.leaves(name) });
    Ok(())
}

fn promise(text: &str) -> Result<Promise, String> {
    let rule = text.split(';').next().unwrap_or_default().trim().trim_end_matches('.');
    let known = "known are `NUMBER absolute`, `NUMBER relative`, `NUMBER of 1 + the result` and `exact`";
    let unknown = || format!("says `{rule}`; {known}");
    if rule == "exact" {
        return Ok(Promise::Exact);
    }
    let (number, kind) = rule.split_once(' ').ok_or_else(unknown)?;
    let bound = number.parse::<f64>().map_err(|_| unknown())?;
    if !(bound > 0.0 && bound.is_finite()) {
        return Err(format!("promises {bound}, which is no positive number"));
    }
    match kind {
        "absolute" => Ok(Promise::Absolute(bound)),
        "relative" => Ok(Promise::Relative(bound)),
        "of 1 + the result" => Ok(Promise::Mixed(bound)),
        _ => Err(unknown()),
    }
}
