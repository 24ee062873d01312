//! Modules against the f64 integral, over the points where filters go wrong.

use prefilter::gpu::Device;
use prefilter::reference::texture;
use prefilter::{ColorMap, Module, Ranges};

use crate::exports::ExportKernel;

/// Knots that get points of their own.
const KNOTS: usize = 256;

/// Means and deviations in ranges, from a deviation of 1e-6: `count` of an additive recurrence over means and
/// logarithms of deviations, for each of up to 256 knots means at some deviations from it on both sides, and the
/// corners.
pub fn points(map: &ColorMap, ranges: Ranges, count: u32) -> Vec<f32> {
    let (low, high) = ranges.mean;
    let reach = f64::from(ranges.deviation);
    let deviation = move |part: f64| (1e-6f64.ln() + part * (reach.ln() - 1e-6f64.ln())).exp() as f32;
    let even = (0..count).flat_map(|index| {
        // The plastic number's inverse powers: the most even recurrence in two dimensions.
        let part = |step: f64| (0.5 + f64::from(index) * step).fract();
        let mean = f64::from(low) + part(0.754_877_666_246_692_7) * (f64::from(high) - f64::from(low));
        [mean as f32, deviation(part(0.569_840_290_998_053_2))]
    });
    let some = map.knots().len().div_ceil(KNOTS);
    let knots = map.knots().iter().step_by(some).flat_map(|knot| {
        (0..=24).flat_map(move |index| {
            let sigma = deviation(f64::from(index) / 24.0);
            [-2.3, -0.7, 0.0, 0.4, 1.9].into_iter().flat_map(move |offset: f32| [knot.position + offset * sigma, sigma])
        })
    });
    let corners = [low, high].into_iter().flat_map(|mean| [mean, 1e-6, mean, ranges.deviation]);
    let inside = |point: &[f32]| (low..=high).contains(&point[0]) && point[1] <= ranges.deviation;
    let all: Vec<f32> = even.chain(knots).chain(corners).collect();
    all.chunks_exact(2).filter(|point| inside(point)).flatten().copied().collect()
}

/// The largest error of the module's C0 export over the points, where the map is in f32 and the integral in f64.
///
/// # Errors
/// What the device refuses.
///
/// # Panics
/// At a color that is not finite or leaves the hull.
pub fn measured(device: &Device, module: &Module, map: &ColorMap, points: &[f32]) -> Result<f32, prefilter::Error> {
    let colors = ExportKernel::new(device, module, &module.exports()[0])?.run(points)?;
    let reference = map.reference();
    let (low, high) = map.hull();
    let mut worst = 0.0f64;
    assert!(!colors.is_empty() && colors.len() == points.len() / 2);
    // Colors in tables are halves, and so may be their hull's: eleven bits, and below 6e-5 multiples of 6e-8.
    let halves = module.tables().iter().any(|table| table.format == prefilter::table::Format::Rgba16Float);
    for (color, point) in colors.iter().zip(points.chunks_exact(2)) {
        let truth = texture::mean(&reference, point[0].into(), point[1].into());
        for channel in 0..map.channels() {
            let error = (f64::from(color[channel]) - truth[channel]).abs();
            assert!(error.is_finite(), "{} at {point:?}: {color:?}", module.name());
            let slack = if halves { 5e-4 * high[channel].abs().max(low[channel].abs()) + 3e-8 } else { 0.0 };
            let hull = low[channel] - slack..=high[channel] + slack;
            assert!(hull.contains(&color[channel]), "{} at {point:?} leaves the hull: {color:?}", module.name());
            worst = worst.max(error);
        }
    }
    Ok(worst as f32)
}
