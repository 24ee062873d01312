//! The distribution of visible slopes: D_s(s) = t⁺(s) p_s(s) / E[t⁺], with the normal distribution p_s of all slopes
//! and the weight t(s) = v.z − v.xy · s of the view v, 0 where it is negative.
//!
//! The weight is the area of a facet in the picture for a unit of area of the mean plane: a facet with the normal n ∝
//! (−s.x, −s.y, 1) has 1/n.z of the plane's area, of which n · v is seen. Equation 4 of Bruneton and Neyret 2012, "A
//! Survey of Nonlinear Prefiltering Methods for Efficient and Accurate Surface Shading", and equation 1 of Heitz et al.
//! 2014, whose dx is an element of the microsurface. A flat mesh that has only its normals from a map hides and
//! foreshortens nothing: its slopes are distributed as p_s, which is D_s seen along the normal.

pub mod standard;

use super::footprint::{axes, variance_along};
use super::normal::cumulative;
use super::quadrature::integrate;

/// Beyond this many deviations from where most of the weight is lies less than 1e-20 of it.
const FAR: f64 = 10.0;

/// The slopes of a rough surface as seen from a direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Visible {
    /// The unit vector towards the viewer, z up the macroscopic normal.
    pub view: [f64; 3],
    /// The covariance of all slopes: xx, xy, yy.
    pub covariance: [f64; 3],
    /// The mean of all slopes.
    pub mean: [f64; 2],
}

/// The integrals from `from` of functions of a standard normal variable times exp(offset) of its density without the
/// factor 1/√(2π). What is left out is below 1e-17 of the density's integral.
fn tail<const N: usize>(from: f64, offset: f64, function: impl Fn(f64) -> [f64; N]) -> [f64; N] {
    let from = from.max(-FAR);
    let to = (from.max(0.0).powi(2) + 90.0).sqrt();
    integrate(from, to, (to - from) / 14.0, |z| {
        let weight = (offset - 0.5 * z * z).exp();
        function(z).map(|value| value * weight)
    })
}

impl Visible {
    /// t of the mean slope.
    pub fn rise(&self) -> f64 {
        self.view[2] - self.view[0] * self.mean[0] - self.view[1] * self.mean[1]
    }

    /// The deviation of t over all slopes.
    pub fn reach(&self) -> f64 {
        variance_along(self.covariance, [self.view[0], self.view[1]]).max(0.0).sqrt()
    }

    /// How many deviations the mean of t is above 0; infinite where all slopes weigh the same.
    pub fn parameter(&self) -> f64 {
        self.rise() / self.reach()
    }

    /// The mean weight E[t⁺]: the area of the surface in the picture for a unit of area of the mean plane.
    pub fn area(&self) -> f64 {
        let [weight] = self.integrals(|_| [1.0]);
        let nearest = (-self.parameter()).max(0.0);
        weight * (-0.5 * nearest * nearest).exp() / std::f64::consts::TAU
    }

    /// The mean of a smooth function over the visible slopes, by quadrature over the principal axes of the covariance.
    /// NaN where nothing is visible.
    pub fn average<const N: usize>(&self, function: impl Fn([f64; 2]) -> [f64; N]) -> [f64; N] {
        let [whole] = self.integrals(|_| [1.0]);
        self.integrals(function).map(|sum| sum / whole)
    }

    /// The principal axes of the covariance, a deviation long each.
    fn ends(&self) -> [[f64; 2]; 2] {
        axes(self.covariance).map(|axis| {
            let deviation = variance_along(self.covariance, axis).max(0.0).sqrt();
            axis.map(|part| deviation * part)
        })
    }

    /// Two vectors whose outer products sum to the covariance, the first against the view, the second across it to the
    /// left: the principal axes, a deviation long, turned together.
    pub fn factor(&self) -> [f64; 4] {
        let (sin, cos) = libm::sincos(libm::atan2(self.view[1], self.view[0]));
        let [one, other] = self.ends();
        let [p, q] = [one, other].map(|end| cos * end[0] + sin * end[1]);
        let length = libm::hypot(p, q);
        let (p, q) = (-p / length, -q / length);
        let [e, f] = [[p, q], [-q, p]].map(|[p, q]| [0, 1].map(|i| p * one[i] + q * other[i]));
        let side = if cos * f[1] - sin * f[0] < 0.0 { -1.0 } else { 1.0 };
        [e[0], e[1], side * f[0], side * f[1]]
    }

