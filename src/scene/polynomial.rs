//! An expression of layers as a polynomial that is affine in each of them, and how far errors of all layers move it.
//!
//! Where the layers x are within their hulls and their errors e within bounds, P(x + e) − P(x) is affine in each x and
//! in each e, so that its largest size is at a corner of both. Of `mask * a + (1.0 - mask) * b` the errors of a and b
//! count for no more than the larger one, and that of the mask times the difference of a and b.

use super::combination::{hull, Expression};
use super::Scene;

/// The most corners that are tried, and the most terms.
const CORNERS: usize = 4096;
const TERMS: usize = 64;

/// What a polynomial is of.
struct Variable {
    /// The layer or the weight, and the channel where one is named.
    name: Option<(String, Option<usize>)>,
    error: f64,
    ends: [f64; 2],
}

/// Variables, and terms of a factor and the variables that are multiplied.
#[derive(Default)]
struct Polynomial {
    variables: Vec<Variable>,
    terms: Vec<(f64, Vec<usize>)>,
}

/// The largest error of a channel of an expression, from the error, the lowest and the highest value of each layer; the
/// roundings of its sums and products included.
pub(super) fn largest_error(expression: &Expression, of: &dyn Fn(&Scene) -> [f64; 3]) -> f64 {
    let apart = expression.error(of)[0];
    if terms(expression) > TERMS {
        return apart;
    }
    let mut polynomial = Polynomial::default();
    polynomial.terms = polynomial.expanded(expression, of);
    let Some(together) = polynomial.moved() else { return apart };
    let rounding = expression.error(&|scene| {
        let [error, low, high] = of(scene);
        [0.0, low - error, high + error]
    });
    apart.min(together + rounding[0])
}

/// How many terms an expression has, multiplied out.
fn terms(expression: &Expression) -> usize {
    match expression {
        Expression::Sum(a, b) => terms(a).saturating_add(terms(b)),
        Expression::Product(a, b) => terms(a).saturating_mul(terms(b)),
        Expression::Layer(_)
        | Expression::Channel(..)
        | Expression::Weight(_)
        | Expression::Color(_)
        | Expression::Number(_) => 1,
    }
}

impl Polynomial {
    /// The place of a variable; a new one where it has no name or is not known.
    fn variable(&mut self, variable: Variable) -> usize {
        let known = self.variables.iter().position(|known| known.name.is_some() && known.name == variable.name);
        known.unwrap_or_else(|| {
            self.variables.push(variable);
            self.variables.len() - 1
        })
    }

    /// The terms of an expression.
    fn expanded(&mut self, expression: &Expression, of: &dyn Fn(&Scene) -> [f64; 3]) -> Vec<(f64, Vec<usize>)> {
        let mut single = |name, [error, low, high]: [f64; 3]| {
            vec![(1.0, vec![self.variable(Variable { name, error, ends: [low, high] })])]
        };
        match expression {
            Expression::Layer(scene) => single(Some((scene.name.clone(), None)), of(scene)),
            Expression::Channel(scene, channel) => single(Some((scene.name.clone(), Some(*channel))), of(scene)),
            // No layer has the name of a weight.
            Expression::Weight(weight) => single(Some((weight.clone(), None)), [0.0, -1.0, 1.0]),
            Expression::Color(color) => {
                let [low, high] = hull(color.hull(), color.channels());
                single(None, [0.0, low, high])
            }
            Expression::Number(number) => vec![(f64::from(*number), Vec::new())],
            Expression::Sum(a, b) => [self.expanded(a, of), self.expanded(b, of)].concat(),
            Expression::Product(a, b) => {
                let (a, b) = (self.expanded(a, of), self.expanded(b, of));
                let times = |(one, some): &(f64, Vec<usize>), (other, more): &(f64, Vec<usize>)| {
                    (one * other, [some.as_slice(), more].concat())
                };
                a.iter().flat_map(|term| b.iter().map(move |other| times(term, other))).collect()
            }
        }
    }

