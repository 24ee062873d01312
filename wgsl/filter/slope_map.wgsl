// Cs of maps of the whole slope: means over normal distributions of slopes, from a table of those over round ones.
//
// The table's columns and rows are the components of the mean slope, evenly in s / (1 + bend |s|), with `per_slope` of
// the texture a unit of that: denser about 0, so that they may reach all slopes. Its 20 slices are deviations,
// from 0 on evenly in the logarithm of 1 + deviation · per_deviation, with `per_octave` of the texture a doubling of
// that. Means and deviations beyond read the border. The sampler is linear and clamps at the edges.

/// Coordinate of a deviation among the slices of a table.
///
/// Source: the definition above.
/// Domain: deviation log in [1e-3, 0.5], per_deviation in [24, 24], per_octave in [0.25672624, 0.25672624].
/// Error: 3e-7 absolute; f32 rounding and the device's log2.
fn slope_map_slice(deviation: f32, per_deviation: f32, per_octave: f32) -> f32 {
    // From the center of the first slice, ½/20.
    return 0.025 + per_octave * log2(1.0 + clamp(per_deviation, 0.0, 1e18) * clamp(deviation, 0.0, 1e18));
}

/// Mean of a map over a round normal distribution of slopes, from its table, by the `slope_map_slice` of the deviation.
///
/// Source: Heitz et al. 2014, "Filtering Non-Linear Transfer Functions on Surfaces", section 5.2, with an axis for the
/// deviation in place of a pyramid.
/// Domain: mean in [-1.5, 1.5], slice in [0.47, 0.975], per_slope in [0.39583334, 0.39583334], bend in [0.4, 0.4].
/// Error: 1e-3 absolute; trilinear interpolation of 96 × 96 × 20 nodes for a random map of 2 × 2 cells.
fn slope_map_read(mean: vec2f, slice: f32, per_slope: f32, bend: f32, table: texture_3d<f32>,
    table_sampler: sampler) -> vec4f {
    let at = 0.5 + per_slope * mean / (1.0 + bend * abs(mean));
    return textureSampleLevel(table, table_sampler, vec3f(at, slice), 0.0);
}

/// Sum of the means over two round normal distributions of slopes on either side of a mean.
///
/// Source: the definition.
/// Domain: mean in [-0.5, 0.5], away in [-1, 1], slice in [0.47, 0.975], per_slope in [0.39583334, 0.39583334],
///   bend in [0.4, 0.4].
/// Error: 1.5e-3 absolute; of both reads.
fn slope_map_sides(mean: vec2f, away: vec2f, slice: f32, per_slope: f32, bend: f32, table: texture_3d<f32>,
    table_sampler: sampler) -> vec4f {
    return slope_map_read(mean - away, slice, per_slope, bend, table, table_sampler)
        + slope_map_read(mean + away, slice, per_slope, bend, table, table_sampler);
}

/// Mean of a map over a normal distribution of slopes, by the round one of the same area.
///
/// Source: the definition, √(a s).
/// Domain: mean in [-1.5, 1.5], covariance psd(0.2, 0.4, 0.5), per_slope in [0.39583334, 0.39583334],
///   bend in [0.4, 0.4], per_deviation in [24, 24], per_octave in [0.25672624, 0.25672624].
/// Error: 8e-2 absolute; of the shape, for a random map of 2 × 2 cells and axes of ratios up to 3.
fn slope_map_one(mean: vec2f, covariance: vec3f, per_slope: f32, bend: f32, per_deviation: f32, per_octave: f32,
    table: texture_3d<f32>, table_sampler: sampler) -> vec4f {
    let area = sqrt(max(covariance.x * covariance.z - covariance.y * covariance.y, 0.0));
    let slice = slope_map_slice(sqrt(area), per_deviation, per_octave);
    return slope_map_read(mean, slice, per_slope, bend, table, table_sampler);
}

/// Mean of a map over a normal distribution of slopes, by three round ones on its major axis.
///
/// Source: `rounds_three`.
/// Domain: mean in [-1.5, 1.5], stretch from footprint_stretched, per_slope in [0.39583334, 0.39583334],
///   bend in [0.4, 0.4], per_deviation in [24, 24], per_octave in [0.25672624, 0.25672624].
/// Error: 6e-3 absolute; of the shape, for a random map of 2 × 2 cells and axes of ratios up to 3.
fn slope_map_three(mean: vec2f, stretch: footprint_stretch, per_slope: f32, bend: f32, per_deviation: f32,
    per_octave: f32, table: texture_3d<f32>, table_sampler: sampler) -> vec4f {
    let sides = rounds_three(stretch.part);
    let slice = slope_map_slice(stretch.deviation, per_deviation, per_octave);
    let middle = slope_map_read(mean, slice, per_slope, bend, table, table_sampler);
    let both = slope_map_sides(mean, sides.x * stretch.away, slice, per_slope, bend, table, table_sampler);
    return mix(middle, 0.5 * both, 2.0 * sides.y);
}

/// Mean of a map over a normal distribution of slopes, by five round ones on its major axis.
///
/// Source: `rounds_five`.
/// Domain: mean in [-1.5, 1.5], stretch from footprint_stretched, per_slope in [0.39583334, 0.39583334],
///   bend in [0.4, 0.4], per_deviation in [24, 24], per_octave in [0.25672624, 0.25672624].
/// Error: 1e-3 absolute; of the shape, for a random map of 2 × 2 cells and axes of ratios up to 3.
fn slope_map_five(mean: vec2f, stretch: footprint_stretch, per_slope: f32, bend: f32, per_deviation: f32,
    per_octave: f32, table: texture_3d<f32>, table_sampler: sampler) -> vec4f {
    let arms = rounds_five(stretch.part);
    let slice = slope_map_slice(stretch.deviation, per_deviation, per_octave);
    let middle = slope_map_read(mean, slice, per_slope, bend, table, table_sampler);
    let a = slope_map_sides(mean, arms.x * stretch.away, slice, per_slope, bend, table, table_sampler);
    let b = slope_map_sides(mean, arms.y * stretch.away, slice, per_slope, bend, table, table_sampler);
    return mix(middle, 0.5 * a, 2.0 * arms.z) + arms.w * (b - 2.0 * middle);
}

