//! Octaves folded at 0: the moments of |n| by quadrature, and what they have apart from their slopes.

use prefilter::reference::fold::moments;

use super::Row;

pub(super) fn rows() -> Vec<Row> {
    let octave = |x: &[f64]| {
        let [multiplier, coupling, rest, noise, across, along, variance, share] = std::array::from_fn(|at| x[at]);
        let told = coupling * coupling * (across * across + along * along);
        let [mean, spread, sign] = moments(multiplier * noise, variance * rest + told);
        // What a normal distribution of the noise's variance is off by, where nothing of the octave is resolved.
        let [normal, normal_spread, _] = moments(0.0, variance);
        let part = rest * rest;
        let own = (spread - sign * sign * told) / variance;
        let apart = 1.0 - share * share - normal_spread / variance;
        [mean + part * (share * variance.sqrt() - normal), sign * coupling, (own + part * apart).max(0.0)]
    };
    let unresolved = [[0.0, 0.0, 1.0, 0.3, 0.1, 0.2, 0.05, 0.82], [0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.05, 0.82]];
    vec![Row::new("fold_octave", octave).at(unresolved)]
}
