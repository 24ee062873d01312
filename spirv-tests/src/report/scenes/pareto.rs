//! Speed against error of a scene's methods.

use super::row::Row;
use crate::report::document::{Axis, Plot, Series};

/// The plot of some methods' rows and of brute force's, which a line joins.
pub fn plot(stem: &str, caption: &str, methods: &[Row], brute: &[Row]) -> Plot {
    let point = |row: &Row| [row.milliseconds, row.rms.value];
    let axis = |label: &str| Axis { label: label.into(), logarithmic: true };
    let alone = methods.iter().map(|row| Series { label: row.method.clone(), points: vec![point(row)], joined: false });
    let joined = Series { label: "stratified samples".into(), points: brute.iter().map(point).collect(), joined: true };
    Plot {
        stem: stem.into(),
        caption: caption.into(),
        x: axis("ms a million pixels"),
        y: axis("RMS error"),
        series: alone.chain([joined]).collect(),
    }
}
