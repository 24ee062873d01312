//! What a Gaussian footprint retains of noise on a lattice, and what a point of the noise tells of the footprint: by
//! quadrature of the noise's autocorrelation, which is that of its kernel.

use std::sync::OnceLock;

use super::lattice::weight;
use super::quadrature::integrate;
use super::simplex::part;

/// The noise.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Noise {
    /// Lines on a square lattice.
    Perlin,
    /// Values on a square lattice.
    Value,
    /// Lines on a lattice of triangles.
    Simplex,
    /// Lines on a cubic lattice, cut by a plane through it.
    PerlinSolid,
}

/// Means over normal offsets between two points: of the autocorrelation, and of the square of its gradient.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Means {
    correlation: f64,
    gradient: f64,
}

impl Noise {
    /// The share of the power that a footprint with these deviations along two axes of the lattice retains.
    ///
    /// The filtered noise has the variance E R(x − y), x and y being of the footprint.
    pub fn retained(self, deviations: [f64; 2]) -> f64 {
        self.means(deviations.map(|deviation| 2f64.sqrt() * deviation)).correlation
    }

    /// The variance of the derivative along an axis over that of the noise: −R″(0).
    pub fn slopes(self) -> f64 {
        match self {
            Self::Perlin => 0.5 * (axes().curvatures[0] + axes().curvatures[1]),
            Self::PerlinSolid => (2.0 * axes().curvatures[0] + axes().curvatures[1]) / 3.0,
            Self::Value => axes().curvatures[0],
            Self::Simplex => kernel().curvature,
        }
    }

    /// What a point tells of a footprint around it: (multiplier, coupling, rest).
    ///
    /// Given the noise n and its gradient g there, a Gaussian process has the mean R(x) n + m(x)·g at an offset x, m
    /// being −∇R/λ, and the footprint's mean is E R n. Around that the expected square is λ V E|m|² and the rest, where
    /// the part E (m·g)² is taken to be as round as the footprint: coupling² times the mean of (x·g)².
    pub fn filter(self, deviations: [f64; 2]) -> [f64; 3] {
        let Means { correlation, gradient } = self.means(deviations);
        let share = gradient / self.slopes();
        let trace = deviations[0] * deviations[0] + deviations[1] * deviations[1];
        [correlation, (share / (self.slopes() * trace)).sqrt(), 1.0 - correlation * correlation - share]
    }

    fn means(self, [x, y]: [f64; 2]) -> Means {
        if self == Self::Simplex {
            return kernel().means([x, y]);
        }
        let [x, y] = [x, y].map(|deviation| axes().means(deviation));
        if self == Self::Value {
            return Means { correlation: x.a * y.a, gradient: x.steep_aa * y.aa + x.aa * y.steep_aa };
        }
        if self == Self::PerlinSolid {
            // R = ⅓ (B A + A B + A A), and its derivatives likewise.
            let along = |x: Averages, y: Averages| {
                let squares = x.steep_bb * y.aa + x.steep_aa * y.bb + x.steep_aa * y.aa;
                squares + 2.0 * (x.steep_ab * y.ab + x.steep_ab * y.aa + x.steep_aa * y.ab)
            };
            let correlation = (x.b * y.a + x.a * y.b + x.a * y.a) / 3.0;
            return Means { correlation, gradient: (along(x, y) + along(y, x)) / 9.0 };
        }
        // R = ½ (B A + A B), and its derivatives likewise.
        let along = |x: Averages, y: Averages| x.steep_bb * y.aa + 2.0 * x.steep_ab * y.ab + x.steep_aa * y.bb;
        Means { correlation: 0.5 * (x.b * y.a + x.a * y.b), gradient: 0.25 * (along(x, y) + along(y, x)) }
    }
}

/// Means over a normal distribution along one axis: of the correlations A of weights and B of weighted lines, of their
/// products and of those of their derivatives.
#[derive(Clone, Copy)]
struct Averages {
    a: f64,
    b: f64,
    aa: f64,
    ab: f64,
    bb: f64,
    steep_aa: f64,
    steep_ab: f64,
    steep_bb: f64,
}

