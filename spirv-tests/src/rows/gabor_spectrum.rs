//! Spectra of Gabor noise: what footprints leave of the variance, by quadrature and by differences.

use prefilter::reference::gabor_spectrum::{retained, retained_evenly, variance, Spectrum};

use super::Row;

/// The spectrum in a flattened list of numbers.
pub(super) fn spectrum(parts: &[f64]) -> Spectrum {
    Spectrum { frequency: [parts[0], parts[1]], azimuth: [parts[2], parts[3]], height: [parts[4], parts[5]] }
}

/// The two vectors of a footprint.
pub(super) fn footprint(parts: &[f64]) -> [[f64; 3]; 2] {
    [[parts[0], parts[1], parts[2]], [parts[3], parts[4], parts[5]]]
}

pub(super) fn rows() -> Vec<Row> {
    vec![
        Row::new("gabor_spectrum_of", |x| spectrum(x).shares()),
        Row::new("gabor_spectrum_frequency", |x| spectrum(&x[2..]).frequency([x[0] as u32, x[1] as u32])),
        Row::new("gabor_spectrum_retained", |x| retained([x[0], x[1], x[2]], footprint(&x[3..]))),
        Row::new("gabor_spectrum_retained_evenly", |x| retained_evenly(x[0], footprint(&x[1..]))),
        Row::new("gabor_spectrum_variance", |x| [variance([x[0], x[1]], [x[2], x[3]])]),
    ]
}
