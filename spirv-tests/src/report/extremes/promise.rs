//! Where modules promise how near filters are, and how near.

use prefilter::reference::footprint::deviations;
use prefilter::Module;

use super::covers::Covers;
use super::filters::Filter;
use super::points::Point;
use super::subject::Subject;

/// What is promised of a filter, or of each layer of a combination.
#[derive(Clone, Debug, PartialEq)]
pub struct Promised {
    bound: f64,
    covers: Vec<(Filter, Covers)>,
}

impl Promised {
    /// What the module says.
    ///
    /// # Errors
    /// A message where it says nothing.
    pub fn new(subject: &Subject, module: &Module) -> Result<Self, String> {
        let bound = f64::from(module.bound().value());
        let (filter, text) = (subject.filter, module.explain());
        let covers = match filter {
            Filter::Visibility => {
                let [bound, correlation] = shares(module)?;
                let covers = Covers { correlation, ..Covers::of(text)? };
                return Ok(Self { bound, covers: vec![(filter, covers)] });
            }
            Filter::Combination => {
                let parts = text.split("  layer   ").skip(1);
                let of = |(layer, part): (&Subject, &str)| Covers::of(part).map(|covers| (layer.filter, covers));
                subject.layers.iter().zip(parts).map(of).collect::<Result<Vec<_>, _>>()?
            }
            _ => vec![(filter, Covers::of(text)?)],
        };
        if covers.len() != subject.layers.len().max(1) {
            return Err(format!("a combination says too little of its layers: {text}"));
        }
        Ok(Self { bound, covers })
    }

    /// From what a result is promised to be no farther than a bound, if any: the truth of what the point counts as.
    pub fn at(&self, subject: &Subject, point: &Point, truth: [f64; 4]) -> Option<([f64; 4], f64)> {
        if !self.covers.iter().all(|(filter, covers)| point.within(*filter, covers)) {
            return None;
        }
        // What layers together are where one of them counts a point as another, no truth says.
        if self.covers.len() > 1 && !self.covers.iter().all(|(filter, covers)| point.counts_as_itself(*filter, covers))
        {
            return None;
        }
        let (_, covers) = self.covers.first()?;
        let counted = match subject.filter {
            Filter::Height | Filter::HeightTransfer => subject.hidden(point, covers)?,
            Filter::Slope => subject.narrowed(point, covers)?,
            _ => truth,
        };
        Some((counted, self.bound + moved(subject, covers, point, truth)))
    }
}

/// What the export says that shares that are lit are within, and up to which correlation of slopes.
fn shares(module: &Module) -> Result<[f64; 2], String> {
    let lit = module.exports().iter().find(|export| export.name.ends_with("_visibility"));
    let text = lit.ok_or("no share is lit")?.documentation.split_whitespace().collect::<Vec<_>>().join(" ");
    let number = |phrase: &str| {
        let (_, rest) = text.split_once(phrase)?;
        rest.split(' ').next()?.trim_end_matches('.').parse().ok()
    };
    let numbers = number("Within ").zip(number("correlations up to "));
    numbers
        .map(|(bound, correlation)| [bound, correlation])
        .ok_or(format!("what shares are within is not said: {text}"))
}

/// How far the truth of narrow heights or slopes moves within what positions are rounded by.
fn moved(subject: &Subject, covers: &Covers, point: &Point, truth: [f64; 4]) -> f64 {
    let ([low, high], [least, _]) = (covers.means, covers.deviations);
    let at = |part: f64| match subject.filter {
        Filter::Height if point.deviation < least => {
            Some(Point { mean: point.mean + part * low.abs().max(high.abs()), ..*point })
        }
        Filter::Slope if point.component_deviation() < least => Some(point.leaning(part * covers.steepest)),
        _ => None,
    };
    let ends = [ROUNDED, -ROUNDED].into_iter().filter_map(|part| subject.truth(&at(part)?));
    ends.map(|end| farthest(truth, end)).fold(0.0, f64::max)
}

fn farthest(one: [f64; 4], other: [f64; 4]) -> f64 {
    one.iter().zip(other).fold(0.0, |most: f64, (one, other)| most.max((one - other).abs()))
}

/// What positions of a map are rounded by, in parts of the largest: sums of three products, and a sum with a knot;
/// where deviations below 1e-6 count as that, within six of those.
const ROUNDED: f64 = 4.0 / 16_777_216.0 + 6e-6;

impl Point {
    /// The point with a mean slope that much steeper along the direction.
    fn leaning(&self, by: f64) -> Self {
        let [x, y] = self.direction;
        Self { mean_slope: [self.mean_slope[0] + by * x, self.mean_slope[1] + by * y], ..*self }
    }

    /// Whether a filter's module covers the point.
    fn within(&self, filter: Filter, covers: &Covers) -> bool {
        let Covers { means: [low, high], deviations: [least, most], steepest, .. } = *covers;
        let inside = |value: f64| low <= value && value <= high;
        let [x, y] = self.mean_slope;
        let steep = x.hypot(y);
        let [major, minor] = deviations(self.covariance);
        let round = minor >= least && major <= covers.oblong * minor && major <= most;
        match filter {
            // Larger deviations count as the largest, in the truth as well.
            Filter::Texture => inside(self.mean),
            // Narrow heights and large Λ, too.
            Filter::Height => inside(self.mean),
            Filter::HeightPercentile => self.hidden(covers),
            Filter::Visibility => self.hidden(covers) && !self.correlated(covers.correlation),
            // Narrow and wide slopes, too.
            Filter::Slope => self.sees(covers) && inside(self.component()) && steep <= steepest,
            Filter::SlopeMap => self.sees(covers) && round && inside(x) && inside(y),
            Filter::Steepness => self.sees(covers) && round && steep <= high,
            Filter::Irradiance => self.sees(covers) && major <= most && x.abs() <= steepest && y.abs() <= steepest,
            // Large deviations, too.
            Filter::HeightTransfer => inside(self.mean) && self.deviation >= least && self.hidden(covers),
            // Its layers say so.
            Filter::Combination => true,
        }
    }

    /// Whether a filter's module takes the point as it is, and not for another one at the end of what is covered.
    fn counts_as_itself(&self, filter: Filter, covers: &Covers) -> bool {
        let [least, most] = covers.deviations;
        match filter {
            Filter::Height => self.deviation >= least && self.hidden(covers),
            Filter::Slope => (least..=most).contains(&self.component_deviation()),
            _ => true,
        }
    }

    fn hidden(&self, covers: &Covers) -> bool {
        let [each, both] = covers.lambdas;
        [self.view, self.light].into_iter().all(|direction| self.lambda(direction) <= each.min(LARGEST))
            && self.lambdas() <= both
    }

    fn sees(&self, covers: &Covers) -> bool {
        let above = !covers.above || self.visible().rise() > 0.0;
        above && self.view[2] >= covers.raised.to_radians().sin() && !self.correlated(covers.correlation)
    }

    fn correlated(&self, most: f64) -> bool {
        let [xx, xy, yy] = self.covariance;
        xy * xy > most * most * xx * yy
    }
}

/// The largest Λ of a direction above the horizon, as `smith_lambda` says.
const LARGEST: f64 = 5.2e5;