/// Correlations along one axis at the nodes of a quadrature over distances.
struct Axes {
    /// Distance, weight, A, B, A′, B′.
    nodes: Vec<[f64; 6]>,
    /// −A″(0) and −B″(0).
    curvatures: [f64; 2],
}

fn axes() -> &'static Axes {
    static AXES: OnceLock<Axes> = OnceLock::new();
    AXES.get_or_init(|| {
        let one = |function: fn(f64) -> f64| {
            let whole = correlation(function, 0.0);
            move |distance: f64| correlation(function, distance) / whole
        };
        let (a, b) = (one(weight), one(|t| t * weight(t)));
        let slope = |function: &dyn Fn(f64) -> f64, at: f64| {
            const STEP: f64 = 1e-3;
            let at = |steps: f64| function((at + steps * STEP).abs());
            (8.0 * (at(1.0) - at(-1.0)) - (at(2.0) - at(-2.0))) / (12.0 * STEP)
        };
        let node = |[distance, weight]: [f64; 2]| {
            [distance, weight, a(distance), b(distance), slope(&a, distance), slope(&b, distance)]
        };
        let nodes = graded(2.0).into_iter().map(node).collect();
        let curvature = |function: &dyn Fn(f64) -> f64| {
            const STEP: f64 = 1e-2;
            let at = |steps: f64| function(steps * STEP) - 1.0;
            -(16.0 * at(1.0) - at(2.0)) / (6.0 * STEP * STEP)
        };
        Axes { nodes, curvatures: [curvature(&a), curvature(&b)] }
    })
}

/// ∫ f(x) f(x + distance) dx of a function that is 0 beyond 1 and smooth but at 0.
pub(super) fn correlation(function: fn(f64) -> f64, distance: f64) -> f64 {
    if distance >= 2.0 {
        return 0.0;
    }
    let mut ends = vec![-1.0, 1.0 - distance];
    ends.extend([0.0, -distance].into_iter().filter(|kink| -1.0 < *kink && *kink < 1.0 - distance));
    ends.sort_by(f64::total_cmp);
    let parts = ends.windows(2).map(|ends| {
        let [sum] = integrate(ends[0], ends[1], 1.0, |x| [function(x) * function(x + distance)]);
        sum
    });
    parts.sum()
}

/// Nodes and weights from 0 to an end, in panels that double from 2⁻¹¹ to ¼ and stay there.
pub(super) fn graded(end: f64) -> Vec<[f64; 2]> {
    let mut nodes = Vec::new();
    let (mut from, mut to) = (0.0, 1.0 / 2048.0);
    while from < end {
        // The rule's nodes are where it evaluates the function, and each weight is what it gives to that value alone.
        let panel = std::cell::RefCell::new(Vec::new());
        integrate(from, to, 2.0 * (to - from), |at| {
            panel.borrow_mut().push(at);
            [0.0]
        });
        for (index, at) in panel.into_inner().into_iter().enumerate() {
            let calls = std::cell::Cell::new(0);
            let [weight] = integrate(from, to, 2.0 * (to - from), |_| {
                let call = calls.replace(calls.get() + 1);
                [f64::from(u8::from(call == index))]
            });
            nodes.push([at, weight]);
        }
        from = to;
        to = (to + to.min(0.25)).min(end);
    }
    // Sums end at the first node that is too far.
    nodes.sort_by(|one, other| one[0].total_cmp(&other[0]));
    nodes
}

