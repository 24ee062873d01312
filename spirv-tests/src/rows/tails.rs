//! Ch by shorter tails: means of pieces of color maps over visible heights, as those of `height.rs`.

use prefilter::reference::tails::nearest_short_tails;

use super::height::{kink, ramp, step, visible, widths, NARROWEST, STEPS};
use super::Row;

pub(super) fn rows() -> Vec<Row> {
    vec![
        Row::new("tails_skewed", |x| nearest_short_tails(x[0], visible(x[1])[0].exp2() - 1.0)),
        Row::new("tails_excess", |x| [kink(x)[0] - x[0].max(0.0)]).at(STEPS),
        Row::new("tails_kink", kink).at(STEPS),
        Row::new("tails_step", step).at(STEPS),
        Row::new("tails_ramp", ramp).at(widths()).at([NARROWEST]),
    ]
}
