//! What filters ought to return, by quadratures in f64.

use prefilter::reference::footprint::variance_along;
use prefilter::reference::slope_nodes::{Along as Towards, Transferred};
use prefilter::reference::slopes::Visible;
use prefilter::reference::smith::{self, Along};
use prefilter::reference::texture::PiecewiseLinear;
use prefilter::reference::{height, irradiance, percentile, slope, steepness, texture, visibility};

use super::covers::Covers;
use super::filters::Filter;
use super::points::{Point, FRAME};
use super::subject::Subject;
use crate::environments::GRACE;

/// Deviations that are less count as this.
const LEAST: f64 = 1e-6f32 as f64;

/// Sums of Λ that are more count as this.
const MOST: f64 = 1e6;

/// Parts of a deviation of transferred values: steps between their heights are some 1e-3 of the colors.
const PARTS: usize = 16;

/// The lowest parameter of visible slopes that filters tell from lower ones.
const LOWEST: f64 = -12.0;

impl Point {
    /// The slopes as the view sees them.
    pub(super) fn visible(&self) -> Visible {
        Visible { view: self.view, covariance: self.covariance, mean: self.mean_slope }
    }

    /// Whether all slopes are the mean slope.
    fn flat(&self) -> bool {
        self.covariance[0] + self.covariance[2] < 1e-30
    }

    /// Whether some of the slopes are seen, and not only those that filters take for the lowest.
    fn seen(&self) -> bool {
        let visible = self.visible();
        visible.rise() > 0.0 || (visible.reach() > 0.0 && visible.parameter() > LOWEST)
    }

    /// Smith's Λ of a direction over slopes without a mean: infinite at and below the horizon.
    pub(super) fn lambda(&self, direction: [f64; 3]) -> f64 {
        match Along::new(direction, self.covariance, [0.0; 2]).parameter() {
            parameter if parameter > 10.0 => 0.0,
            parameter if parameter > 0.0 => smith::lambda(parameter),
            // Written so that a quotient of two zeros is at the horizon.
            _ => f64::INFINITY,
        }
    }

    /// That of view and light.
    pub(super) fn lambdas(&self) -> f64 {
        (self.lambda(self.view) + self.lambda(self.light)).min(MOST)
    }

    /// The deviation of the slopes' component.
    pub(super) fn component_deviation(&self) -> f64 {
        variance_along(self.covariance, self.direction).max(0.0).sqrt()
    }

    /// The component of the mean slope.
    pub(super) fn component(&self) -> f64 {
        self.direction[0] * self.mean_slope[0] + self.direction[1] * self.mean_slope[1]
    }
}

impl Subject {
    /// What the filter ought to return at a point, and nothing where nothing is seen: any color of the map will do.
    pub fn truth(&self, point: &Point) -> Option<[f64; 4]> {
        let point = &point.nearest()?;
        let map = || self.scene.map().map(|map| map.reference());
        let whole = || self.scene.map_of_slopes().map(|map| map.reference());
        let deviation = point.deviation.clamp(LEAST, self.scene.chosen_ranges().deviation.into());
        let visible = point.visible();
        let sloped = matches!(self.filter, Filter::Slope | Filter::SlopeMap | Filter::Steepness | Filter::Irradiance);
        // What is not seen has no color.
        let hidden = matches!(self.filter, Filter::Height | Filter::HeightPercentile) && point.lambdas() >= MOST;
        if (sloped && !point.seen()) || hidden {
            return None;
        }
        match self.filter {
            Filter::Texture => Some(texture::mean(&map()?, point.mean, deviation)),
            Filter::Height => Some(height::mean(&map()?, point.mean, deviation, point.lambdas())),
            Filter::Visibility => Some([lit(point), 0.0, 0.0, 0.0]),
            Filter::HeightPercentile => Some(percentile::mean(&map()?, point.lambdas())),
            Filter::Slope if point.flat() => Some(map()?.value(point.component())),
            Filter::Slope => Some(slope::mean(&map()?, &visible, point.direction)),
            Filter::SlopeMap if point.flat() => Some(whole()?.value(point.mean_slope)),
            Filter::SlopeMap => Some(whole()?.mean_visible(&visible)),
            Filter::Steepness => Some(steep(&map()?, point)),
            Filter::Irradiance => Some(light(point)),
            Filter::Combination => {
                let [value, steep, high] = &self.layers[..] else { return None };
                let (value, steep, high) = (value.truth(point)?, steep.truth(point)?, high.truth(point)?);
                Some([0, 1, 2, 3].map(|channel| value[channel] * steep[channel] * (1.0 - high[channel])))
            }
            Filter::HeightTransfer => self.transferred(point, MOST),
        }
    }

