//! Sums of round normal distributions: those with the least largest error of a step, by exchange, or with the least sum
//! of eighth powers.

use std::sync::OnceLock;

use prefilter::reference::rounds::{nearest, paired, smoothest};

use super::Row;

/// Places as multiples of z a, and weights; between nodes linearly, which leaves 1e-5.
struct Nearest<const N: usize> {
    from: f64,
    step: f64,
    nodes: Vec<[f64; N]>,
}

/// The places times a factor, the weights as they are.
fn placed<const N: usize>(mut pairs: [f64; N], factor: f64) -> [f64; N] {
    pairs[..N.div_ceil(2)].iter_mut().for_each(|place| *place *= factor);
    pairs
}

impl<const N: usize> Nearest<N> {
    /// In steps down, or up where those are negative, from a part for which a sum is known: each node starts from the
    /// one before.
    fn new(from: f64, step: f64, count: usize, start: [f64; N], nearest: impl Fn(f64, [f64; N]) -> [f64; N]) -> Self {
        let z = |part: f64| (1.0 - part * part).sqrt();
        let mut last = placed(start, 1.0 / z(from));
        let node = |index: usize| {
            let part = from - step * index as f64;
            last = placed(nearest(part, placed(last, z(part))), 1.0 / z(part));
            last
        };
        Self { from, step, nodes: (0..count).map(node).collect() }
    }

    fn at(&self, part: f64) -> [f64; N] {
        let along = ((self.from - part) / self.step).clamp(0.0, self.nodes.len() as f64 - 1.001);
        let (index, share) = (along as usize, along.fract());
        std::array::from_fn(|number| (1.0 - share) * self.nodes[index][number] + share * self.nodes[index + 1][number])
    }
}

/// The place of either of a pair about a third on the mean, as a multiple of z a, and its weight.
pub(super) fn three(part: f64) -> [f64; 2] {
    static NARROW: OnceLock<Nearest<2>> = OnceLock::new();
    static WIDE: OnceLock<Nearest<2>> = OnceLock::new();
    let start = [1.18, 0.219];
    if part <= 0.6 {
        return NARROW.get_or_init(|| Nearest::new(0.6, 0.004, 80, start, nearest)).at(part);
    }
    // Beyond, the three are one to 1e-5 of a step.
    WIDE.get_or_init(|| Nearest::new(0.6, -0.004, 85, start, nearest)).at(part)
}

/// From this part on six and seven stand for ten and eleven: those for this part.
const SHORT: f64 = 0.45;

fn short(part: f64) -> bool {
    part >= f64::from(SHORT as f32)
}

fn shortest<const N: usize>(start: [f64; N], nearest: impl Fn(f64, [f64; N]) -> [f64; N]) -> [f64; N] {
    placed(nearest(SHORT, start), 1.0 / (1.0 - SHORT * SHORT).sqrt())
}

/// The pairs of ten as the shelf's structure has them; from 0.3 on those for that part, and then the pairs of six.
pub(super) fn ten(part: f64) -> [f64; 10] {
    static TEN: OnceLock<Nearest<9>> = OnceLock::new();
    static SIX: OnceLock<[f64; 5]> = OnceLock::new();
    if short(part) {
        let [p, q, r, b, c] = *SIX.get_or_init(|| shortest([0.4, 1.2, 2.2, 0.15, 0.02], paired));
        return [p, q, r, 0.0, 0.5 - (b + c), b, c, 0.0, 0.0, 0.0];
    }
    let start = [0.284, 0.86, 1.462, 2.125, 2.947, 0.1614, 0.0856, 0.0298, 0.0052];
    let [p, q, r, s, t, b, c, d, e] = TEN.get_or_init(|| Nearest::new(0.3, 0.01, 25, start, paired)).at(part);
    [p, q, r, s, 0.5 - (b + c + d + e), b, c, d, t, e]
}

/// The pairs of eleven, or of seven.
fn eleven(part: f64) -> [f64; 10] {
    static ELEVEN: OnceLock<Nearest<10>> = OnceLock::new();
    static SEVEN: OnceLock<[f64; 6]> = OnceLock::new();
    if short(part) {
        let [p, q, r, a, b, c] = *SEVEN.get_or_init(|| shortest([0.74, 1.52, 2.45, 0.24, 0.09, 0.01], smoothest));
        return [p, q, r, 0.0, a, b, c, 0.0, 0.0, 0.0];
    }
    let start = [0.54, 1.093, 1.676, 2.319, 3.119, 0.1877, 0.1238, 0.0593, 0.0188, 0.003];
    let [p, q, r, s, t, a, b, c, d, e] = ELEVEN.get_or_init(|| Nearest::new(0.3, 0.01, 25, start, smoothest)).at(part);
    [p, q, r, s, a, b, c, d, t, e]
}

pub(super) fn rows() -> Vec<Row> {
    static FIVE: OnceLock<Nearest<4>> = OnceLock::new();
    static SEVEN: OnceLock<Nearest<6>> = OnceLock::new();
    let seven = |part: f64| {
        let start = [0.722, 1.49, 2.408, 0.2348, 0.0946, 0.015];
        SEVEN.get_or_init(|| Nearest::new(0.4, 0.01, 30, start, smoothest)).at(part)
    };
    let third = |pairs: [f64; 6], from: usize| -> [f64; 3] { std::array::from_fn(|number| pairs[from + number]) };
    vec![
        Row::new("rounds_three", |x| three(x[0])),
        Row::new("rounds_five", |x| {
            FIVE.get_or_init(|| Nearest::new(0.36, 0.002, 110, [0.846, 1.82, 0.249, 0.074], nearest)).at(x[0])
        }),
        Row::new("rounds_seven_places", move |x| third(seven(x[0]), 0)),
        Row::new("rounds_seven_weights", move |x| third(seven(x[0]), 3)),
        Row::new("rounds_ten", |x| ten(x[0])).at([[SHORT]]),
        Row::new("rounds_eleven", |x| eleven(x[0])).at([[SHORT]]),
    ]
}
