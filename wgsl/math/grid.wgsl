// Axes of tables: from a value to the texture coordinate at which bilinear filtering interpolates between nodes.
//
// Node i of n lies on the center of texel i, at (i + ½)/n: the first node is the axis' first value and the last node
// its last, exactly. The baker's inverse is `table/grid.rs`.

/// Texture coordinate of a value on an evenly spaced axis from `low` to `high`; values outside read the end nodes.
///
/// Source: texel-center addressing, (v (n − 1) + ½)/n.
/// Domain: value in [-1, 2], low in [-0.5, 0.25], high in [0.5, 1.5], count integer in [2, 4096].
/// Error: 3e-7 absolute; f32 rounding.
fn grid_linear(value: f32, low: f32, high: f32, count: f32) -> f32 {
    let n = max(count, 1.0);
    let v = clamp((value - low) / max(high - low, 1e-30), 0.0, 1.0);
    return (v * (n - 1.0) + 0.5) / n;
}

/// Texture coordinate of a value on an axis from 0 to `high` whose nodes are evenly spaced in the cube root.
///
/// Filtered maps change fastest at small deviations: the cube root spends the nodes there.
///
/// Source: v = (value/high)^(1/3) with texel-center addressing.
/// Domain: value log in [1e-7, 2], high in [0.25, 1], count integer in [2, 4096].
/// Error: 8e-7 absolute; of exp2 and log2.
fn grid_cube_root(value: f32, high: f32, count: f32) -> f32 {
    let n = max(count, 1.0);
    let v = clamp(value / max(high, 1e-30), 1e-30, 1.0);
    return (exp2(log2(v) * (1.0 / 3.0)) * (n - 1.0) + 0.5) / n;
}
