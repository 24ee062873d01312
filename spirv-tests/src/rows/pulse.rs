//! Steps, pulses and trains: what of the footprint is filled, by quadrature.

use prefilter::reference::pulse::Footprint;

use super::Row;

pub(super) fn rows() -> Vec<Row> {
    let trains = [[0.2, 0.5, 0.16], [0.0, 0.5, 0.01], [-0.5, 0.5, 0.15], [0.5, 1.0, 0.05], [7.5, 0.02, 0.17]];
    // The last two end a narrow box at the pulse before, where sums round if they are not taken with care.
    let boxes = [[0.2, 0.5, 1.0], [-0.193, 0.808, 0.001], [-0.3, 0.7004, 0.001]];
    vec![
        Row::new("pulse_step", |x| [Footprint::Gaussian(x[2]).step(x[0], x[1])]),
        Row::new("pulse_step_box", |x| [Footprint::Box(x[2]).step(x[0], x[1])]),
        Row::new("pulse_mean", |x| [Footprint::Gaussian(x[3]).pulse(x[0], x[1], x[2])]),
        Row::new("pulse_box", |x| [Footprint::Box(x[3]).pulse(x[0], x[1], x[2])]),
        Row::new("pulse_train", |x| [Footprint::Gaussian(x[2]).train(x[0], x[1])]).at(trains),
        Row::new("pulse_waves", |x| [Footprint::Gaussian(x[2]).train(x[0] + 0.5 * x[1], x[1]) - x[1]]),
        Row::new("pulse_train_box", |x| [Footprint::Box(x[2]).train(x[0], x[1])]).at(boxes),
    ]
}
