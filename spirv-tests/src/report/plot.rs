//! Plots as SVG.

use super::document::{Axis, Plot};
use super::Error;
use plotters::coord::ranged1d::{AsRangedCoord, ValueFormatter};
use plotters::coord::Shift;
use plotters::prelude::*;
use std::ops::Range;

/// Height of a plot in pixels, and the width of what is left of its legend.
const HEIGHT: u32 = 480;
const LEFT: u32 = 510;

/// What a character of a legend is wide at most, and what stands beside it.
const CHARACTER: u32 = 8;
const BESIDE: u32 = 36;

/// Colors of series, told apart by people who see no red or no green: Okabe and Ito 2008, "Color Universal Design".
const COLORS: [RGBColor; 7] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(230, 159, 0),
    RGBColor(86, 180, 233),
    RGBColor(60, 60, 60),
];

/// A surface to draw on.
type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// The plot as the text of a file, above a line that says where and when it was measured.
///
/// # Errors
/// Those of the drawing.
pub fn svg(plot: &Plot, measured: &str) -> Result<String, Error> {
    let mut text = String::new();
    let area = SVGBackend::with_string(&mut text, (LEFT + legend(plot), HEIGHT)).into_drawing_area();
    drawn(&area, plot, measured).map_err(|error| Error::Plot(error.to_string()))?;
    drop(area);
    Ok(text)
}

/// The width of a legend: of its longest label.
fn legend(plot: &Plot) -> u32 {
    let longest = plot.series.iter().map(|series| series.label.chars().count()).max().unwrap_or(0);
    BESIDE + CHARACTER * longest as u32
}

fn drawn(area: &Area<'_>, plot: &Plot, measured: &str) -> Result<(), Box<dyn std::error::Error>> {
    area.fill(&WHITE)?;
    let foot = HEIGHT as i32 - 14;
    area.draw(&Text::new(measured.to_owned(), (10, foot), ("sans-serif", 11).into_font().color(&COLORS[6])))?;
    let kept: Vec<Vec<(f64, f64)>> = plot.series.iter().map(|series| kept(plot, &series.points)).collect();
    let all = || kept.iter().flatten().copied();
    let x = range(&plot.x, all().map(|point| point.0));
    let y = range(&plot.y, all().map(|point| point.1));
    match (plot.x.logarithmic, plot.y.logarithmic) {
        (true, true) => chart(area, plot, &kept, x.log_scale(), y.log_scale()),
        (true, false) => chart(area, plot, &kept, x.log_scale(), y),
        (false, true) => chart(area, plot, &kept, x, y.log_scale()),
        (false, false) => chart(area, plot, &kept, x, y),
    }
}

/// The points that both axes have a place for.
fn kept(plot: &Plot, points: &[[f64; 2]]) -> Vec<(f64, f64)> {
    let fits = |axis: &Axis, value: f64| value.is_finite() && (value > 0.0 || !axis.logarithmic);
    points.iter().filter(|[x, y]| fits(&plot.x, *x) && fits(&plot.y, *y)).map(|[x, y]| (*x, *y)).collect()
}

/// From the least to the greatest value, with some room on either side.
fn range(axis: &Axis, values: impl Iterator<Item = f64>) -> Range<f64> {
    let (low, high) =
        values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)));
    match (low <= high, axis.logarithmic) {
        (false, _) => 1.0..10.0,
        (true, true) => low / 1.5..high * 1.5,
        (true, false) => {
            let room = 0.05 * (high - low).max(1e-9);
            low - room..high + room
        }
    }
}

fn chart<X, Y>(
    area: &Area<'_>,
    plot: &Plot,
    kept: &[Vec<(f64, f64)>],
    x: X,
    y: Y,
) -> Result<(), Box<dyn std::error::Error>>
where
    X: AsRangedCoord<Value = f64>,
    Y: AsRangedCoord<Value = f64>,
    X::CoordDescType: ValueFormatter<f64>,
    Y::CoordDescType: ValueFormatter<f64>,
{
    let mut builder = ChartBuilder::on(area);
    builder.margin(10).margin_bottom(24).margin_right(legend(plot)).x_label_area_size(42).y_label_area_size(64);
    let mut chart = builder.build_cartesian_2d(x, y)?;
    let label = |value: &f64| {
        if *value == 0.0 || (1e-3..1e4).contains(&value.abs()) {
            format!("{value}")
        } else {
            format!("{value:.0e}")
        }
    };
    let grid = RGBColor(225, 228, 232);
    chart
        .configure_mesh()
        .x_desc(&plot.x.label)
        .y_desc(&plot.y.label)
        .x_label_formatter(&label)
        .y_label_formatter(&label)
        .light_line_style(WHITE)
        .bold_line_style(grid)
        .label_style(("sans-serif", 13))
        .draw()?;
    for (number, (series, points)) in plot.series.iter().zip(kept).enumerate() {
        let color = COLORS[number % COLORS.len()];
        if series.joined {
            chart.draw_series(LineSeries::new(points.iter().copied(), color.stroke_width(2)))?;
        }
        let (left, top) = (LEFT as i32 + 14, 24 + 20 * number as i32);
        area.draw(&Text::new(series.label.clone(), (left + 12, top), ("sans-serif", 13)))?;
        // Colors begin anew with another mark.
        if (number / COLORS.len()).is_multiple_of(2) {
            chart.draw_series(points.iter().map(|point| Circle::new(*point, 4, color.filled())))?;
            area.draw(&Circle::new((left, top + 7), 4, color.filled()))?;
        } else {
            chart.draw_series(points.iter().map(|point| Cross::new(*point, 4, color.stroke_width(2))))?;
            area.draw(&Cross::new((left, top + 7), 4, color.stroke_width(2)))?;
        }
    }
    area.present()?;
    Ok(())
}