    /// Integrals of functions times the weight and the density, but for a factor that the area puts back.
    fn integrals<const N: usize>(&self, function: impl Fn([f64; 2]) -> [f64; N]) -> [f64; N] {
        let ends = self.ends();
        let gains = ends.map(|end| -self.view[0] * end[0] - self.view[1] * end[1]);
        // The axis on which the weight ends sooner comes last: over the other one its end is smooth.
        let [first, last] = if gains[0].abs() > gains[1].abs() { [1, 0] } else { [0, 1] };
        let turn = if gains[last] < 0.0 { -1.0 } else { 1.0 };
        let (rise, reach) = (self.rise(), libm::hypot(gains[0], gains[1]));
        let nearest = if reach > 0.0 { (-rise / reach).max(0.0) } else { 0.0 };
        let center = if reach > 0.0 { nearest * gains[first] / reach } else { 0.0 };
        integrate(center - FAR, center + FAR, 1.25, |a| {
            let at = rise + gains[first] * a;
            let gain = turn * gains[last];
            let from = if gain > 0.0 { -at / gain } else { -FAR };
            tail(from, 0.5 * (nearest * nearest - a * a), |b| {
                let slope = [0, 1].map(|i| self.mean[i] + ends[first][i] * a + turn * ends[last][i] * b);
                let weight = (at + gain * b).max(0.0);
                function(slope).map(|value| weight * value)
            })
        })
    }

    /// Unit vectors along the view's azimuth and across, the deviation along, and how far a slope across follows one
    /// along and is deviated from that.
    fn frame(&self) -> ([[f64; 2]; 2], f64, f64, f64) {
        let azimuth = libm::atan2(self.view[1], self.view[0]);
        let (sin, cos) = libm::sincos(azimuth);
        let [xx, xy, yy] = self.covariance;
        let variance = variance_along(self.covariance, [cos, sin]).max(0.0);
        let both = (yy - xx) * sin * cos + xy * (cos * cos - sin * sin);
        let follows = if variance > 0.0 { both / variance } else { 0.0 };
        let across = variance_along(self.covariance, [-sin, cos]) - follows * both;
        ([[cos, sin], [-sin, cos]], variance.sqrt(), follows, across.max(0.0).sqrt())
    }

    /// Integrals along the view of functions times the weight and the density, but for a common factor. The functions
    /// are of the mean of the slopes with a component along the view, and of their deviation, which is across the view.
    ///
    /// `breaks` are components along the view between which the functions are smooth.
    fn along<const N: usize>(&self, breaks: &[f64], function: impl Fn([f64; 2], [f64; 2]) -> [f64; N]) -> [f64; N] {
        let ([d, aside], deviation, follows, rest) = self.frame();
        let (rise, reach) = (self.rise(), libm::hypot(self.view[0], self.view[1]) * deviation);
        let from = if reach > 0.0 { (-rise / reach).max(-FAR) } else { -FAR };
        let (to, offset) = ((from.max(0.0).powi(2) + 90.0).sqrt(), 0.5 * from.max(0.0).powi(2));
        let mean = d[0] * self.mean[0] + d[1] * self.mean[1];
        let mut ends: Vec<f64> = breaks.iter().map(|at| ((mean - at) / deviation).clamp(from, to)).collect();
        ends.extend([from, to]);
        ends.sort_by(f64::total_cmp);
        let across = aside.map(|part| part * rest);
        let mut sums = [0.0; N];
        for pair in ends.windows(2) {
            let width = ((to - from) / 14.0).min(0.2 * (pair[1] - pair[0]));
            let part = integrate(pair[0], pair[1], width, |u| {
                let place = [0, 1].map(|i| self.mean[i] - deviation * u * (d[i] + follows * aside[i]));
                let weight = (rise + reach * u).max(0.0) * (offset - 0.5 * u * u).exp();
                function(place, across).map(|value| weight * value)
            });
            for (sum, value) in sums.iter_mut().zip(part) {
                *sum += value;
            }
        }
        sums
    }

