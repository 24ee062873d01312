//! Inputs beyond all domains: directions about both horizons, covariances of any size and rank, any bits.

use std::f64::consts::TAU;

use crate::random::Random;

/// Whether this is a full run, which `cargo xtask test --full` asks for.
const FULL: &str = "PREFILTER_FULL";

/// How many random inputs a test tries: the usual number, and ten million in a full run.
pub fn inputs(usual: usize) -> usize {
    if std::env::var_os(FULL).is_some_and(|value| !value.is_empty()) {
        10_000_000
    } else {
        usual
    }
}

/// Random bits as a number: huge, subnormal, infinite, of both signs, never NaN; a quarter are ordinary.
pub fn number(random: &mut Random) -> f32 {
    let special = [0.0, -0.0, f32::INFINITY, f32::NEG_INFINITY, f32::MAX, f32::MIN, 1e-45, -1e-45, 1e-40];
    let value = match random.word() % 32 {
        0 => random.pick(special),
        1..=4 => (2.0 * random.unit() - 1.0) as f32,
        5..=8 => (16.0 * random.unit() - 8.0) as f32,
        _ => f32::from_bits(random.word()),
    };
    if value.is_nan() {
        0.5
    } else {
        value
    }
}

/// The numbers as a device takes them.
fn single<const N: usize>(values: [f64; N]) -> [f64; N] {
    values.map(|value| f64::from(value as f32))
}

/// The unit vector with the height z at an azimuth, in f32.
fn at(z: f64, azimuth: f64) -> [f64; 3] {
    let radius = ((1.0 - z) * (1.0 + z)).max(0.0).sqrt();
    single([radius * azimuth.cos(), radius * azimuth.sin(), z])
}

/// A direction that is anywhere, near or on the horizon from both sides, near or on the normal, along an axis.
pub fn direction(random: &mut Random) -> [f64; 3] {
    let (turn, grazing) = (TAU * random.unit(), 1e-6 * random.unit());
    let azimuth = random.pick([turn, turn, 0.0, 0.5 * TAU]);
    let small = random.pick([0.0, 1e-45, 1e-38, 1e-20, 1e-12, grazing, 1e-3]);
    let sign = random.pick([1.0, 1.0, 1.0, -1.0]);
    match random.word() % 4 {
        0 => at(sign * small, azimuth),
        1 => single([small * azimuth.cos(), small * azimuth.sin(), sign]),
        _ => at(sign * random.unit(), azimuth),
    }
}

/// A variance: none, subnormal, small, usual, huge, the largest number, infinite.
fn variance(random: &mut Random) -> f64 {
    let usual = random.between(1e-6, 4.0);
    let wide = random.between(1e-38, 3e38);
    random.pick([0.0, 1e-45, 1e-40, wide, wide, usual, usual, usual, f64::from(f32::MAX), f64::INFINITY])
}

/// A covariance (xx, xy, yy) of such variances and of any correlation, both ends included.
pub fn covariance(random: &mut Random) -> [f64; 3] {
    let [xx, yy] = [variance(random), variance(random)];
    let xx = random.pick([xx, xx, yy]);
    let even = 2.0 * random.unit() - 1.0;
    let correlation = random.pick([-1.0, 0.0, 1.0, even, even, 1.0 - 1e-7, 1e-7 - 1.0]);
    let xy = xx.sqrt() * yy.sqrt() * correlation;
    single([xx, if xy.is_nan() { 0.0 } else { xy }, yy])
}

/// A mean slope: none, usual, up to the largest number.
pub fn slope(random: &mut Random) -> [f64; 2] {
    let size = random.pick([0.0, 0.0, 0.0, 0.0, 1e-45, 1e-20, 0.5, 0.5, 10.0, 1e30, f64::from(f32::MAX)]);
    single([size * (2.0 * random.unit() - 1.0), size * (2.0 * random.unit() - 1.0)])
}
