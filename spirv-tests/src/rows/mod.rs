//! The references of the shelf's functions, a row each, in the rooms of the shelf's files.
//!
//! A reference is the function's definition by another method: an integral by quadrature, an inverse by bisection. It
//! never repeats a shader's formula.

mod bend;
mod bent_noise;
mod combine;
mod cosines;
mod crossing;
mod cubic;
mod curvature;
mod fold;
mod footprint;
mod four_moments;
mod fractal;
mod gabor;
mod gabor_kernel;
mod gabor_paper;
mod gabor_spectrum;
mod grid;
mod hash;
mod height;
mod heights;
mod indicators;
mod irradiance;
mod lattice;
mod lattice_solid;
mod mixture;
mod moment_pyramid;
mod moments;
mod normal;
mod normals;
mod pattern;
mod percentile;
mod perlin;
mod perlin_solid;
mod perturbed;
mod piece;
mod pulse;
mod rice;
mod roughness;
mod rounds;
mod simplex;
mod slope_map;
mod slope_moments;
mod slope_nodes;
mod slopes;
mod smith;
mod split;
mod steepness;
mod tails;
mod taps;
mod texture;
mod transfer;
mod value;
mod value_solid;
mod visibility;
mod warp;

use std::fmt;

use prefilter::gpu::Address;
use prefilter::table::Table;

use crate::contract::Range;
use crate::fill::{neighbors, rounded};
use crate::kernel::Function;
use crate::signature::Scalar;

type Reference = dyn Fn(&[f64]) -> Vec<f64> + Send + Sync;

/// What a function is judged against.
pub struct Row {
    /// The function's name.
    pub name: &'static str,
    /// The tables of its texture parameters in order, and how their samplers read beyond the edges.
    pub tables: Vec<(Table, Address)>,
    reference: Box<Reference>,
    breakpoints: Vec<Vec<f64>>,
    judged: fn(&[f64]) -> bool,
    up_to_sign: bool,
}

impl fmt::Debug for Row {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "Row({})", self.name)
    }
}

impl Row {
    /// A row whose reference takes the function's numbers, flattened and rounded as its parameters hold them.
    pub fn new<const N: usize>(
        name: &'static str,
        reference: impl Fn(&[f64]) -> [f64; N] + Send + Sync + 'static,
    ) -> Self {
        Self {
            name,
            tables: Vec::new(),
            reference: Box::new(move |point| reference(point).to_vec()),
            breakpoints: Vec::new(),
            judged: |_| true,
            up_to_sign: false,
        }
    }

    /// Adds points where the function changes its form. Every number of each is also tried one step up and down.
    pub fn at<const N: usize>(mut self, points: impl IntoIterator<Item = [f64; N]>) -> Self {
        self.breakpoints.extend(points.into_iter().map(|point| point.to_vec()));
        self
    }

    /// Gives the next texture parameter its table.
    pub fn table(mut self, table: Table, address: Address) -> Self {
        self.tables.push((table, address));
        self
    }

    /// Judges only where the condition holds, because the function's documentation promises nothing elsewhere.
    pub fn only_where(mut self, condition: fn(&[f64]) -> bool) -> Self {
        self.judged = condition;
        self
    }

    /// Takes the opposite result for the same, as for an axis.
    pub fn up_to_sign(mut self) -> Self {
        self.up_to_sign = true;
        self
    }

    /// Whether the row says something about a point.
    pub fn judges(&self, point: &[f64]) -> bool {
        (self.judged)(point)
    }

    /// The reference at a point.
    pub fn expected(&self, point: &[f64], got: &[f64]) -> Vec<f64> {
        let mut expected = (self.reference)(point);
        let along: f64 = expected.iter().zip(got).map(|(expected, got)| expected * got).sum();
        if self.up_to_sign && along < 0.0 {
            expected.iter_mut().for_each(|value| *value = -*value);
        }
        expected
    }

    /// The row's own points with their neighbors.
    ///
    /// # Errors
    /// A message where a point has not as many numbers as the function takes.
    pub fn breakpoints(&self, ranges: &[Range]) -> Result<Vec<Vec<f64>>, String> {
        let scalars: Vec<Scalar> = ranges.iter().flat_map(|range| &range.leaves).map(|leaf| leaf.scalar).collect();
        let mut points = Vec::new();
        for point in &self.breakpoints {
            if point.len() != scalars.len() {
                return Err(format!(
                    "the row `{}` has points of {} numbers, not {}",
                    self.name,
                    point.len(),
                    scalars.len()
                ));
            }
            let point: Vec<f64> = point.iter().zip(&scalars).map(|(&value, &scalar)| rounded(value, scalar)).collect();
            for number in (0..point.len()).filter(|&number| scalars[number] == Scalar::Float) {
                points.extend(neighbors(point[number]).map(|value| {
                    let mut moved = point.clone();
                    moved[number] = value;
                    moved
                }));
            }
        }
        Ok(points)
    }
}

/// All rows.
pub fn all() -> Vec<Row> {
    let rooms = [
        bend::rows(),
        bent_noise::rows(),
        combine::rows(),
        cosines::rows(),
        crossing::rows(),
        cubic::rows(),
        curvature::rows(),
        fold::rows(),
        footprint::rows(),
        four_moments::rows(),
        gabor::rows(),
        gabor_kernel::rows(),
        gabor_paper::rows(),
        gabor_spectrum::rows(),
        fractal::rows(),
        grid::rows(),
        hash::rows(),
        height::rows(),
        heights::rows(),
        indicators::rows(),
        irradiance::rows(),
        lattice::rows(),
        lattice_solid::rows(),
        mixture::rows(),
        moment_pyramid::rows(),
        moments::rows(),
        normal::rows(),
        normals::rows(),
        pattern::rows(),
        percentile::rows(),
        perlin::rows(),
        perlin_solid::rows(),
        perturbed::rows(),
        piece::rows(),
        pulse::rows(),
        rice::rows(),
        roughness::rows(),
        rounds::rows(),
        simplex::rows(),
        slope_moments::rows(),
        slope_nodes::rows(),
        slope_map::rows(),
        split::rows(),
        slopes::rows(),
        smith::rows(),
        steepness::rows(),
        tails::rows(),
        taps::rows(),
        texture::rows(),
        transfer::rows(),
        value::rows(),
        value_solid::rows(),
        visibility::rows(),
        warp::rows(),
    ];
    rooms.into_iter().flatten().collect()
}

/// A sentence for every function without a row and every row without a function.
pub fn unmatched(functions: &[Function], rows: &[Row]) -> Vec<String> {
    let bare = functions.iter().filter(|function| !rows.iter().any(|row| row.name == function.name));
    let bare = bare.map(|function| format!("`{}` of wgsl/{} has no row", function.name, function.path));
    let stray = rows.iter().filter(|row| !functions.iter().any(|function| function.name == row.name));
    bare.chain(stray.map(|row| format!("the row `{}` has no function", row.name))).collect()
}
