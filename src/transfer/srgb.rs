//! The sRGB transfer function, both ways.

/// The linear value in [0, 1] of an sRGB-encoded one; values outside [0, 1] follow the same curve, mirrored at 0.
///
/// Source: IEC 61966-2-1:1999, with the rounded break at 0.04045.
pub fn to_linear(encoded: f32) -> f32 {
    let value = encoded.abs();
    let linear = if value <= 0.04045 { value / 12.92 } else { ((value + 0.055) / 1.055).powf(2.4) };
    linear.copysign(encoded)
}

/// The sRGB-encoded value of a linear one: the inverse of [`to_linear`] to f32 rounding.
pub fn from_linear(linear: f32) -> f32 {
    let value = linear.abs();
    let encoded = if value <= 0.0031308 { value * 12.92 } else { 1.055 * value.powf(1.0 / 2.4) - 0.055 };
    encoded.copysign(linear)
}

/// A color with its first three channels made linear; a fourth (alpha or a material value) stays as it is.
pub(crate) fn color_to_linear<const N: usize>(color: [f32; N]) -> [f32; N] {
    let mut linear = color;
    for value in linear.iter_mut().take(3) {
        *value = to_linear(*value);
    }
    linear
}
