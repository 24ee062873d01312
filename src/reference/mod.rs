//! The truth in f64: the integrals that the shaders approximate, by quadrature.
//!
//! Imports nothing of the crate and shares no formula with a shader, so that agreement means something.

pub mod beta;
pub mod combine;
pub mod cosines;
pub mod crossing;
pub mod curvature;
pub mod fold;
pub mod footprint;
pub mod four_moments;
pub mod fractal;
pub mod gabor;
pub mod gabor_kernel;
pub mod gabor_paper;
pub mod gabor_spectrum;
pub mod hash;
pub mod height;
pub mod heights;
pub mod indicators;
pub mod irradiance;
pub mod lattice;
pub mod mixture;
pub mod moments;
pub mod normal;
pub mod normals;
pub mod pattern;
pub mod percentile;
pub mod perlin;
pub mod perturbed;
pub mod pulse;
pub mod quadrature;
pub mod retained;
pub mod roughness;
pub mod rounds;
pub mod simplex;
pub mod slope;
pub mod slope_map;
pub mod slope_moments;
pub mod slopes;
pub mod smith;
pub mod steepness;
pub mod taps;
pub mod texture;
pub mod value;
pub mod visibility;
pub mod warp;
