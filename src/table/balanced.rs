//! Nodes of a table between which is read in a line, moved so that its errors on either side are alike.

/// Of the second difference: a line between two nodes of a parabola is off by 1/8 of it in the middle.
const MOVED: f64 = 1.0 / 16.0;

/// The nodes of a row of colors but the first and the last, which stay, within the bounds of each channel.
pub(super) fn balanced(nodes: &[[f64; 4]], [low, high]: [[f64; 4]; 2]) -> Vec<[f64; 4]> {
    let inner = nodes.windows(3).map(|three| {
        std::array::from_fn(|channel| {
            let [before, here, after] = [three[0], three[1], three[2]].map(|color: [f64; 4]| color[channel]);
            (here - MOVED * (before - 2.0 * here + after)).clamp(low[channel], high[channel])
        })
    });
    let [first, last] = [nodes.first(), nodes.get(1..).and_then(<[_]>::last)].map(|end| end.copied());
    first.into_iter().chain(inner).chain(last).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Of a parabola the error in the middle is as large as that at nodes, half of what it was.
    #[test]
    fn errors_in_the_middle_are_those_at_nodes() {
        let parabola = |at: f64| 0.1 + 0.3 * at * at;
        let nodes: Vec<[f64; 4]> = (0..5).map(|at| [parabola(f64::from(at)), 0.5, 9.0, 0.0]).collect();
        let found = balanced(&nodes, [[0.0; 4], [5.0; 4]]);
        assert_eq!(found.len(), 5);
        assert_eq!((found[0], found[4]), (nodes[0], nodes[4]));
        let at_nodes = found[2][0] - parabola(2.0);
        let between = 0.5 * (found[1][0] + found[2][0]) - parabola(1.5);
        assert!((at_nodes + between).abs() < 1e-12 && (between - 0.3 / 8.0).abs() < 1e-12, "{at_nodes} {between}");
        assert_eq!([found[2][1], found[2][2], found[2][3]], [0.5, 5.0, 0.0]);
    }
}