    /// The largest change by errors; nothing where a variable is multiplied by itself, or has no bound, or where there
    /// are too many corners.
    fn moved(&self) -> Option<f64> {
        let Self { variables, terms } = self;
        let repeated = |term: &[usize]| (1..term.len()).any(|at| term[at..].contains(&term[at - 1]));
        let bounded = variables.iter().all(|variable| variable.error.is_finite());
        if !bounded || terms.iter().any(|(_, term)| repeated(term)) {
            return None;
        }
        // The lowest or the highest value, and from there an error of either sign.
        let choices = |variable: &Variable| {
            let Variable { error, ends, .. } = variable;
            let signs = if *error > 0.0 { [-error, *error].to_vec() } else { vec![0.0] };
            ends.iter().flat_map(|end| signs.iter().map(|error| [*end, end + error]).collect::<Vec<_>>()).collect()
        };
        let choices: Vec<Vec<[f64; 2]>> = variables.iter().map(choices).collect();
        let corners = choices.iter().try_fold(1usize, |corners, own| corners.checked_mul(own.len()))?;
        if corners > CORNERS {
            return None;
        }
        let change = |corner: usize| {
            let mut rest = corner;
            let mut at = Vec::with_capacity(choices.len());
            for own in &choices {
                at.push(own[rest % own.len()]);
                rest /= own.len();
            }
            let value = |which: usize| {
                let term = |(factor, term): &(f64, Vec<usize>)| {
                    term.iter().fold(*factor, |product, &variable| product * at[variable][which])
                };
                terms.iter().map(term).sum::<f64>()
            };
            (value(1) - value(0)).abs()
        };
        Some((0..corners).map(change).fold(0.0, f64::max))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::combination::Combination;
    use crate::{ColorMap, Error};

    /// Scenes of a mask and of two colors.
    fn scenes() -> Result<[Scene; 3], Error> {
        let gray = |low: f32, high: f32| ColorMap::gradient([(0.0, [low; 3]), (1.0, [high; 3])]);
        Ok([
            Scene::new("mask").height(gray(0.0, 1.0)?),
            Scene::new("a").texture(gray(0.25, 0.75)?),
            Scene::new("b").steepness(gray(0.0, 0.5)?),
        ])
    }

    fn found(combination: impl Into<Combination>, errors: [f64; 3]) -> f64 {
        let Combination(expression) = combination.into();
        largest_error(&expression, &|scene| {
            let place = ["mask", "a", "b"].iter().position(|name| *name == scene.name).unwrap_or(0);
            let [low, high] = scene.hull().unwrap_or_default();
            [errors[place], low, high]
        })
    }

    #[test]
    fn errors_of_a_mixture_do_not_add_up() -> Result<(), Error> {
        let [mask, a, b] = &scenes()?;
        let mixed = || mask * a + (1.0 - mask) * b;
        let close = |found: f64, expected: f64| assert!((found - expected).abs() < 1e-5, "{found} {expected}");
        close(found(mixed(), [0.0, 0.01, 0.0]), 0.01);
        close(found(mixed(), [0.0, 0.01, 0.02]), 0.02);
        // The mask's error times the largest difference of colors, 0.75 − 0.
        close(found(mixed(), [0.1, 0.0, 0.0]), 0.075);
        // All at once: of a − b as it is with errors of both, and of b.
        close(found(mixed(), [0.1, 0.01, 0.01]), 0.1 * 0.77 + 0.01);
        close(found(a + b, [0.0, 0.01, 0.02]), 0.03);
        // A weight on either side is one, too.
        let weighted = Combination::weight("w")? * a + (1.0 - Combination::weight("w")?) * b;
        close(found(weighted, [0.0, 0.01, 0.01]), 0.03);
        // What is not affine counts as apart.
        let squared = Combination::weight("w")? * Combination::weight("w")? * a;
        close(found(squared, [0.0, 0.01, 0.0]), 0.01);
        Ok(())
    }

    /// A stack of layers, each over those below it, has twice as many terms with each.
    #[test]
    fn many_layers_count_apart() -> Result<(), Error> {
        let [mask, a, b] = &scenes()?;
        let mut stack = Combination::from(b);
        for _ in 0..40 {
            stack = mask * a + (1.0 - mask) * stack;
        }
        // Apart, the errors of all products of the mask add up: many times the 0.01 that any point moves by.
        let apart = found(stack, [0.0, 0.01, 0.01]);
        assert!((0.01..1.0).contains(&apart), "{apart}");
        Ok(())
    }

    /// No point within the hulls is moved farther than by the largest error.
    #[test]
    fn nothing_moves_farther() -> Result<(), Error> {
        let [mask, a, b] = &scenes()?;
        let errors = [0.2, 0.1, 0.05];
        let most = found(mask * a + (0.5 - mask) * b, errors);
        let value = |[mask, a, b]: [f64; 3]| mask * a + (0.5 - mask) * b;
        let (mut largest, steps) = (0.0f64, [0.0, 0.25, 0.5, 0.75, 1.0]);
        for index in 0..5usize.pow(6) {
            let part = |place: u32| steps[index / 5usize.pow(place) % 5];
            let at = [part(0), 0.25 + 0.5 * part(1), 0.5 * part(2)];
            let moved = std::array::from_fn(|place| at[place] + errors[place] * (2.0 * part(place as u32 + 3) - 1.0));
            largest = largest.max((value(moved) - value(at)).abs());
        }
        assert!(largest <= most && most < largest + 1e-5, "{largest} {most}");
        Ok(())
    }
}
