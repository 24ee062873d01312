// What a driver that is a function of the position says of a footprint. Values alone are a vec4f: mean, variance,
// skewness and excess kurtosis, the last two 0 where they are not known.

/// What a footprint holds of a height field and of its slopes, along the two coordinates of its positions.
struct statistics_surface {
    /// Mean, variance, skewness and excess kurtosis of the heights.
    moments: vec4f,
    /// Mean slope.
    slope: vec2f,
    /// Covariance of the slopes about that: xx, xy, yy.
    slope_covariance: vec3f,
}
