//! What a module's explanation says that its bound covers: nothing else says where hard cases ask for it.

/// Inputs that a bound covers, of a filter or of a layer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Covers {
    /// Means of values, heights or slopes.
    pub means: [f64; 2],
    /// Deviations of those.
    pub deviations: [f64; 2],
    /// The largest Λ of one direction, and that of view and light together.
    pub lambdas: [f64; 2],
    /// The largest correlation of slopes.
    pub correlation: f64,
    /// The largest mean slope.
    pub steepest: f64,
    /// How many times as large slopes may deviate along an axis as across it.
    pub oblong: f64,
    /// Degrees of the view above the mean plane.
    pub raised: f64,
    /// Whether views are above the horizon of the mean surface.
    pub above: bool,
}

impl Covers {
    /// What an explanation says first: of a layer its part.
    ///
    /// # Errors
    /// A message where it says neither what it covers nor what it ranges over.
    pub fn of(explanation: &str) -> Result<Self, String> {
        let line = |label: &str| explanation.lines().find(|line| line.trim_start().starts_with(label));
        let (covers, ranges) = (line("covers  "), line("ranges  "));
        if covers.is_none() && ranges.is_none() {
            return Err(format!("nothing is said of what is covered: {explanation}"));
        }
        let text = [covers, ranges].into_iter().flatten().collect::<Vec<_>>().join("\n");
        let number = |phrases: &[&str]| phrases.iter().find_map(|phrase| after(&text, phrase)).map(|found| found.0);
        let any = f64::INFINITY;
        let (low, high) = after(&text, "means ").map_or((-any, any), |(low, rest)| {
            (low, rest.strip_prefix(" to ").and_then(leading).map_or(any, |found| found.0))
        });
        let froms = ["deviations of the component from ", "deviations of slopes from ", "deviations from "];
        let from = froms.iter().find_map(|phrase| after(&text, phrase));
        let until = from.and_then(|(_, rest)| rest.strip_prefix(" to ").and_then(leading)).map(|found| found.0);
        Ok(Self {
            means: [low, high],
            deviations: [
                from.map_or(0.0, |found| found.0),
                until.or_else(|| number(&["deviations to "])).unwrap_or(any),
            ],
            lambdas: [number(&["Λ of a direction to "]), number(&["add up to "])].map(|most| most.unwrap_or(any)),
            correlation: number(&["correlations to "]).unwrap_or(1.0),
            steepest: number(&["mean slopes to "]).unwrap_or(any),
            oblong: if text.contains("at most twice as large along an axis as across") { 2.0 } else { any },
            raised: number(&["views from "]).unwrap_or(-90.0),
            above: text.contains("above the horizon of the mean surface"),
        })
    }
}

/// The number behind a phrase, and what follows it.
fn after<'a>(text: &'a str, phrase: &str) -> Option<(f64, &'a str)> {
    leading(text.split_once(phrase)?.1)
}

/// The number that a text begins with, and what follows it.
fn leading(text: &str) -> Option<(f64, &str)> {
    let end = text.find([' ', ',', ':', ';', '\n']).unwrap_or(text.len());
    text[..end].parse().ok().map(|number| (number, &text[end..]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn explanations_are_read() {
        let slopes = "dune: slope\n  covers  views above the horizon of the mean surface, deviations of the component \
                      from 1.4e-3, slope correlations to 0.9, mean slopes to 1.4: a step errs\n  ranges  means -1 to \
                      1.4, deviations to 0.8\n";
        let found = Covers::of(slopes);
        let [means, deviations] = [[-1.0, 1.4], [1.4e-3, 0.8]];
        let any = f64::INFINITY;
        let (lambdas, oblong, raised) = ([any; 2], any, -90.0);
        let all = Covers { means, deviations, lambdas, correlation: 0.9, steepest: 1.4, oblong, raised, above: true };
        assert_eq!(found, Ok(all));
        let curve =
            "  covers  f of means -1 to 2.2 and deviations from 2.1e-2 to 1.5, Λ of view and light that add up \
                     to 1e3 at most\n";
        let found = Covers::of(curve).map(|covers| (covers.means, covers.deviations, covers.lambdas));
        assert_eq!(found, Ok(([-1.0, 2.2], [2.1e-2, 1.5], [any, 1e3])));
        assert!(Covers::of("nothing").is_err());
    }
}
