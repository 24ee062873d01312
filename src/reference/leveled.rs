//! What a point's slope tells of the mean slope over a Gaussian footprint that lies in all ways on the noise's lattice:
//! by quadrature of the noise's autocorrelation over all directions.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};
use std::sync::OnceLock;

use super::lattice::weight;
use super::quadrature::integrate;
use super::retained::{correlation, graded, overlap, Noise};

/// The share of a point's slope along the two axes of a footprint that its mean slope is best told without.
///
/// Given the slope g at the point, a Gaussian process has the mean −∇∇R(x) g/λ at an offset x. Over the footprint that
/// is the mean of R times the second Hermite polynomials of the offset.
pub fn leveled(noise: Noise, [x, y]: [f64; 2]) -> [f64; 2] {
    let bent = bent(round(noise), [x.max(y), x.min(y)]);
    let [along, across] = bent.map(|bent| 1.0 + bent / noise.slopes());
    if x < y {
        [across, along]
    } else {
        [along, across]
    }
}

/// Distances, weights and the mean of R over all directions there.
fn round(noise: Noise) -> &'static [[f64; 3]] {
    static ALL: [OnceLock<Vec<[f64; 3]>>; 4] = [const { OnceLock::new() }; 4];
    let nodes = |end: f64, mean: &dyn Fn(f64) -> f64| {
        graded(end).into_iter().map(|[distance, weight]| [distance, weight, mean(distance)]).collect()
    };
    ALL[noise as usize].get_or_init(|| match noise {
        Noise::Simplex => {
            let whole = overlap(0.0);
            nodes(2f64.sqrt(), &|distance| overlap(distance) / whole)
        }
        _ => nodes(8f64.sqrt(), &|distance| mean(noise, distance)),
    })
}

/// The mean over an eighth of a turn, of which the others are images.
fn mean(noise: Noise, distance: f64) -> f64 {
    let line = |t: f64| t * weight(t);
    let whole = [correlation(weight, 0.0), correlation(line, 0.0)];
    let [sum] = integrate(0.0, FRAC_PI_4, FRAC_PI_4 / 4.0, |angle| {
        let (sin, cos) = libm::sincos(angle);
        let [x, y] = [distance * cos, distance * sin]
            .map(|part| [correlation(weight, part) / whole[0], correlation(line, part) / whole[1]]);
        let lines = 0.5 * (x[0] * y[1] + x[1] * y[0]);
        let weights = x[0] * y[0];
        [match noise {
            Noise::Value => weights,
            Noise::PerlinSolid => (2.0 * lines + weights) / 3.0,
            _ => lines,
        }]
    });
    sum / FRAC_PI_4
}

/// The mean second derivatives of R along the major and the minor axis.
fn bent(nodes: &[[f64; 3]], [major, minor]: [f64; 2]) -> [f64; 2] {
    let mut sums = [0.0; 2];
    for &[distance, weight, value] in nodes {
        let far = distance / major;
        if far > 9.0 {
            continue;
        }
        // exp(−½ r² (cos²/a² + sin²/b²)) falls from the major axis on, within an angle of 1/√sharp.
        let sharp = 0.5 * distance * distance * (1.0 / (minor * minor) - 1.0 / (major * major));
        let end = (7.0 / sharp.max(1e-9).sqrt()).min(FRAC_PI_2);
        let [all, across] = integrate(0.0, end, 0.5 * end, |angle| {
            let square = libm::sin(angle).powi(2);
            let density = libm::exp(-sharp * square);
            [density, density * square]
        });
        let ring = 2.0 * weight * distance * libm::exp(-0.5 * far * far) * value / (PI * major * minor);
        for ((sum, part), deviation) in sums.iter_mut().zip([all - across, across]).zip([major, minor]) {
            *sum += ring * ((distance / deviation).powi(2) * part - all) / (deviation * deviation);
        }
    }
    sums
}
