//! Nodes of a table between which is read in a line, moved so that its errors on either side are alike.

/// Of the second difference: a line between two nodes of a parabola is off by 1/8 of it in the middle.
const MOVED: f32 = 1.0 / 16.0;

/// Colors in a line through a table.
#[derive(Clone, Copy)]
pub(super) struct Nodes {
    /// The number of the first.
    pub start: usize,
    /// How many.
    pub count: usize,
    /// From one to the next.
    pub step: usize,
}

/// Moves all but the first and the last, which stay, within the bounds of each channel.
pub(super) fn balance(colors: &mut [f32], Nodes { start, count, step }: Nodes, [low, high]: [[f32; 4]; 2]) {
    let numbers = |node: usize| 4 * (start + node * step);
    let at = |colors: &[f32], node| -> [f32; 4] { std::array::from_fn(|channel| colors[numbers(node) + channel]) };
    let mut before = if count > 0 { at(colors, 0) } else { return };
    for node in 1..count.saturating_sub(1) {
        let (here, after) = (at(colors, node), at(colors, node + 1));
        for channel in 0..4 {
            let second = before[channel] - 2.0 * here[channel] + after[channel];
            colors[numbers(node) + channel] = (here[channel] - MOVED * second).clamp(low[channel], high[channel]);
        }
        before = here;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Of a parabola the error in the middle is as large as that at nodes, half of what it was.
    #[test]
    fn errors_in_the_middle_are_those_at_nodes() {
        let parabola = |at: f32| 0.1 + 0.3 * at * at;
        // Every other color is another row's.
        let before: Vec<f32> = (0..10_u8).flat_map(|at| [parabola(f32::from(at / 2)), 0.5, 9.0, 0.0]).collect();
        let mut after = before.clone();
        balance(&mut after, Nodes { start: 1, count: 5, step: 2 }, [[0.0; 4], [5.0; 4]]);
        let color = |at: usize| &after[4 * at..4 * at + 4];
        for at in [0, 1, 2, 4, 6, 8, 9] {
            assert_eq!(color(at), &before[4 * at..4 * at + 4], "{at}");
        }
        let at_nodes = color(5)[0] - parabola(2.0);
        let between = 0.5 * (color(3)[0] + color(5)[0]) - parabola(1.5);
        assert!((at_nodes + between).abs() < 1e-6 && (between - 0.3 / 8.0).abs() < 1e-6, "{at_nodes} {between}");
        assert_eq!(color(5)[1..], [0.5, 5.0, 0.0]);
    }
}
