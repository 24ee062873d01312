//! Shares in sight by integrals over heights; the azimuths between directions by arcus tangents.

use prefilter::reference::visibility::{azimuth, independence, masking, shadowing};

use super::Row;

/// Both directions have an azimuth.
fn have_azimuths(point: &[f64]) -> bool {
    point.chunks(3).all(|direction| direction[0] != 0.0 || direction[1] != 0.0)
}

pub(super) fn rows() -> Vec<Row> {
    vec![
        Row::new("visibility_masking", |x| [masking(x[0])]).at([[0.0], [1.0]]),
        Row::new("visibility_shadowing", |x| [shadowing(x[0], x[1])]).at([[0.0, 0.0], [0.0, 1.0], [1.0, 0.0]]),
        // The sum for directions apart, the larger of the two for one direction, and linear between.
        Row::new("visibility_correlated", |x| {
            let &[view, light, independence] = x else { return [f64::NAN] };
            [(1.0 - independence) * (view.max(light) - view) + independence * light]
        })
        .at([[1.0, 1.0, 0.5], [2.0, 3.0, 0.0], [3.0, 2.0, 1.0]]),
        Row::new("visibility_independence", |x| [independence(azimuth([x[0], x[1], x[2]], [x[3], x[4], x[5]]))])
            .only_where(have_azimuths)
            .at([
                [0.6, 0.0, 0.8, 0.6, 0.0, 0.8],
                [0.6, 0.0, 0.8, -0.8, 0.0, 0.6],
                [0.6, 0.0, 0.8, 0.0, 0.8, 0.6],
                [1e-6, 2e-6, 1.0, 0.0, -0.8, 0.6],
            ]),
    ]
}
