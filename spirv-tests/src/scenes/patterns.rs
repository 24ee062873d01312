//! Scenes that are driven by patterns of two values.

use prefilter::driver::pattern::Motif;
use prefilter::{Driver, Pattern, Scene, Tier};

use super::{Result, FAST};
use crate::maps::named;

/// The scenes that are driven by patterns.
///
/// # Errors
/// As [`super::all`].
pub(super) fn all() -> Result<Vec<(&'static str, Scene)>> {
    let checker = Pattern::default();
    let grid = Pattern { motif: Motif::Grid { widths: [0.1, 0.05] }, values: [0.9, 0.2], ..checker };
    let tiles = Scene::new("tiles").texture(named("terrain")?);
    Ok(vec![
        ("pattern_checker", tiles.clone().tier(FAST).driver(Driver::Pattern(checker))),
        ("pattern_grid", tiles.tier(Tier::Table).driver(Driver::Pattern(grid))),
    ])
}
