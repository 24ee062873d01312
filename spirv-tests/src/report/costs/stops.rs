//! Closed forms against tables by the stops of a map, and constant maps against dynamic ones.

use super::kernels::times;
use crate::maps::random;
use crate::report::document::{Axis, Cell, Item, Plot, Series, Table};
use crate::report::{Bench, Error};
use prefilter::{ColorMap, Colors, HeightTier, Kernel, Module, Ranges, Scene, SlopeTier, Tier};

/// Two for each study.
pub const STEPS: u64 = 2 * STUDIES.len() as u64;

/// Stops of the maps.
const STOPS: [usize; 8] = [2, 4, 6, 8, 12, 16, 24, 32];

const FAST: Tier = Tier::ClosedForm(Kernel::Fast);
const EXACT: Tier = Tier::ClosedForm(Kernel::Exact);

/// A way to filter a map.
type Method = (&'static str, fn(ColorMap) -> Scene);

/// Ways that are compared; the first is a closed form and the second a table.
struct Study {
    stem: &'static str,
    what: &'static str,
    hard: bool,
    methods: &'static [Method],
}

const VALUES: [Method; 6] = [
    ("closed form, fast", |map| values(map).tier(FAST)),
    ("table, constant", |map| values(map).tier(Tier::Table)),
    ("closed form, exact", |map| values(map).tier(EXACT)),
    ("closed form, dynamic", |map| values(map).tier(EXACT).colors(Colors::Dynamic)),
    ("table, dynamic", |map| values(map).tier(Tier::Table).colors(Colors::Dynamic)),
    ("the paper's table", |map| values(map).tier(Tier::Paper)),
];

const HEIGHTS: [Method; 6] = [
    ("closed form, fast", |map| heights(map).height_tier(HeightTier::ClosedFormFast)),
    ("closed form", |map| heights(map).height_tier(HeightTier::ClosedForm)),
    ("table over skewness", |map| heights(map).height_tier(HeightTier::Skewed)),
    ("one Gaussian, fast", |map| heights(map).height_tier(HeightTier::Gaussian).tier(FAST)),
    ("one Gaussian, table", |map| heights(map).height_tier(HeightTier::Gaussian).tier(Tier::Table)),
    ("closed form, dynamic", |map| heights(map).height_tier(HeightTier::ClosedForm).colors(Colors::Dynamic)),
];

const SLOPES: [Method; 4] = [
    ("two Gaussians, fast", |map| slopes(map).slope_tier(SlopeTier::Pair).tier(FAST)),
    ("two Gaussians, table", |map| slopes(map).slope_tier(SlopeTier::Pair).tier(Tier::Table)),
    ("one Gaussian, fast", |map| slopes(map).slope_tier(SlopeTier::Gaussian).tier(FAST)),
    ("one Gaussian, table", |map| slopes(map).slope_tier(SlopeTier::Gaussian).tier(Tier::Table)),
];

const STUDIES: [Study; 4] = [
    Study { stem: "values", what: "values, smooth maps", hard: false, methods: &VALUES },
    Study { stem: "edges", what: "values, maps with hard edges", hard: true, methods: &VALUES },
    Study { stem: "heights", what: "heights, smooth maps", hard: false, methods: &HEIGHTS },
    Study { stem: "slopes", what: "slopes, smooth maps", hard: false, methods: &SLOPES },
];

fn values(map: ColorMap) -> Scene {
    Scene::new("judged").texture(map)
}

fn heights(map: ColorMap) -> Scene {
    Scene::new("judged").height(map)
}

fn slopes(map: ColorMap) -> Scene {
    Scene::new("judged").slope(map).ranges(Ranges::default())
}

/// Every study: its times and its curves, and where they cross.
pub fn items(bench: &Bench<'_>) -> Result<Vec<Item>, Error> {
    let mut items = Vec::new();
    for study in STUDIES {
        let stops: Vec<usize> = STOPS.into_iter().step_by(bench.extent.pick(3, 1)).collect();
        items.extend(study.items(bench, &stops)?);
    }
    Ok(items)
}

/// A method with one number of stops.
struct Point {
    stops: usize,
    time: f64,
    weight: usize,
}

impl Study {
    fn items(&self, bench: &Bench<'_>, stops: &[usize]) -> Result<Vec<Item>, Error> {
        let mut modules: Vec<Module> = Vec::new();
        for (_, scene) in self.methods {
            for &count in stops {
                modules.push(scene(random(count, self.hard, 7 + count as u32)?).module()?);
            }
        }
        let times = times(bench, &modules)?;
        let points = |at: usize| -> Vec<Point> {
            let of = |(index, &stops): (usize, &usize)| {
                let number = at * stops_of(&modules, self.methods.len()) + index;
                Point { stops, time: times[number], weight: modules[number].cost().weight() }
            };
            stops.iter().enumerate().map(of).collect()
        };
        let curves: Vec<Vec<Point>> = (0..self.methods.len()).map(points).collect();
        Ok(vec![Item::Table(self.table(&curves)), Item::Plot(self.plot(&curves)), Item::Text(self.crossing(&curves))])
    }

    fn table(&self, curves: &[Vec<Point>]) -> Table {
        let mut columns = vec!["stops".to_owned()];
        for (label, _) in self.methods {
            columns.extend([format!("{label}, ms a megapixel"), "weight".to_owned()]);
        }
        let row = |at: usize| -> Vec<Cell> {
            let of = |curve: &Vec<Point>| [Cell::Number(curve[at].time), Cell::from(curve[at].weight)];
            [Cell::from(curves[0][at].stops)].into_iter().chain(curves.iter().flat_map(of)).collect()
        };
        let rows = (0..curves[0].len()).map(row).collect();
        Table {
            stem: format!("costs_{}_times", self.stem),
            caption: format!("Time and weight by the stops of a map: {}.", self.what),
            columns,
            rows,
        }
    }

    fn plot(&self, curves: &[Vec<Point>]) -> Plot {
        let series = self.methods.iter().zip(curves).map(|((label, _), curve)| Series {
            label: (*label).to_owned(),
            points: curve.iter().map(|point| [point.stops as f64, point.time]).collect(),
            joined: true,
        });
        Plot {
            stem: format!("costs_{}", self.stem),
            caption: format!("Time by the stops of a map: {}.", self.what),
            x: Axis { label: "stops".to_owned(), logarithmic: false },
            y: Axis { label: "milliseconds a megapixel".to_owned(), logarithmic: false },
            series: series.collect(),
        }
    }

    /// Where the first two methods cost as much as each other.
    fn crossing(&self, curves: &[Vec<Point>]) -> String {
        let apart = |of: &dyn Fn(&Point) -> f64| -> Vec<[f64; 2]> {
            let pairs = curves[0].iter().zip(&curves[1]);
            pairs.map(|(one, other)| [one.stops as f64, of(one) - of(other)]).collect()
        };
        let [measured, weighed] =
            [apart(&|point| point.time), apart(&|point| point.weight as f64)].map(|apart| told(crossed(&apart)));
        let [(one, _), (other, _)] = [self.methods[0], self.methods[1]];
        format!("Of {}, `{one}` costs as much as `{other}` {measured}; by weight {weighed}.", self.what)
    }
}

/// Modules a method.
fn stops_of(modules: &[Module], methods: usize) -> usize {
    modules.len() / methods
}

/// Where a difference that rises passes 0: `Err` beyond which stops it does not.
fn crossed(apart: &[[f64; 2]]) -> Result<f64, [f64; 2]> {
    let ends = [apart[0][0], apart[apart.len() - 1][0]];
    let pair = apart.windows(2).find(|pair| pair[0][1] <= 0.0 && pair[1][1] > 0.0);
    match pair {
        Some(pair) => {
            let [[from, below], [to, above]] = [pair[0], pair[1]];
            Ok(from + (to - from) * below / (below - above))
        }
        None if apart[0][1] > 0.0 => Err([0.0, ends[0]]),
        None => Err([ends[1], f64::INFINITY]),
    }
}

fn told(crossing: Result<f64, [f64; 2]>) -> String {
    match crossing {
        Ok(stops) => format!("at {stops:.1} stops"),
        Err([0.0, _]) => "at fewer stops than were measured".to_owned(),
        Err([from, _]) => format!("at more than {from} stops"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn crossings_are_between_the_measured() {
        assert_eq!(crossed(&[[2.0, -3.0], [4.0, 1.0], [6.0, 5.0]]), Ok(3.5));
        assert_eq!(crossed(&[[2.0, 1.0], [4.0, 2.0]]), Err([0.0, 2.0]));
        assert_eq!(crossed(&[[2.0, -2.0], [4.0, -1.0]]), Err([4.0, f64::INFINITY]));
    }
}
