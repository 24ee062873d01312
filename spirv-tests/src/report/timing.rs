//! How long kernels take beside each other.
//!
//! On a device that is a processor, clocks and neighbors change between runs by more than kernels differ. All take
//! turns in one run, and the fastest of many turns of each is what nothing disturbed.

use prefilter::gpu::Dispatch;
use prefilter::Error;

/// Turns that a ratio of two kernels is stated from.
pub const TURNS: usize = 31;

/// Seconds of the fastest of `turns` runs of each kernel, which take turns, backwards in every other round, after one
/// that is not timed.
///
/// # Errors
/// What the device refuses.
pub fn fastest(kernels: &[Dispatch], turns: usize) -> Result<Vec<f64>, Error> {
    let mut seconds = vec![f64::INFINITY; kernels.len()];
    for turn in 0..=turns {
        let mut order: Vec<usize> = (0..kernels.len()).collect();
        if turn % 2 == 1 {
            order.reverse();
        }
        for number in order {
            let time = kernels[number].time()?;
            if turn > 0 {
                seconds[number] = seconds[number].min(time);
            }
        }
    }
    Ok(seconds)
}
