//! The slopes and the heights in sight of transferred fields, h = g(f), against what is said of them.
//!
//! Fields f of a spectrum are put through a curve and looked at along their rows. Slopes are those of the segments
//! between nodes. What all slopes lack, by chance, of the mixture over scales is taken off both. Edges stay clear of
//! the slope 0, where level ground has a step, by a fiftieth of the deviation: segments across a bend are not level.

use std::f64::consts::SQRT_2;

use prefilter::reference::normal::cumulative as normal;
use prefilter::reference::slope_nodes::{Along, Part, Transferred};
use prefilter::reference::smith::lambda as smith;
use prefilter::table::slope_nodes::{Nodes, FOLLOWS};
use prefilter::HeightTransfer;

use super::field::{Field, Spectrum};
use super::figure::{over_seeds, Figure};
use super::sight::{Sight, OVERHEAD};
use super::study::Extent;

/// The deviation of the slopes of h.
const DEVIATION: f64 = 0.5;

/// The largest errors of a step over all edges.
#[derive(Clone, Copy, Debug)]
pub struct Stepped {
    /// Of slopes, by one normal distribution: the paper's.
    pub single: Figure,
    /// Of slopes, by the mixture over all scales, of which hiding prefers no height.
    pub unhidden: Figure,
    /// Of slopes, by the mixture as it is hidden.
    pub mixture: Figure,
    /// Of slopes, by two, three and four nodes.
    pub nodes: [Figure; 3],
    /// Of heights, by a normal distribution of them and one of slopes, with D_h itself: the paper's but for its fits.
    pub heights_single: Figure,
    /// Of heights as they are, by P^Λ with the Λ of the mixture: as if all heights were as steep.
    pub heights_alike: Figure,
    /// Of heights, by P V of slopes that go with the height.
    pub heights: Figure,
}

/// Edges of slopes in deviations of all, ends of the bins of histograms.
fn edges() -> Vec<f64> {
    let even = (-80..=80).map(|edge| 0.05 * f64::from(edge)).filter(|edge: &f64| edge.abs() > 0.02);
    let mut edges: Vec<f64> = even.chain([-0.02, 0.02]).collect();
    edges.sort_by(f64::total_cmp);
    edges
}

/// Looks at fields of a spectrum through a curve, from so many degrees off the normal each.
pub fn stepped(curve: &HeightTransfer, spectrum: Spectrum, extent: Extent, degrees: &[f64]) -> Vec<Stepped> {
    let parameters = degrees.iter().map(|degrees| 1.0 / (degrees.to_radians().tan() * SQRT_2 * DEVIATION));
    let parameters: Vec<f64> = parameters.chain([OVERHEAD]).collect();
    let shown = over_seeds(extent.seeds, |seed| {
        let mut sights = vec![Sight::default(); parameters.len()];
        for field in extent.views(spectrum, seed) {
            let heights = field.heights.iter().map(|value| curve.height(*value)).collect();
            let field = Field { heights, ..field };
            for (sight, parameter) in sights.iter_mut().zip(&parameters) {
                sight.add(&Sight::along_rows(&field, *parameter));
            }
        }
        sights
    });
    let judged = degrees.iter().enumerate().map(|(view, degrees)| judge(&shown, view, &Models::new(curve, *degrees)));
    judged.collect()
}

/// The figures of a view; the last sight of a seed is overhead.
fn judge(shown: &[Vec<Sight>], view: usize, models: &Models) -> Stepped {
    let figures = Figure::jackknife(shown, |seeds| {
        let (mut seen, mut all) = (Sight::default(), Sight::default());
        for seed in seeds {
            seen.add(&seed[view]);
            all.add(&seed[seed.len() - 1]);
        }
        models.errors(&seen, &all)
    });
    let [single, unhidden, mixture, two, three, four, heights_single, heights_alike, heights] = figures;
    Stepped { single, unhidden, mixture, nodes: [two, three, four], heights_single, heights_alike, heights }
}

/// A part of which only the scale matters.
fn of(scale: f64, share: f64) -> Part {
    Part { value: 0.0, share, height: 0.0, scale }
}

