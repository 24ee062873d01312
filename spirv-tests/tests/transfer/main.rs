//! Height transfer functions: curves, their moments, and the surfaces that they make.

mod curve;
mod fields;
mod moments;
mod narrow;

use prefilter::{Error, HeightTransfer};

type Outcome = Result<(), Box<dyn std::error::Error + Send + Sync>>;

/// A curve's name, the curve, and the values between which all of it happens.
type Curve = (&'static str, HeightTransfer, [f64; 2]);

/// One of each kind.
fn curves() -> Result<Vec<Curve>, Error> {
    Ok(vec![
        ("knots", HeightTransfer::knots([(-0.5, 0.2), (0.1, 0.9), (0.3, 0.4), (1.1, 0.4)])?, [-1.0, 1.5]),
        ("samples", HeightTransfer::samples(-0.4, 0.9, &[0.1, 0.3, 0.35, 0.35, 0.9, 0.2, 0.6])?, [-1.0, 1.5]),
        ("smoothstep", HeightTransfer::smoothstep(-0.7, 0.4)?, [-1.0, 1.0]),
        ("absolute", HeightTransfer::absolute(), [-1.0, 1.3]),
        ("terraces", HeightTransfer::terraces(5, 0.3)?, [-0.2, 1.3]),
        ("ramps", HeightTransfer::terraces(3, 1.0)?, [-0.2, 1.3]),
        ("line", HeightTransfer::power(1.0)?, [-1.0, 1.3]),
        ("square", HeightTransfer::power(2.0)?, [-1.0, 1.3]),
        ("cube", HeightTransfer::power(3.0)?, [-1.0, 1.3]),
        ("power", HeightTransfer::power(1.7)?, [-1.0, 1.3]),
        ("scaled", HeightTransfer::power(2.0)?.scaled(-0.3, 2.0)?.scaled(2.0, 0.1)?, [-1.0, 1.3]),
    ])
}
