//! Maps of height and steepness together, as sums of products.

use nalgebra::DMatrix;

use super::{Combination, Scene};
use crate::transfer::color_map::{ColorMap, MAX_COLOR};
use crate::Error;

/// The most products of a sum, the channels of one map.
const MOST: usize = 4;

/// The most nodes along an axis.
const NODES: usize = 256;

/// A color by height and steepness together, snow that is high and flat: C(h, |s|) ≈ Σ uₖ(h) vₖ(|s|).
///
/// Heights and slopes of a Gaussian surface are independent where they are taken, so that the mean of each product is
/// the product of the means of uₖ over the heights that are seen and of vₖ over the slopes. The sum is the singular
/// value decomposition of the colors at the nodes, whose first terms are the closest of as few products (Eckart and
/// Young 1936, "The Approximation of One Matrix by Another of Lower Rank"). A map of bands in height times bands in
/// steepness needs two.
///
/// Heitz, Nowrouzezahrai, Poulin and Neyret 2014 leave maps of both to future work (section 10).
///
/// ```
/// use prefilter::{JointMap, Scene};
/// // Snow where it is high and flat, on rock.
/// let snow = |height: f32, steepness: f32| {
///     let part = ((height - 600.0) / 100.0).clamp(0.0, 1.0) * ((0.6 - steepness) / 0.2).clamp(0.0, 1.0);
///     [0.3, 0.25, 0.2].map(|rock| rock + part * (0.95 - rock))
/// };
/// let map = JointMap::new([500.0, 600.0, 700.0, 800.0], [0.0, 0.4, 0.6, 1.0], snow)?;
/// assert!(map.errors()[1] < 1e-6);
/// let module = Scene::new("peak").combination(map.combination("snow", 2)?).module()?;
/// assert_eq!(module.exports()[0].name, "peak_combined");
/// # Ok::<(), prefilter::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct JointMap {
    heights: Vec<f32>,
    steepnesses: Vec<f32>,
    terms: Vec<Term>,
    errors: Vec<f32>,
}

/// To which weights are rounded.
const DIGIT: f64 = 1.0 / (1u32 << 20) as f64;

/// uₖ at the heights, from −1 to 1, and vₖ at the steepnesses.
#[derive(Clone, Debug, PartialEq)]
struct Term {
    weights: Vec<f32>,
    colors: Vec<[f32; 3]>,
}

impl JointMap {
    /// The decomposition of a function of height and steepness: its colors at the nodes, linear in either between them
    /// and constant beyond. Nodes rise; where two are close there is an edge.
    ///
    /// # Errors
    /// Fewer than 2 or more than 256 nodes along an axis, nodes that do not rise, a node or color that is no number or
    /// beyond ±65504.
    pub fn new(
        heights: impl IntoIterator<Item = f32>,
        steepnesses: impl IntoIterator<Item = f32>,
        color: impl Fn(f32, f32) -> [f32; 3],
    ) -> Result<Self, Error> {
        let heights = nodes("heights", heights)?;
        let steepnesses = nodes("steepnesses", steepnesses)?;
        let mut values = Vec::new();
        for &height in &heights {
            // As a map refuses what no color may be.
            let row: Vec<_> = steepnesses.iter().map(|&steepness| color(height, steepness)).collect();
            ColorMap::gradient(steepnesses.iter().copied().zip(row.iter().copied()))?;
            values.extend(row.into_iter().flatten().map(f64::from));
        }
        let matrix = DMatrix::from_row_slice(heights.len(), 3 * steepnesses.len(), &values);
        let decomposed = matrix.clone().svd(true, true);
        let (Some(left), Some(right)) = (decomposed.u, decomposed.v_t) else {
            return Err(Error::Conflict("the decomposition of the colors did not converge".to_owned()));
        };
        let mut rest = matrix;
        let (mut terms, mut errors) = (Vec::new(), Vec::new());
        for (k, &size) in decomposed.singular_values.iter().enumerate().take(MOST) {
            let largest = left.column(k).amax().max(f64::MIN_POSITIVE);
            // Rounded to what colors need: equal weights are the same bits, and no bend is left between them.
            let weights: Vec<f32> = left
                .column(k)
                .iter()
                .map(|value| (value / largest / DIGIT).round() * DIGIT)
                .map(|v| v as f32)
                .collect();
            let row: Vec<f32> = right.row(k).iter().map(|value| (value * size * largest) as f32).collect();
            for (place, value) in rest.iter_mut().enumerate() {
                // Columns first.
                let (height, column) = (place % heights.len(), place / heights.len());
                *value -= f64::from(weights[height]) * f64::from(row[column]);
            }
            errors.push(rest.amax() as f32);
            let colors = row.chunks_exact(3).map(|color| [color[0], color[1], color[2]]).collect();
            terms.push(Term { weights, colors });
        }
        Ok(Self { heights, steepnesses, terms, errors })
    }

    /// The largest error of a channel with one product, with two, and so on up to four.
    pub fn errors(&self) -> &[f32] {
        &self.errors
    }

    /// The sum of as many products, of layers `NAME_high` and `NAME_steep_a` to `NAME_steep_d`: the error is that of
    /// [`Self::errors`] besides those of the layers.
    ///
    /// # Errors
    /// A name that cannot stand in a shader, and products other than 1 to those that there are.
    pub fn combination(&self, name: &str, products: usize) -> Result<Combination, Error> {
        let Some(terms) = self.terms.get(..products).filter(|terms| !terms.is_empty()) else {
            let (what, allowed) = (format!("the number of products of `{name}`"), format!("1 to {}", self.terms.len()));
            return Err(Error::Size { what, count: products, allowed });
        };
        // All weights are channels of one map, of one look at the heights.
        let weights = |node: usize| std::array::from_fn(|k| terms.get(k).map_or(0.0, |term| term.weights[node]));
        let stops = self.heights.iter().enumerate().map(|(node, &height)| (height, weights(node)));
        let high = Scene::new(&format!("{name}_high")).height(ColorMap::gradient::<4>(stops)?);
        let mut sum: Option<Combination> = None;
        for (k, (term, letter)) in terms.iter().zip(["a", "b", "c", "d"]).enumerate() {
            let map = ColorMap::gradient(self.steepnesses.iter().copied().zip(term.colors.iter().copied()))?;
            let steep = Scene::new(&format!("{name}_steep_{letter}")).steepness(map);
            let product = Combination::channel(&high, k)? * steep;
            sum = Some(sum.map_or(product.clone(), |sum| sum + product));
        }
        sum.ok_or_else(|| Error::Conflict(format!("`{name}` has no products")))
    }
}

/// Nodes that rise, enough and not too many.
fn nodes(what: &str, nodes: impl IntoIterator<Item = f32>) -> Result<Vec<f32>, Error> {
    let nodes: Vec<f32> = nodes.into_iter().collect();
    if !(2..=NODES).contains(&nodes.len()) {
        let (what, allowed) = (format!("the number of {what}"), format!("2 to {NODES}"));
        return Err(Error::Size { what, count: nodes.len(), allowed });
    }
    if let Some(&far) = nodes.iter().find(|node| node.abs() > MAX_COLOR) {
        return Err(Error::value(format!("a node of the {what}"), far, "a number from -65504 to 65504"));
    }
    // Written so that NaN is refused.
    match nodes.windows(2).position(|pair| !(pair[0] < pair[1])) {
        Some(at) => {
            Err(Error::value(format!("node {} of the {what}", at + 1), nodes[at + 1], format!("above {}", nodes[at])))
        }
        None => Ok(nodes),
    }
}