/// The nodes over all values as a surface, with the share of each in what is seen.
fn in_sight(nodes: &Nodes<'_>, along: Along) -> (Transferred, Vec<f64>) {
    let nodes = nodes.over(0.0, 1.0);
    let few = Transferred { parts: nodes.map(|node| of(node.scale, node.weight)).to_vec() };
    let lambda = few.lambda(along);
    let areas = few.shares(along, 0.0, 0.0).into_iter();
    let hidden = nodes.map(|node| (-node.rate / node.spread * (lambda * node.spread).ln_1p()).exp());
    let seen: Vec<f64> = areas.zip(hidden).map(|(area, hidden)| area * hidden).collect();
    let whole: f64 = seen.iter().sum();
    (few, seen.into_iter().map(|share| share / whole).collect())
}

/// The shares of the surface below levels, when `shares` of its parts count.
fn under(surface: &Transferred, shares: &[f64], levels: &[f64]) -> Vec<f64> {
    let under = |level: &f64| {
        let parts = surface.parts.iter().zip(shares).filter(|(part, _)| part.height < *level);
        parts.map(|(_, share)| share).sum()
    };
    levels.iter().map(under).collect()
}

/// Visible heights below levels, of normal ones with the surface's mean and deviation and one normal distribution of
/// slopes.
fn normal_heights(surface: &Transferred, degrees: f64, levels: &[f64]) -> Vec<f64> {
    let mean = surface.average(|part| part.height);
    let deviation = surface.average(|part| (part.height - mean).powi(2)).sqrt();
    let lambda = smith(1.0 / (degrees.to_radians().tan() * SQRT_2 * DEVIATION));
    levels.iter().map(|level| normal((level - mean) / deviation).powf(1.0 + lambda)).collect()
}

/// What is said of a curve's slopes and heights at a view.
struct Models {
    edges: Vec<f64>,
    /// The shares below the edges: of all slopes, and of those in sight by each model.
    all: Vec<f64>,
    slopes: [Vec<f64>; 6],
    levels: Vec<f64>,
    /// The shares below the levels: of all heights, and of those in sight by each model.
    all_heights: Vec<f64>,
    heights: [Vec<f64>; 3],
}

impl Models {
    fn new(curve: &HeightTransfer, degrees: f64) -> Self {
        let surface = Nodes { curve, count: 4, signed: false }.surface(64, 0.0, 1.0);
        let scale = surface.average(|part| part.scale * part.scale).sqrt();
        let along = Along { angle: degrees.to_radians(), mean: 0.0, deviation: DEVIATION / scale };
        let edges = edges();
        let inclines: Vec<f64> = edges.iter().map(|edge| DEVIATION * edge).collect();
        let by = |surface: &Transferred, shares: &[f64]| surface.below(along, shares, &inclines);
        let [two, three, four] = [2, 3, 4].map(|count| {
            let (few, shares) = in_sight(&Nodes { curve, count, signed: false }, along);
            by(&few, &shares)
        });
        let lambda = surface.lambda(along);
        let [unhidden, mixture] = [0.0, lambda].map(|lambda| by(&surface, &surface.shares(along, lambda, FOLLOWS)));
        let single = by(&Transferred { parts: vec![of(scale, 1.0)] }, &[1.0]);
        let all: Vec<f64> = surface.parts.iter().map(|part| part.share).collect();
        let (low, high) = curve.range(-3.0, 3.0);
        let levels: Vec<f64> = (1..60).map(|level| low + (high - low) * f64::from(level) / 60.0).collect();
        let all_heights = under(&surface, &all, &levels);
        let heights = [
            normal_heights(&surface, degrees, &levels),
            all_heights.iter().map(|share| share.powf(1.0 + lambda)).collect(),
            under(&surface, &surface.visible_heights(lambda), &levels),
        ];
        let all = surface.below(Along { angle: 0.0, ..along }, &all, &inclines);
        Self { edges, all, slopes: [single, unhidden, mixture, two, three, four], levels, all_heights, heights }
    }

    fn errors(&self, seen: &Sight, all: &Sight) -> [f64; 9] {
        let error = |model: &Vec<f64>, ideal: &[f64], seen: Vec<f64>, all: Vec<f64>| {
            let each = model.iter().zip(ideal).zip(seen.iter().zip(all));
            each.map(|((model, ideal), (seen, all))| (seen - (all - ideal) - model).abs()).fold(0.0, f64::max)
        };
        let slopes = |model| error(model, &self.all, seen.slopes.below(&self.edges), all.slopes.below(&self.edges));
        let heights =
            |model| error(model, &self.all_heights, seen.heights.below(&self.levels), all.heights.below(&self.levels));
        let [a, b, c, d, e, f] = self.slopes.each_ref().map(slopes);
        let [g, h, i] = self.heights.each_ref().map(heights);
        [a, b, c, d, e, f, g, h, i]
    }
}
