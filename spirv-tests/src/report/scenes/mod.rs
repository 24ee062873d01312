//! The examples' scenes with all methods side by side: those that people use where there is no filter, the recipe of
//! Heitz et al. 2014, the generated modules, and stratified supersampling.
//!
//! Every scene has the same table, a plot of speed against error, and a sheet of pictures with their errors.

pub mod cliffs;
pub mod demo;
pub mod frame;
pub mod measured;
pub mod moss;
pub mod noise;
pub mod pareto;
pub mod progress;
pub mod rays;
pub mod rough;
pub mod row;
pub mod sheet;
pub mod snake;

use super::document::{Item, Section};
use super::{Bench, Error, Extent};
use measured::Measured;
use sheet::View;

/// A demo: the steps of its scenes, and what the report shows of them.
type Demo = (fn(Extent) -> u64, fn(&Bench<'_>) -> Result<Vec<Item>, Error>);

/// All of them.
const DEMOS: [Demo; 6] = [
    (demo::steps, demo::items),
    (noise::steps, noise::items),
    (rough::steps, rough::items),
    (snake::steps, snake::items),
    (cliffs::steps, cliffs::items),
    (moss::steps, moss::items),
];

/// Steps of this part.
pub fn steps(extent: Extent) -> u64 {
    DEMOS.iter().map(|(steps, _)| steps(extent)).sum()
}

/// Measures it.
///
/// # Errors
/// Those of scenes and of the device.
pub fn section(bench: &Bench<'_>) -> Result<Section, Error> {
    let mut items = vec![Item::Text(LEGEND.into())];
    for (_, demo) in DEMOS {
        items.extend(demo(bench)?);
    }
    Ok(Section { stem: "scenes".into(), title: "The examples' scenes, side by side".into(), items })
}

/// What all tables have alike.
const LEGEND: &str = "\
    Errors are those of a pixel's worst channel, in linear color, against supersampling that shares no pyramid, \
    table or formula with the methods, over the pixels where truth and methods see something. RMS: without the \
    variance of the truth, which 99 % and max still have; the error of a maximum is how much those of the places \
    differ. Shimmer: the deviation of the error over the frames of a zoom and of a sub-pixel pan, root mean square \
    over the pixels that the surface covers in all frames, without the truth's own; that of many samples is not \
    measured where the truth has not many more. ms/Mpixel: the fastest of 31 turns, of 7 in a quick report, that all \
    kernels of a scene take on the device, over as many pixels as fill it, with one thread where it is a processor. \
    Over naive, same driver: that over the kernel of the naive tier, which reads the same statistics of the same \
    driver with as many taps; where a method asks no driver, over the naive method's. Operations are those of the \
    heaviest function of each generated module that a method calls. Samples for its RMS: stratified samples a pixel \
    at which brute force is as near to the truth, and how much faster than those the method is; a quick report has \
    fewer than 1024 in some scenes.";

/// What the report shows of a scene.
fn shown(stem: &str, title: &str, measured: &Measured, views: &[View]) -> Vec<Item> {
    let (methods, brute) = measured.rows();
    let rows: Vec<row::Row> = methods.iter().chain(&brute).cloned().collect();
    vec![
        Item::Table(row::table(stem, &format!("{title}. {}", measured.over), &rows)),
        Item::Plot(pareto::plot(
            &format!("{stem}_pareto"),
            &format!("Speed against error: {title}."),
            &methods,
            &brute,
        )),
        Item::Sheet(sheet::sheet(&format!("{stem}_sheet"), &format!("Pictures and errors: {title}."), views)),
    ]
}
