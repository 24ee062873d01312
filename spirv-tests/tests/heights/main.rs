//! Visible heights: the reference against printed values and a second quadrature, what the paper's fits are worth, and
//! the figures that the crate promises for the shelf's functions on a device.

mod device;
mod extremes;
mod paper;
mod references;
mod steps;

/// `count` values of Λ, even in their logarithm, with both ends.
fn lambdas(low: f64, high: f64, count: u32) -> impl Iterator<Item = f64> {
    (0..count).map(move |index| low * (high / low).powf(f64::from(index) / f64::from(count - 1)))
}