impl Axes {
    /// Both signs of the distance count.
    fn means(&self, deviation: f64) -> Averages {
        let mut sums = [0.0; 8];
        let scale = 2.0 / ((2.0 * std::f64::consts::PI).sqrt() * deviation);
        for &[distance, weight, a, b, steep_a, steep_b] in &self.nodes {
            let at = distance / deviation;
            if at > 9.0 {
                continue;
            }
            let density = scale * weight * libm::exp(-0.5 * at * at);
            let values = [a, b, a * a, a * b, b * b, steep_a * steep_a, steep_a * steep_b, steep_b * steep_b];
            for (sum, value) in sums.iter_mut().zip(values) {
                *sum += density * value;
            }
        }
        let [a, b, aa, ab, bb, steep_aa, steep_ab, steep_bb] = sums;
        Averages { a, b, aa, ab, bb, steep_aa, steep_ab, steep_bb }
    }
}

/// The correlation of a round kernel at the nodes of a quadrature over distances.
struct Kernel {
    /// Distance, weight, R, R′.
    nodes: Vec<[f64; 4]>,
    /// −R″(0).
    curvature: f64,
}

fn kernel() -> &'static Kernel {
    static KERNEL: OnceLock<Kernel> = OnceLock::new();
    KERNEL.get_or_init(|| {
        let whole = overlap(0.0);
        let value = |distance: f64| overlap(distance) / whole;
        let slope = |at: f64| {
            const STEP: f64 = 1e-3;
            let at = |steps: f64| value((at + steps * STEP).abs());
            (8.0 * (at(1.0) - at(-1.0)) - (at(2.0) - at(-2.0))) / (12.0 * STEP)
        };
        let node = |[distance, weight]: [f64; 2]| [distance, weight, value(distance), slope(distance)];
        let nodes = graded(2f64.sqrt()).into_iter().map(node).collect();
        let at = |distance: f64| value(distance) - 1.0;
        let curvature = -(16.0 * at(1e-2) - at(2e-2)) / (6.0 * 1e-4);
        Kernel { nodes, curvature }
    })
}

/// ∫ k(x) k(x + distance) over the plane, for lines of all directions alike.
pub(super) fn overlap(distance: f64) -> f64 {
    let reach = 0.5f64.sqrt();
    let wide = reach - 0.5 * distance;
    if wide <= 0.0 {
        return 0.0;
    }
    let lines = |x: f64, y: f64| {
        let at = [[x - 0.5 * distance, y], [x + 0.5 * distance, y]];
        let product = |slope: [f64; 2]| part(at[0], slope) * part(at[1], slope);
        0.5 * (product([1.0, 0.0]) + product([0.0, 1.0]))
    };
    let column = |x: f64| {
        let edge = x.abs() + 0.5 * distance;
        let high = (0.5 - edge * edge).max(0.0).sqrt();
        let [sum] = integrate(0.0, high, high.max(1e-9), |y| [lines(x, y)]);
        [sum]
    };
    let [sum] = integrate(0.0, wide, 0.5 * wide, column);
    4.0 * sum
}

impl Kernel {
    /// The mean over all directions of the normal density at a distance, by quadrature over the angle to the axes.
    fn means(&self, [x, y]: [f64; 2]) -> Means {
        let (major, minor) = (x.max(y), x.min(y));
        let (mut correlation, mut gradient) = (0.0, 0.0);
        for &[distance, weight, value, slope] in &self.nodes {
            let far = distance / major;
            if far > 9.0 {
                continue;
            }
            // exp(−½ r² (cos²/a² + sin²/b²)) falls from the major axis on, within an angle of 1/√sharp.
            let sharp = 0.5 * distance * distance * (1.0 / (minor * minor) - 1.0 / (major * major));
            let end = (7.0 / sharp.max(1e-9).sqrt()).min(std::f64::consts::FRAC_PI_2);
            let [angles] = integrate(0.0, end, 0.5 * end, |angle| [libm::exp(-sharp * libm::sin(angle).powi(2))]);
            let density = weight * distance * libm::exp(-0.5 * far * far) * 4.0 * angles
                / (2.0 * std::f64::consts::PI * major * minor);
            correlation += density * value;
            gradient += density * slope * slope;
        }
        Means { correlation, gradient }
    }
}
