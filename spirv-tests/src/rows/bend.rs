//! What second derivatives of noise tell of a footprint: by regression, and moments added one by one.

use prefilter::reference::bend::{told, Moments};

use super::Row;

/// Moments that a noise may have: no number varies less than what others tell of it.
fn possible(x: &[f64]) -> bool {
    x[7] >= x[8] && x[8] >= x[6] * x[6]
}

pub(super) fn rows() -> Vec<Row> {
    vec![
        Row::new("bend_filter", |x| {
            let moments = Moments { slopes: x[6], bends: x[7], both: x[8] };
            told([x[0], x[1], x[2]], x[3], moments.trace([x[4], x[5]]))
        })
        .only_where(possible),
        Row::new("bend_add", |x| {
            let [mean, rest, across, along, bend, amplitude] = std::array::from_fn(|at| x[at]);
            let [multiplier, coupling, left, share, bent, noise] = std::array::from_fn(|at| x[6 + at]);
            // Along the axes: Σ times H, its diagonal's sum.
            let ([xx, xy, yy], footprint) = ([x[14], x[15], x[16]], [[x[17], x[18]], [x[18], x[19]]]);
            let bends = [[xx, xy], [xy, yy]];
            let trace: f64 = (0..2).flat_map(|i| (0..2).map(move |j| footprint[i][j] * bends[j][i])).sum();
            let octave = [
                multiplier * noise + share * trace / 2.0,
                amplitude * left,
                coupling * x[12],
                coupling * x[13],
                bent * trace,
            ];
            std::array::from_fn::<f64, 5, _>(|at| [mean, rest, across, along, bend][at] + amplitude * octave[at])
        }),
        Row::new("bend_statistics", |x| {
            let [mean, rest, across, along, bend, center] = std::array::from_fn(|at| x[at]);
            let (scale, variance) = (x[6], x[7]);
            // Of bend (t² − 1)/2 and a slope times t, t being normal: the mean square is a sum over moments of t.
            let square = across * across + along * along + bend * bend * (3.0 - 2.0 + 1.0) / 4.0;
            let left = rest.max(0.0) * variance.max(0.0);
            [center + scale * mean, scale * scale * (square + left), 0.0, 0.0]
        }),
    ]
}
