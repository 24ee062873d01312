//! The integrals that filters approximate, in f64.

use prefilter::reference::beta::Beta;
use prefilter::reference::normals::average;
use prefilter::reference::slope_map::Bilinear;
use prefilter::reference::slope_nodes::{Along as Angle, Transferred};
use prefilter::reference::smith::Along;
use prefilter::reference::texture::PiecewiseLinear;
use prefilter::reference::{height, irradiance, percentile, slope, steepness, texture};
use prefilter::HeightTransfer;

use super::pixel::Pixel;

/// What a color is the mean of.
#[derive(Clone, Debug)]
pub enum Truth {
    /// A map over normal values.
    Values(PiecewiseLinear),
    /// A map over values of a Beta distribution between two ends.
    Bounded(PiecewiseLinear, [f64; 2]),
    /// A map over the heights that are seen, and lit where there are shadows.
    Heights(PiecewiseLinear, bool),
    /// The same by percentiles.
    Percentiles(PiecewiseLinear, bool),
    /// A map over a component of the slopes that are seen.
    Component(PiecewiseLinear),
    /// A map over their lengths.
    Length(PiecewiseLinear),
    /// A map over the slopes themselves.
    Slopes(Bilinear),
    /// An environment's irradiance, by radiance by order and degree.
    Normals([[f64; 3]; 9]),
    /// The product of the first two channel by channel, plus what the first lacks of one times the third.
    Mixed(Box<[Truth; 3]>),
    /// Bands over the heights that a curve makes, seen and lit.
    Raised(PiecewiseLinear, HeightTransfer),
    /// Bands over the slopes of such heights along the view.
    Steepened(PiecewiseLinear, HeightTransfer),
}

/// How far hiding follows the steepness in what is seen of slopes: the notes of `wgsl/visibility/slope_nodes.wgsl`.
const FOLLOWS: f64 = 0.25;

/// Λ of the view, and with shadows of view and light, by the quadrature over slopes.
pub fn lambda(pixel: &Pixel, shadows: bool) -> f64 {
    let of = |direction| Along::new(direction, pixel.visible.covariance, [0.0; 2]).lambda();
    of(pixel.visible.view) + if shadows { of(pixel.light) } else { 0.0 }
}

impl Truth {
    /// The color of a pixel.
    pub fn color(&self, pixel: &Pixel) -> [f64; 4] {
        let Pixel { mean, deviation, visible, .. } = pixel;
        match self {
            Self::Values(map) => texture::mean(map, *mean, *deviation),
            Self::Bounded(map, ends) => Beta::new(*ends, *mean, *deviation).mean(map),
            Self::Heights(map, shadows) => height::mean(map, *mean, *deviation, lambda(pixel, *shadows)),
            Self::Percentiles(map, shadows) => percentile::mean(map, lambda(pixel, *shadows)),
            Self::Component(map) => slope::mean(map, visible, pixel.direction),
            Self::Length(map) => steepness::mean(map, visible),
            Self::Slopes(map) => map.mean_visible(visible),
            Self::Normals(radiance) => lit(radiance, pixel),
            Self::Mixed(parts) => {
                let [part, one, other] = parts.each_ref().map(|part| part.color(pixel));
                std::array::from_fn(|at| part[at] * one[at] + (1.0 - part[at]) * other[at])
            }
            Self::Raised(map, curve) => raised(map, curve, pixel),
            Self::Steepened(map, curve) => steepened(map, curve, pixel),
        }
    }
}

/// Irradiance is radiance with each order scaled by π, 2π/3 and π/4: Ramamoorthi and Hanrahan 2001, equation 8.
fn lit(radiance: &[[f64; 3]; 9], pixel: &Pixel) -> [f64; 4] {
    let [x, y, z] = pixel.frame;
    let means = average(&pixel.visible, |[sx, sy]| {
        let length = (1.0 + sx * sx + sy * sy).sqrt();
        irradiance::harmonics([0, 1, 2].map(|axis| (z[axis] - sx * x[axis] - sy * y[axis]) / length))
    });
    let scales = [1.0, 2.0 / 3.0, 0.25].map(|scale| scale * std::f64::consts::PI);
    let mut color = [0.0; 4];
    for (term, mean) in means.into_iter().enumerate() {
        let scaled = scales[[0, 1, 1, 1, 2, 2, 2, 2, 2][term]] * mean;
        color.iter_mut().zip(radiance[term]).for_each(|(sum, channel)| *sum += scaled * channel);
    }
    // Order 2 of a sun rings below 0, where no light is.
    color.map(|channel| channel.max(0.0))
}

fn surface(curve: &HeightTransfer, pixel: &Pixel) -> Transferred {
    Transferred::new([pixel.mean, pixel.deviation], &curve.bends(), |f| curve.height(f), |f| curve.slope(f))
}

/// The angle of a direction from the normal, over slopes along x.
fn angle(direction: [f64; 3], pixel: &Pixel) -> Angle {
    let [x, _, z] = direction;
    Angle { angle: libm::atan2(x, z).abs(), mean: pixel.visible.mean[0], deviation: pixel.visible.covariance[0].sqrt() }
}

fn raised(map: &PiecewiseLinear, curve: &HeightTransfer, pixel: &Pixel) -> [f64; 4] {
    let surface = surface(curve, pixel);
    let lambda = [pixel.visible.view, pixel.light].map(|direction| surface.lambda(angle(direction, pixel)));
    let mut color = [0.0; 4];
    for (part, share) in surface.parts.iter().zip(surface.visible_heights(lambda[0] + lambda[1])) {
        color.iter_mut().zip(map.value(part.height)).for_each(|(sum, channel)| *sum += share * channel);
    }
    color
}

fn steepened(map: &PiecewiseLinear, curve: &HeightTransfer, pixel: &Pixel) -> [f64; 4] {
    let (surface, along) = (surface(curve, pixel), angle(pixel.visible.view, pixel));
    let shares = surface.shares(along, surface.lambda(along), FOLLOWS);
    let edges: Vec<f64> = map.knots.iter().map(|knot| knot.0).collect();
    let below = surface.below(along, &shares, &edges);
    let mut color = map.knots.first().map_or([0.0; 4], |knot| knot.1);
    for (knot, below) in map.knots.iter().zip(below) {
        for (channel, sum) in color.iter_mut().enumerate() {
            *sum += (1.0 - below) * (knot.2[channel] - knot.1[channel]);
        }
    }
    color
}