    /// The mean over the visible slopes of a polynomial of degree five or less: by quadrature along the view, and by
    /// the rule of Gauss and Hermite across, which is exact.
    pub fn average_along<const N: usize>(&self, function: impl Fn([f64; 2]) -> [f64; N]) -> [f64; N] {
        let [whole] = self.along(&[], |_, _| [1.0]);
        let sums = self.along(&[], |place, across| {
            let mut sum = [0.0; N];
            for (node, weight) in [(0.0, 2.0 / 3.0), (3f64.sqrt(), 1.0 / 6.0), (-3f64.sqrt(), 1.0 / 6.0)] {
                let values = function([0, 1].map(|i| place[i] + node * across[i]));
                for (sum, value) in sum.iter_mut().zip(values) {
                    *sum += weight * value;
                }
            }
            sum
        });
        sums.map(|sum| sum / whole)
    }

    /// The mean over the visible slopes of a function of slopes that may be steep: of the function's means over slopes
    /// with one component along the view, `place + w across` with w standard normal, which are smooth along the view
    /// where slopes deviate across it.
    pub fn lines<const N: usize>(&self, function: impl Fn([f64; 2], [f64; 2]) -> [f64; N]) -> [f64; N] {
        let ([d, _], deviation, _, _) = self.frame();
        let mean = d[0] * self.mean[0] + d[1] * self.mean[1];
        // The weight is smooth, the function may not be: three quarters of a deviation have five panels.
        let breaks: Vec<f64> = (-14..=14).map(|index| mean + 0.75 * f64::from(index) * deviation).collect();
        let [whole] = self.along(&breaks, |_, _| [1.0]);
        self.along(&breaks, function).map(|sum| sum / whole)
    }

    /// Mean and covariance of the visible slopes.
    pub fn moments(&self) -> ([f64; 2], [f64; 3]) {
        let mean = self.average_along(|slope| slope);
        let covariance = self.average_along(|slope| {
            let [x, y] = [slope[0] - mean[0], slope[1] - mean[1]];
            [x * x, x * y, y * y]
        });
        (mean, covariance)
    }

    /// Mean, deviation and skewness of the visible slopes' component along a unit vector.
    pub fn moments_along(&self, direction: [f64; 2]) -> [f64; 3] {
        let component = |slope: [f64; 2]| direction[0] * slope[0] + direction[1] * slope[1];
        let [mean] = self.average_along(|slope| [component(slope)]);
        let [second, third] = self.average_along(|slope| {
            let from = component(slope) - mean;
            [from * from, from * from * from]
        });
        [mean, second.sqrt(), third / second.powf(1.5)]
    }

    /// The mean over the visible slopes of a function of the mean and deviation along a vector of the slopes with one
    /// component along the view: by quadrature along the view, panel by panel between the edges where the function is
    /// steep for a small deviation.
    pub fn component<const N: usize>(
        &self,
        direction: [f64; 2],
        edges: &[f64],
        function: impl Fn(f64, f64) -> [f64; N],
    ) -> [f64; N] {
        let ([d, across], _, follows, rest) = self.frame();
        let [with, aside] = [d, across].map(|axis| axis[0] * direction[0] + axis[1] * direction[1]);
        let pace = with + follows * aside;
        let mean = direction[0] * self.mean[0] + direction[1] * self.mean[1];
        let start = d[0] * self.mean[0] + d[1] * self.mean[1];
        let wide = (FAR * rest * aside / pace).abs();
        let breaks = edges.iter().flat_map(|edge| {
            let middle = start + (edge - mean) / pace;
            [middle - wide, middle, middle + wide].map(|at| if at.is_finite() { at } else { start })
        });
        let breaks: Vec<f64> = breaks.collect();
        let [whole] = self.along(&breaks, |_, _| [1.0]);
        let sums = self.along(&breaks, |place, across| {
            let [at, deviation] = [place, across].map(|part| direction[0] * part[0] + direction[1] * part[1]);
            function(at, deviation.abs())
        });
        sums.map(|sum| sum / whole)
    }

    /// The probability that the component of a visible slope along a vector is below a threshold.
    pub fn below(&self, direction: [f64; 2], threshold: f64) -> f64 {
        let [probability] = self.component(direction, &[threshold], |mean, deviation| {
            let from = threshold - mean;
            [if deviation > 0.0 { cumulative(from / deviation) } else { f64::from(u8::from(from > 0.0)) }]
        });
        probability
    }
}