    /// The truth of heights where larger Λ of view and light together count as the largest that is covered, and larger
    /// deviations of what a curve takes as well.
    pub(super) fn hidden(&self, point: &Point, covers: &Covers) -> Option<[f64; 4]> {
        let ([_, most], [_, widest]) = (covers.lambdas, covers.deviations);
        if self.filter == Filter::HeightTransfer {
            return self.transferred(&Point { deviation: point.deviation.min(widest), ..*point }, most);
        }
        self.truth(point)?;
        let deviation = point.deviation.clamp(LEAST, self.scene.chosen_ranges().deviation.into());
        Some(height::mean(&self.scene.map()?.reference(), point.mean, deviation, point.lambdas().min(most)))
    }

    /// The truth of slopes where components that deviate more than is covered are drawn together about the middle of
    /// the map until they deviate by that: of a map that is drawn apart instead.
    pub(super) fn narrowed(&self, point: &Point, covers: &Covers) -> Option<[f64; 4]> {
        let ([_, most], deviation) = (covers.deviations, point.component_deviation());
        if deviation <= most || !point.seen() {
            return self.truth(point);
        }
        let mut map = self.scene.map()?.reference();
        let middle = 0.5 * (map.knots.first()?.0 + map.knots.last()?.0);
        map.knots.iter_mut().for_each(|knot| knot.0 = middle + (knot.0 - middle) * deviation / most);
        Some(slope::mean(&map, &point.visible(), point.direction))
    }

    /// The color of transferred heights that both directions reach, up to a sum of both Λ; nothing from below.
    fn transferred(&self, point: &Point, most: f64) -> Option<[f64; 4]> {
        let (map, curve, values) = (self.scene.map()?.reference(), &self.curve, [point.mean, point.deviation]);
        let surface = Transferred::in_parts(PARTS, values, &curve.bends(), |f| curve.height(f), |f| curve.slope(f));
        let lambda = |[x, y, z]: [f64; 3]| {
            let length = x.hypot(y);
            let toward = if length > 0.0 { [x / length, y / length] } else { [1.0, 0.0] };
            let deviation = variance_along(point.covariance, toward).max(0.0).sqrt();
            let along = Towards { angle: length.atan2(z), mean: 0.0, deviation };
            (z > 0.0).then(|| if deviation < 1e-15 { 0.0 } else { surface.lambda(along) })
        };
        let lambda = (lambda(point.view)? + lambda(point.light)?).min(most);
        let mut color = [0.0; 4];
        for (part, share) in surface.parts.iter().zip(surface.visible_heights(lambda)) {
            color.iter_mut().zip(map.value(part.height)).for_each(|(sum, channel)| *sum += share * channel);
        }
        Some(color)
    }
}

/// The mean over lengths of slopes. Where slopes are some hundreds of deviations long, their length is the component
/// along the mean slope, but for a 400th of a deviation. What lies on a line gets a width of 0.003 deviations, for the
/// quadrature across it.
fn steep(map: &PiecewiseLinear, point: &Point) -> [f64; 4] {
    let visible = point.visible();
    let ([x, y], [xx, xy, yy]) = (point.mean_slope, point.covariance);
    let (length, whole) = (x.hypot(y), xx + yy);
    if whole < 1e-12 && length < 100.0 * whole.sqrt() || point.flat() {
        map.value(length)
    } else if whole.sqrt() < 5e-3 * length {
        slope::mean(map, &visible, [x / length, y / length])
    } else if xx * yy - xy * xy < 1e-5 * whole * whole {
        let wider = 1e-5 * whole;
        steepness::mean(map, &Visible { covariance: [xx + wider, xy, yy + wider], ..visible })
    } else {
        steepness::mean(map, &visible)
    }
}

/// The share of the seen points that are lit: none from below, whoever looks.
fn lit(point: &Point) -> f64 {
    let [view, light] = [point.view, point.light].map(|direction| point.lambda(direction));
    if view.is_finite() && light.is_finite() {
        visibility::shadowing(view.min(MOST), light.min(MOST))
    } else {
        0.0
    }
}

/// Irradiance by channel, where rounds of order 2 are not below 0.
fn light(point: &Point) -> [f64; 4] {
    let mut sum = [0.0; 4];
    for (channel, sum) in sum.iter_mut().take(3).enumerate() {
        let radiance = GRACE.map(|color| f64::from(color[channel]));
        *sum = if point.flat() {
            let [x, y] = point.mean_slope;
            let length = (1.0 + x * x + y * y).sqrt();
            let normal = [-x / length, -y / length, 1.0 / length];
            let turned = [0, 1, 2].map(|part| (0..3).map(|axis| normal[axis] * FRAME[axis][part]).sum());
            irradiance::from_radiance(radiance, turned)
        } else {
            irradiance::over(&point.visible(), radiance, FRAME)
        };
        *sum = sum.max(0.0);
    }
    sum
}
