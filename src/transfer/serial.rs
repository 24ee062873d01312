//! Serialization of color maps, irradiance, maps of slopes and height transfers through their parts, so that what is
//! read back has passed every check.

use super::color_map::{ColorMap, Knot, MAX_COLOR};
use super::height_transfer::HeightTransfer;
use super::irradiance::Irradiance;
use super::shape::Shape;
use super::slope_map::{SlopeDomain, SlopeMap};
use crate::Error;

#[derive(serde::Serialize, serde::Deserialize)]
pub(super) struct Parts {
    channels: usize,
    knots: Vec<Knot>,
}

impl From<ColorMap> for Parts {
    fn from(map: ColorMap) -> Self {
        Self { channels: map.channels, knots: map.knots }
    }
}

impl TryFrom<Parts> for ColorMap {
    type Error = Error;

    fn try_from(parts: Parts) -> Result<Self, Error> {
        if parts.channels != 3 && parts.channels != 4 {
            let what = "the channels of a color".into();
            return Err(Error::Size { what, count: parts.channels, allowed: "3 or 4".into() });
        }
        let fourth = parts.knots.iter().flat_map(|knot| [knot.left[3], knot.right[3]]).find(|&fourth| fourth != 0.0);
        if let (3, Some(fourth)) = (parts.channels, fourth) {
            return Err(Error::value("the fourth channel of a map with three", fourth, "0"));
        }
        Self::from_knots(parts.knots, parts.channels)
    }
}

/// The terms of an irradiance.
#[derive(serde::Serialize, serde::Deserialize)]
pub(super) struct Terms {
    polynomial: [[f32; 3]; 9],
}

impl From<Irradiance> for Terms {
    fn from(irradiance: Irradiance) -> Self {
        Self { polynomial: *irradiance.polynomial() }
    }
}

impl TryFrom<Terms> for Irradiance {
    type Error = Error;

    /// Of coefficients up to 65504 no term is more than 1.4 times that, of the radiances of an image π times.
    fn try_from(Terms { polynomial }: Terms) -> Result<Self, Error> {
        let limit = 4.0 * MAX_COLOR;
        for (term, color) in polynomial.iter().enumerate() {
            if let Some(value) = color.iter().find(|value| !(value.abs() <= limit)) {
                let what = format!("the color of term {term} of the irradiance");
                return Err(Error::value(what, *value, format!("a number from -{limit} to {limit}")));
            }
        }
        Ok(Self { polynomial })
    }
}

/// The parts of a map of slopes.
#[derive(serde::Serialize, serde::Deserialize)]
pub(super) struct Grid {
    channels: usize,
    domain: SlopeDomain,
    size: usize,
    colors: Vec<[f32; 4]>,
}

impl From<SlopeMap> for Grid {
    fn from(map: SlopeMap) -> Self {
        Self { channels: map.channels, domain: map.domain, size: map.size, colors: map.colors }
    }
}

impl TryFrom<Grid> for SlopeMap {
    type Error = Error;

    fn try_from(Grid { channels, domain, size, colors }: Grid) -> Result<Self, Error> {
        if channels != 3 && channels != 4 {
            let what = "the channels of a color".into();
            return Err(Error::Size { what, count: channels, allowed: "3 or 4".into() });
        }
        let fourth = colors.iter().map(|color| color[3]).find(|&fourth| fourth != 0.0);
        if let (3, Some(fourth)) = (channels, fourth) {
            return Err(Error::value("the fourth channel of a map with three", fourth, "0"));
        }
        Self::checked(domain, size, colors, channels)
    }
}

/// The parts of a height transfer.
#[derive(serde::Serialize, serde::Deserialize)]
pub(super) struct Curve {
    shape: Shape,
    amplitude: f32,
    offset: f32,
    values: Option<((f32, f32), f32)>,
}

impl From<HeightTransfer> for Curve {
    fn from(HeightTransfer { shape, amplitude, offset, values, .. }: HeightTransfer) -> Self {
        Self { shape, amplitude, offset, values }
    }
}

impl TryFrom<Curve> for HeightTransfer {
    type Error = Error;

    fn try_from(Curve { shape, amplitude, offset, values }: Curve) -> Result<Self, Error> {
        let curve = Self::new(shape, amplitude, offset)?;
        Ok(values.map_or(curve.clone(), |(mean, deviation)| curve.over(mean, deviation)))
    }
}
