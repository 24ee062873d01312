//! How long kernels take beside each other.
//!
//! On a device that is a processor, clocks and neighbors change between runs by more than kernels differ. All take
//! turns in one run, and the fastest of many turns of each is what nothing disturbed.

use super::Extent;
use prefilter::gpu::Dispatch;
use prefilter::Error;

/// Turns that a ratio of two kernels is stated from, in a quick report and in a full one.
const TURNS: [usize; 2] = [7, 31];

/// At most so many invocations are timed: more than a GPU takes at once by some times.
const MOST: usize = 1 << 21;

/// An invocation's time that falls by less than a tenth with four times as many is that of a device that is full.
const FULL: f64 = 0.9;

/// Seconds below which a run is mostly the device's start and end.
pub const SHORT: f64 = 1e-4;

/// Seconds below which the last of a GPU's waves is some percent of a run, for the kernels whose ratios are asked for.
pub const WAVES: f64 = 1e-3;

/// A kernel over so many invocations that more take no less time each, and how many: `from`, or four times as many for
/// as long as a run takes less than `seconds` or that makes each a tenth cheaper. `prepare` is told how many.
///
/// # Errors
/// What the device refuses.
pub fn filling<E: From<Error>>(
    from: usize,
    seconds: f64,
    prepare: impl Fn(usize) -> Result<Dispatch, E>,
) -> Result<(Dispatch, usize), E> {
    let of = |count: usize| -> Result<(Dispatch, f64), E> {
        let dispatch = prepare(count)?;
        dispatch.time()?;
        let each = dispatch.time()?.min(dispatch.time()?) / count as f64;
        Ok((dispatch, each))
    };
    let (mut count, mut best) = (from.max(1), of(from.max(1))?);
    // What a device cannot hold ends the search, too.
    while let Some(more) = (4 * count <= MOST).then(|| of(4 * count).ok()).flatten() {
        if best.1 * count as f64 >= seconds && more.1 > FULL * best.1 {
            break;
        }
        (count, best) = (4 * count, more);
    }
    Ok((best.0, count))
}

/// The size of a picture whose pixels fill the device with a kernel: the given one, or larger by a power of 2.
///
/// # Errors
/// What the device refuses.
pub fn enlarged<E: From<Error>>(
    [width, height]: [usize; 2],
    prepare: impl Fn([usize; 2]) -> Result<Dispatch, E>,
) -> Result<[usize; 2], E> {
    let pixels = width * height;
    let sides = |count: usize| [width, height].map(|side| side * (count / pixels).isqrt());
    Ok(sides(filling(pixels, SHORT, |count| prepare(sides(count)))?.1))
}

/// How many times over a list of so many taps fills the device with a kernel.
///
/// # Errors
/// What the device refuses.
pub fn times_over<E: From<Error>>(taps: usize, prepare: impl Fn(usize) -> Result<Dispatch, E>) -> Result<usize, E> {
    let taps = taps.max(1);
    Ok(filling(taps, SHORT, |count| prepare(count / taps))?.1 / taps)
}

/// `count` points of the numbers of `points`, over and over.
pub fn repeated(numbers: &[f32], points: usize, count: usize) -> Vec<f32> {
    numbers.iter().copied().cycle().take(count * numbers.len() / points).collect()
}

/// Seconds of the fastest of 31 runs of each kernel, of 7 in a quick report, which take turns, backwards in every other
/// round, after one that is not timed.
///
/// # Errors
/// What the device refuses.
pub fn fastest(kernels: &[Dispatch], extent: Extent) -> Result<Vec<f64>, Error> {
    let [few, many] = TURNS;
    let mut seconds = vec![f64::INFINITY; kernels.len()];
    for turn in 0..=extent.pick(few, many) {
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
