//! Cs of a map of the whole slope: its mean over normal distributions of slopes and over visible slopes, by quadrature
//! of the map itself.

use super::normal::{cumulative, density};
use super::quadrature::integrate;
use super::slopes::Visible;

/// Beyond this many deviations lies less than 3e-12 of a distribution, and panels of so many leave as little.
const FAR: f64 = 7.0;
const PANEL: f64 = 3.0;

/// A map that is bilinear between the nodes of a square grid of slopes and constant along either component beyond it.
#[derive(Clone, Debug, PartialEq)]
pub struct Bilinear {
    /// The components of the nodes, rising, the same along x and y.
    pub nodes: Vec<f64>,
    /// The colors at the nodes, row by row from the lowest y, each from the lowest x.
    pub colors: Vec<[f64; 4]>,
}

impl Bilinear {
    /// The node at or below a component, and the part of the way to the next.
    fn cell(&self, component: f64) -> (usize, f64) {
        let above = self.nodes.partition_point(|&node| node <= component);
        match above {
            0 => (0, 0.0),
            above if above == self.nodes.len() => (above - 1, 0.0),
            above => {
                let [low, high] = [self.nodes[above - 1], self.nodes[above]];
                (above - 1, (component - low) / (high - low))
            }
        }
    }

    /// The color of a slope.
    pub fn value(&self, slope: [f64; 2]) -> [f64; 4] {
        let [(i, x), (j, y)] = slope.map(|component| self.cell(component));
        let (size, last) = (self.nodes.len(), self.nodes.len() - 1);
        let at = |i: usize, j: usize| self.colors[j.min(last) * size + i.min(last)];
        let corners = [at(i, j), at(i + 1, j), at(i, j + 1), at(i + 1, j + 1)];
        std::array::from_fn(|channel| {
            let [a, b, c, d] = corners.map(|color| color[channel]);
            (1.0 - y) * ((1.0 - x) * a + x * b) + y * ((1.0 - x) * c + x * d)
        })
    }

    /// The mean over the slopes `place + w across`, w standard normal: panel by panel between the lines of nodes.
    /// Beyond the last line on either side the color is that on the line.
    fn across(&self, place: [f64; 2], across: [f64; 2]) -> [f64; 4] {
        let at = |w: f64| self.value([0, 1].map(|axis| place[axis] + w * across[axis]));
        let lines = [0, 1].into_iter().flat_map(|axis| self.nodes.iter().map(move |node| (axis, node)));
        let crossed = lines.map(|(axis, node)| (node - place[axis]) / across[axis]);
        let mut ends: Vec<f64> = crossed.filter(|at| at.is_finite()).collect();
        ends.sort_by(f64::total_cmp);
        let (Some(&first), Some(&last)) = (ends.first(), ends.last()) else { return at(0.0) };
        let outside = [(cumulative(first), at(first)), (cumulative(-last), at(last))];
        let mut sum = std::array::from_fn(|channel| outside.iter().map(|(part, color)| part * color[channel]).sum());
        for pair in ends.windows(2) {
            let [from, to] = [0, 1].map(|end| pair[end].clamp(-FAR, FAR));
            let part: [f64; 4] = integrate(from, to, PANEL, |w| at(w).map(|channel| density(w) * channel));
            add(&mut sum, part);
        }
        sum
    }

    /// The mean over a normal distribution of slopes: over y given x, and over x between nodes.
    pub fn mean(&self, mean: [f64; 2], covariance: [f64; 3]) -> [f64; 4] {
        let [xx, xy, yy] = covariance;
        let deviation = xx.max(0.0).sqrt();
        if deviation == 0.0 {
            return self.across(mean, [0.0, yy.max(0.0).sqrt()]);
        }
        let rest = (yy - xy * xy / xx).max(0.0).sqrt();
        let crossed = self.nodes.iter().map(|node| (node - mean[0]) / deviation);
        let mut ends: Vec<f64> = crossed.filter(|at| at.abs() < FAR).collect();
        ends.extend([-FAR, FAR]);
        ends.sort_by(f64::total_cmp);
        let mut sum = [0.0; 4];
        for pair in ends.windows(2) {
            let part: [f64; 4] = integrate(pair[0], pair[1], PANEL, |u| {
                let place = [mean[0] + u * deviation, mean[1] + u * xy / deviation];
                self.across(place, [0.0, rest]).map(|channel| density(u) * channel)
            });
            add(&mut sum, part);
        }
        sum
    }

    /// The mean over visible slopes: across the view along lines, whose means are averaged along the view.
    pub fn mean_visible(&self, visible: &Visible) -> [f64; 4] {
        visible.lines(|place, across| self.across(place, across))
    }
}

fn add(sum: &mut [f64; 4], part: [f64; 4]) {
    for (total, value) in sum.iter_mut().zip(part) {
        *total += value;
    }
}