/// Mean of a map over a normal distribution of slopes, by seven round ones on its major axis.
///
/// Source: `rounds_seven_places`.
/// Domain: mean in [-1.5, 1.5], stretch from footprint_stretched, per_slope in [0.39583334, 0.39583334],
///   bend in [0.4, 0.4], per_deviation in [24, 24], per_octave in [0.25672624, 0.25672624].
/// Error: 1e-3 absolute; of the table, for a random map of 2 × 2 cells and axes of ratios up to 3.
fn slope_map_seven(mean: vec2f, stretch: footprint_stretch, per_slope: f32, bend: f32, per_deviation: f32,
    per_octave: f32, table: texture_3d<f32>, table_sampler: sampler) -> vec4f {
    let places = rounds_seven_places(stretch.part);
    let w = rounds_seven_weights(stretch.part);
    let slice = slope_map_slice(stretch.deviation, per_deviation, per_octave);
    let middle = slope_map_read(mean, slice, per_slope, bend, table, table_sampler);
    let a = slope_map_sides(mean, places.x * stretch.away, slice, per_slope, bend, table, table_sampler);
    let b = slope_map_sides(mean, places.y * stretch.away, slice, per_slope, bend, table, table_sampler);
    let c = slope_map_sides(mean, places.z * stretch.away, slice, per_slope, bend, table, table_sampler);
    return (1.0 - 2.0 * (w.x + w.y + w.z)) * middle + w.x * a + w.y * b + w.z * c;
}

/// Sum of the means over pairs of round distributions on an axis, by their weights: the outer two where they have any.
///
/// Source: the definition.
/// Domain: mean in [-0.5, 0.5], stretch from footprint_stretched, pairs from rounds_ten, slice in [0.47, 0.975],
///   per_slope in [0.39583334, 0.39583334], bend in [0.4, 0.4].
/// Error: 1e-3 absolute; of ten reads, by weights of ½ for all of either side.
fn slope_map_pairs(mean: vec2f, stretch: footprint_stretch, pairs: rounds_pairs, slice: f32, per_slope: f32,
    bend: f32, table: texture_3d<f32>, table_sampler: sampler) -> vec4f {
    let w = pairs.weights;
    let a = slope_map_sides(mean, pairs.places.x * stretch.away, slice, per_slope, bend, table, table_sampler);
    let b = slope_map_sides(mean, pairs.places.y * stretch.away, slice, per_slope, bend, table, table_sampler);
    let c = slope_map_sides(mean, pairs.places.z * stretch.away, slice, per_slope, bend, table, table_sampler);
    var sum = w.x * a + w.y * b + w.z * c;
    if pairs.outermost.y > 0.0 {
        let d = slope_map_sides(mean, pairs.places.w * stretch.away, slice, per_slope, bend, table, table_sampler);
        let e = slope_map_sides(mean, pairs.outermost.x * stretch.away, slice, per_slope, bend, table, table_sampler);
        sum += w.w * d + pairs.outermost.y * e;
    }
    return sum;
}

/// Mean of a map over a normal distribution of slopes, by ten round ones on its major axis.
///
/// Source: `rounds_ten`.
/// Domain: mean in [-1.5, 1.5], stretch from footprint_stretched, per_slope in [0.39583334, 0.39583334],
///   bend in [0.4, 0.4], per_deviation in [24, 24], per_octave in [0.25672624, 0.25672624].
/// Error: 1e-3 absolute; of the table, for a random map of 2 × 2 cells and axes of ratios up to 3.
fn slope_map_ten(mean: vec2f, stretch: footprint_stretch, per_slope: f32, bend: f32, per_deviation: f32,
    per_octave: f32, table: texture_3d<f32>, table_sampler: sampler) -> vec4f {
    let slice = slope_map_slice(stretch.deviation, per_deviation, per_octave);
    return slope_map_pairs(mean, stretch, rounds_ten(stretch.part), slice, per_slope, bend, table, table_sampler);
}

/// Mean of a map over a normal distribution of slopes, by eleven round ones on its major axis.
///
/// Source: `rounds_eleven`.
/// Domain: mean in [-1.5, 1.5], stretch from footprint_stretched, per_slope in [0.39583334, 0.39583334],
///   bend in [0.4, 0.4], per_deviation in [24, 24], per_octave in [0.25672624, 0.25672624].
/// Error: 1e-3 absolute; of the table, for a random map of 2 × 2 cells and axes of ratios up to 3.
fn slope_map_eleven(mean: vec2f, stretch: footprint_stretch, per_slope: f32, bend: f32, per_deviation: f32,
    per_octave: f32, table: texture_3d<f32>, table_sampler: sampler) -> vec4f {
    let pairs = rounds_eleven(stretch.part);
    let slice = slope_map_slice(stretch.deviation, per_deviation, per_octave);
    let middle = slope_map_read(mean, slice, per_slope, bend, table, table_sampler);
    let rest = 1.0 - 2.0 * (dot(pairs.weights, vec4f(1.0)) + pairs.outermost.y);
    return rest * middle + slope_map_pairs(mean, stretch, pairs, slice, per_slope, bend, table, table_sampler);
}
