//! Question 3: how far are the slopes in sight of height fields, and their lengths, from D_s? `docs/slope_gap.csv` and
//! `docs/steepness_gap.csv` within the noise of four seeds, and what brute force keeps whatever the model.

use std::collections::BTreeMap;
use std::f64::consts::{PI, SQRT_2};

use prefilter::reference::slopes::standard::{moments, weight};
use spirv_tests::gap::field::{Field, Spectrum};
use spirv_tests::gap::figure::Figure;
use spirv_tests::gap::sight::{Sight, OVERHEAD};
use spirv_tests::gap::slopes::{sloped, Sloped};
use spirv_tests::gap::steepness::{lengths, steep, Steep};
use spirv_tests::gap::study::Extent;

const SLOPES: &str = include_str!("../../../docs/slope_gap.csv");
const LENGTHS: &str = include_str!("../../../docs/steepness_gap.csv");

/// Columns of a direction with what was measured.
type Figures = Vec<(&'static str, Figure)>;

/// The rows of a table as its columns' names with their cells.
fn rows(table: &'static str) -> Vec<BTreeMap<&'static str, &'static str>> {
    let (header, rows) = table.split_once('\n').expect("a header");
    rows.lines().map(|row| header.split(',').zip(row.split(',')).collect()).collect()
}

/// How many figures at 60 and 80 degrees stand; all that do are those of a table.
fn stated(table: &'static str, seen: impl Fn(Spectrum, Extent, &[f64]) -> Vec<Figures>) -> usize {
    let extent = Extent { size: 1024, grain: 32.0, seeds: 4 };
    let parameters = [60.0f64, 80.0].map(|degrees| 1.0 / (degrees.to_radians().tan() * SQRT_2 * 0.7));
    let rows = rows(table);
    let mut stated = 0;
    for spectrum in Spectrum::ALL {
        for (figures, degrees) in seen(spectrum, extent, &parameters).into_iter().zip(["60", "80"]) {
            let row = rows.iter().find(|row| (row["spectrum"], row["degrees"]) == (spectrum.name(), degrees));
            let row = row.expect("a row of the table");
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
    stated
}

#[test]
fn the_committed_table_is_what_is_measured() {
    let seen = |spectrum, extent, parameters: &[f64]| {
        let all = sloped(spectrum, extent, parameters, &|| ()).into_iter();
        let figures = |seen: Sloped| {
            vec![
                ("mean", seen.mean),
                ("deviation", seen.deviation),
                ("step_model", seen.step_model),
                ("step_normal", seen.step_normal),
                ("step_unweighted", seen.step_unweighted),
            ]
        };
        all.map(figures).collect()
    };
    let stated = stated(SLOPES, seen);
    // A step error of the fields with the longest correlation may be lost in chance.
    assert!(stated >= 37, "{stated}");
}

#[test]
fn the_committed_table_of_lengths_is_what_is_measured() {
    let seen = |spectrum, extent, parameters: &[f64]| {
        let all = steep(spectrum, extent, parameters, &|| ()).into_iter();
        let figures = |seen: Steep| {
            vec![
                ("mean", seen.mean),
                ("step_model", seen.step_model),
                ("step_rice", seen.step_rice),
                ("step_unweighted", seen.step_unweighted),
            ]
        };
        all.map(figures).collect()
    };
    let stated = stated(LENGTHS, seen);
    assert!(stated >= 24, "{stated}");
}

#[test]
fn the_documentation_quotes_the_tables() {
    for (table, documentation, second) in [
        (SLOPES, include_str!("../../src/gap/slopes.rs"), "step_normal"),
        (LENGTHS, include_str!("../../src/gap/steepness.rs"), "step_rice"),
    ] {
        for name in Spectrum::ALL.map(Spectrum::name) {
            let largest = |column: &str| {
                let rows = rows(table).into_iter().filter(|row| row["spectrum"] == name);
                rows.filter_map(|row| row[column].parse().ok()).fold(0.0, f64::max)
            };
            let [model, second, all] = ["step_model", second, "step_unweighted"].map(largest);
            let line = format!("| {name} | {model:.3} | {second:.3} | {all:.3} |");
            assert!(documentation.contains(&line), "{line}");
        }
    }
}

/// Overhead the lengths are those of a round normal distribution of slopes, along rows as across.
#[test]
fn lengths_overhead_are_those_of_all_slopes() {
    let [field, other] = Field::pair(Spectrum::Rough, 512, 16.0, 9);
    let mut all = lengths(&field, OVERHEAD);
    all.add(&lengths(&other.turned(), OVERHEAD));
    let [mean, deviation, _] = all.moments();
    let expected = [(0.5 * PI).sqrt(), (2.0 - 0.5 * PI).sqrt()];
    println!("{mean} {deviation} of {expected:?}");
    assert!((mean - expected[0]).abs() < 0.01 && (deviation - expected[1]).abs() < 0.01, "{mean} {deviation}");
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
