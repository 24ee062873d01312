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

/// A sky that is bright at its zenith and on one side, over dark ground: the irradiance is about 1.
pub const SKY: [[f32; 3]; 9] = [
    [0.9, 1.1, 1.4],
    [0.1, 0.12, 0.1],
    [0.5, 0.6, 0.9],
    [0.4, 0.35, 0.2],
    [0.02, 0.0, -0.03],
    [0.05, 0.04, 0.02],
    [0.1, 0.08, 0.11],
    [0.2, 0.15, 0.1],
    [-0.04, 0.02, 0.01],
];
