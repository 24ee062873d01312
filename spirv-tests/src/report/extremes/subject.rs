//! A filter with a map: its scene, and the positions where it is hard.

use prefilter::{HeightTransfer, Scene};

use super::filters::{curve, Filter, Map, DISC, LAYERS};
use super::points::Place;

/// A filter with a map.
#[derive(Clone, Debug)]
pub struct Subject {
    /// The filter.
    pub filter: Filter,
    /// Its scene.
    pub scene: Scene,
    /// The curve, where heights are transferred.
    pub curve: HeightTransfer,
    /// The layers of a combination.
    pub layers: Vec<Self>,
}

impl Subject {
    /// The filter with a map.
    ///
    /// # Errors
    /// Those of maps.
    pub fn new(filter: Filter, map: Map) -> Result<Self, Box<dyn std::error::Error + Send + Sync>> {
        let below = if filter == Filter::Combination { &LAYERS[..] } else { &[] };
        let layers = below.iter().map(|layer| Self::new(*layer, map)).collect::<Result<_, _>>()?;
        Ok(Self { filter, scene: filter.scene(map)?, curve: curve()?, layers })
    }

    /// The positions of the map, of a combination that of its first layer.
    pub fn place(&self) -> Place {
        let of_slopes = Place { low: -0.8, width: 1.6, edges: vec![f64::from(DISC)] };
        let map = self.scene.map().or_else(|| self.layers.first().and_then(|layer| layer.scene.map()));
        let Some(map) = map else { return of_slopes };
        let all = || map.knots().iter().map(|knot| f64::from(knot.position));
        let (low, high) = all().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), at| (low.min(at), high.max(at)));
        let hard = map.knots().iter().filter(|knot| knot.left != knot.right).map(|knot| f64::from(knot.position));
        let mut edges: Vec<f64> = hard.collect();
        if edges.is_empty() {
            edges = all().collect();
        }
        Place { low, width: (high - low).max(0.1), edges }
    }

    /// The smallest and the largest result of every channel, and how far rounding of halves may leave that.
    pub fn hull(&self) -> ([f64; 4], [f64; 4], f64) {
        let wide = |(low, high): ([f32; 4], [f32; 4])| (low.map(f64::from), high.map(f64::from), HALVES);
        match self.filter {
            Filter::Irradiance => ([0.0; 4], [f64::MAX; 4], 0.0),
            Filter::Visibility => ([0.0; 4], [1.0; 4], 0.0),
            // Colors are in [0, 1], and so are products of them.
            Filter::Combination => ([0.0; 4], [1.0; 4], HALVES),
            _ => match (self.scene.map(), self.scene.map_of_slopes()) {
                (Some(map), _) => wide(map.hull()),
                (None, Some(map)) => wide(map.hull()),
                (None, None) => ([0.0; 4], [1.0; 4], 0.0),
            },
        }
    }
}

/// Eleven bits of colors up to 1.
const HALVES: f64 = 5e-4;
