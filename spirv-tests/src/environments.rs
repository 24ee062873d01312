//! Environments that tests light with, as radiance by order and degree of spherical harmonics.

/// Grace Cathedral.
///
/// Source: Ramamoorthi and Hanrahan 2001, "An Efficient Representation for Irradiance Environment Maps", figure 2.
pub const GRACE: [[f32; 3]; 9] = [
    [0.79, 0.44, 0.54],
    [0.39, 0.35, 0.60],
    [-0.34, -0.18, -0.27],
    [-0.29, -0.06, 0.01],
    [-0.11, -0.05, -0.12],
    [-0.26, -0.22, -0.47],
    [-0.16, -0.09, -0.15],
    [0.56, 0.21, 0.14],
    [0.21, -0.05, -0.30],
];
