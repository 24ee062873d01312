//! Serialization of color maps through their parts, so that a map read back has passed every check.

use super::color_map::{ColorMap, Knot};
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
