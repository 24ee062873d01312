//! Noises of the plane with their second derivatives: polynomials, by differences; and what they tell of a footprint.

use prefilter::reference::bent_noise::{perlin, simplex, simplex_part, value};
use prefilter::reference::retained::Noise;

use super::lattice::{ordered, whole};
use super::Row;

fn filter(name: &'static str, noise: Noise) -> Row {
    Row::new(name, move |x| noise.bent([x[0], x[1]]).unwrap_or([f64::NAN; 5])).only_where(ordered)
}

pub(super) fn rows() -> Vec<Row> {
    vec![
        Row::new("bent_noise_perlin", |x| perlin([x[0], x[1]], whole(&x[2..]), x[4] as u32)),
        Row::new("bent_noise_value", |x| value([x[0], x[1]], whole(&x[2..]), x[4] as u32)),
        Row::new("bent_noise_simplex", |x| simplex([x[0], x[1]], x[2] as u32)),
        Row::new("bent_noise_simplex_part", |x| simplex_part([x[0], x[1]], [x[2], x[3]])),
        filter("bent_noise_perlin_filter", Noise::Perlin),
        filter("bent_noise_value_filter", Noise::Value),
        filter("bent_noise_simplex_filter", Noise::Simplex),
    ]
}
