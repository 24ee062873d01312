//! Question 3: how far are the slopes in sight of height fields from D_s? `docs/slope_gap.csv` within the noise of four
//! seeds, and what brute force keeps whatever the model.

use std::collections::BTreeMap;
use std::f64::consts::SQRT_2;

use prefilter::reference::slopes::standard::{moments, weight};
use spirv_tests::gap::field::{Field, Spectrum};
use spirv_tests::gap::sight::{Sight, OVERHEAD};
use spirv_tests::gap::slopes::sloped;
use spirv_tests::gap::study::Extent;

const TABLE: &str = include_str!("../../../docs/slope_gap.csv");

/// The rows of the table as its columns' names with their cells.
fn rows() -> Vec<BTreeMap<&'static str, &'static str>> {
    let (header, rows) = TABLE.split_once('\n').expect("a header");
    rows.lines().map(|row| header.split(',').zip(row.split(',')).collect()).collect()
}

#[test]
fn the_committed_table_is_what_is_measured() {
    let extent = Extent { size: 1024, grain: 32.0, seeds: 4 };
    let parameters = [60.0f64, 80.0].map(|degrees| 1.0 / (degrees.to_radians().tan() * SQRT_2 * 0.7));
    let rows = rows();
    let mut stated = 0;
    for spectrum in Spectrum::ALL {
        for (seen, degrees) in sloped(spectrum, extent, &parameters, &|| ()).iter().zip(["60", "80"]) {
            let row = rows.iter().find(|row| (row["spectrum"], row["degrees"]) == (spectrum.name(), degrees));
            let row = row.expect("a row of the table");
            let figures = [
                ("mean", seen.mean),
                ("deviation", seen.deviation),
                ("step_model", seen.step_model),
                ("step_normal", seen.step_normal),
                ("step_unweighted", seen.step_unweighted),
            ];
            for (column, figure) in figures.into_iter().filter(|(_, figure)| figure.stands()) {
                let number = |name: &str| row[name].parse::<f64>().expect("a figure that is stated");
                let (known, error) = (number(column), number(&format!("{column}_se")));
                println!("{} {degrees} {column}: {figure:?}, {known} ± {error}", spectrum.name());
                // Chance moves the largest of many differences up, which is no part of its standard error.
                let largest = if column.starts_with("step") { 0.1 * known } else { 0.0 };
                assert!((figure.value - known).abs() <= 4.0 * figure.error.hypot(error) + largest, "{column}");
                stated += 1;
            }
        }
    }
    // A step error of the fields with the longest correlation may be lost in chance.
    assert!(stated >= 37, "{stated}");
}

#[test]
fn the_documentation_quotes_the_table() {
    let documentation = include_str!("../../src/gap/slopes.rs");
    for name in Spectrum::ALL.map(Spectrum::name) {
        let largest = |column: &str| {
            let rows = rows().into_iter().filter(|row| row["spectrum"] == name);
            rows.filter_map(|row| row[column].parse().ok()).fold(0.0, f64::max)
        };
        let [model, normal, all] = ["step_model", "step_normal", "step_unweighted"].map(largest);
        let line = format!("| {name} | {model:.3} | {normal:.3} | {all:.3} |");
        assert!(documentation.contains(&line), "{line}");
    }
}

/// Where nothing hides anything else D_s is what is seen, but for the slopes that a field has by chance.
#[test]
fn a_tilted_view_that_sees_all_sees_the_distribution() {
    let [field, _] = Field::pair(Spectrum::Rough, 512, 8.0, 9);
    for parameter in [2.6, OVERHEAD] {
        let sight = Sight::along_rows(&field, parameter);
        let [mean, deviation, _] = sight.slopes.moments();
        let [against, variance, _] = moments(SQRT_2 * parameter);
        println!("{parameter}: mean {mean} {against}, deviation {deviation} {}", variance.sqrt());
        assert!((mean + against).abs() < 2e-3 && (deviation - variance.sqrt()).abs() < 5e-3, "{parameter}");
    }
    // All that faces the viewer, hidden or not, has the area that the weight gives it.
    for parameter in [0.1, 0.5] {
        let sight = Sight::along_rows(&field, parameter);
        let area = weight(SQRT_2 * parameter) / (SQRT_2 * parameter);
        assert!((sight.facing_area / sight.ground_area / area - 1.0).abs() < 0.02, "{parameter}");
    }
}
