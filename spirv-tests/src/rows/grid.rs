//! Axes of tables, by the inverse: where bilinear filtering of the nodes gives the value.

use super::Row;

/// The texture coordinate between the end nodes at which the axis, rising with the node number, has the value.
fn coordinate(count: f64, value: f64, axis: impl Fn(f64) -> f64) -> f64 {
    // Node i of n is the center of texel i.
    let at = |coordinate: f64| axis((coordinate * count - 0.5) / (count - 1.0));
    let (mut low, mut high) = (0.5 / count, 1.0 - 0.5 / count);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if at(middle) < value {
            low = middle;
        } else {
            high = middle;
        }
    }
    0.5 * (low + high)
}

pub(super) fn rows() -> Vec<Row> {
    vec![
        Row::new("grid_linear", |x| [coordinate(x[3], x[0], |along| x[1] + along * (x[2] - x[1]))]).at([
            [0.0, 0.0, 1.0, 2.0],
            [1.0, 0.0, 1.0, 4096.0],
            [0.3, 0.3, 0.7, 17.0],
            [0.7, 0.3, 0.7, 17.0],
        ]),
        Row::new("grid_cube_root", |x| [coordinate(x[2], x[0], |along| x[1] * along * along * along)]).at([
            [0.5, 0.5, 16.0],
            [1.0, 1.0, 4096.0],
            [1e-7, 1.0, 2.0],
        ]),
    ]
}
