//! Question 3, first half: how far are nodes from the mixture over all scales?

use prefilter::reference::slope_nodes::{Along, Part, Transferred};
use prefilter::table::grid::{Axis, Spacing};
use prefilter::table::slope_nodes::{table, Nodes};
use prefilter::HeightTransfer;

/// Edges on both sides of the slope 0, down to a hundredth of the deviation.
fn edges() -> Vec<f64> {
    let side: Vec<f64> = (0..=60).map(|edge| 0.005 * 400f64.powf(f64::from(edge) / 60.0)).collect();
    side.iter().rev().map(|edge| -edge).chain(side.iter().copied()).collect()
}

/// A surface of as many parts as there are nodes, or of one that has the mean square of all scales: the paper's.
fn few(scales: impl IntoIterator<Item = (f64, f64)>) -> Transferred {
    let parts = scales.into_iter().map(|(scale, share)| Part { value: 0.0, share, height: 0.0, scale });
    Transferred { parts: parts.collect() }
}

/// The largest difference of what is below the edges, of which nothing is hidden.
fn apart(surface: &Transferred, nodes: &Transferred, degrees: f64) -> f64 {
    let rms = surface.average(|part| part.scale * part.scale).sqrt();
    let along = Along { angle: degrees.to_radians(), mean: 0.0, deviation: 0.5 / rms };
    let below = |surface: &Transferred| surface.below(along, &surface.shares(along, 0.0, 0.0), &edges());
    below(surface).iter().zip(below(nodes)).map(|(one, other)| (one - other).abs()).fold(0.0, f64::max)
}

/// The figures of issue 6 at 45 degrees: the paper's single normal distribution, then two to four nodes.
#[test]
fn steps_keep_the_figures_of_their_nodes() -> Result<(), prefilter::Error> {
    let curves = [
        ("smoothstep(-1, 1)", HeightTransfer::smoothstep(-1.0, 1.0)?, 0.21, [0.03, 0.01, 0.005]),
        ("smoothstep(0, 1.2)", HeightTransfer::smoothstep(0.0, 1.2)?, 0.40, [0.03, 0.01, 0.005]),
        ("|f|", HeightTransfer::absolute(), 0.0, [1e-6; 3]),
        ("f|f|", HeightTransfer::power(2.0)?, 0.16, [0.04, 0.025, 0.017]),
        ("terraces", HeightTransfer::terraces(3, 0.4)?.scaled(1.0, 0.0)?, 0.3, [0.06, 0.03, 0.02]),
    ];
    for (name, curve, paper, most) in curves {
        let surface = Nodes { curve: &curve, count: 4, signed: false }.surface(64, 0.0, 1.0);
        let rms = surface.average(|part| part.scale * part.scale).sqrt();
        let single = apart(&surface, &few([(rms, 1.0)]), 45.0);
        let by_nodes = [2, 3, 4].map(|count| {
            let nodes = Nodes { curve: &curve, count, signed: false }.over(0.0, 1.0);
            apart(&surface, &few(nodes.map(|node| (node.scale, node.weight))), 45.0)
        });
        println!("{name}: {single:.4}, by nodes {by_nodes:.4?}");
        if name != "terraces" {
            assert!((single - paper).abs() < 0.01, "{name}: {single}");
        }
        assert!(by_nodes.iter().zip(most).all(|(error, most)| *error <= most), "{name}: {by_nodes:?}");
    }
    Ok(())
}

/// What tables say of themselves.
#[test]
fn tables_know_their_error() -> Result<(), prefilter::Error> {
    let curve = HeightTransfer::smoothstep(-1.0, 1.0)?;
    let means = Axis { low: -2.5, high: 2.5, count: 64, spacing: Spacing::Linear };
    let deviations = Axis { low: 0.0, high: 1.0, count: 32, spacing: Spacing::CubeRoot };
    for (count, most) in [(2, 0.16), (3, 0.06), (4, 0.04)] {
        let start = std::time::Instant::now();
        let nodes = Nodes { curve: &curve, count, signed: false };
        let table = table(nodes, means, deviations, "nodes");
        println!("{count} nodes: {} after {:?}", table.error, start.elapsed());
        assert!(table.error < most && table.error > 0.5 * most, "{}", table.error);
        assert_eq!((table.bytes(), table.is_volume()), (64 * 32 * 4 * 8, true));
    }
    Ok(())
}

/// Where f has a mean slope and the curve falls and rises, a ridge has two sides: nodes without a sign have one.
#[test]
fn signs_keep_both_sides_of_a_ridge() -> Result<(), prefilter::Error> {
    let curves = [
        ("|f|", HeightTransfer::absolute(), 1e-6),
        ("knots", HeightTransfer::knots([(-1.0, 0.0), (-0.5, 0.6), (0.3, 0.6), (1.0, 0.1)])?, 0.01),
    ];
    for (name, curve, most) in curves {
        let along = Along { angle: 45f64.to_radians(), mean: 0.4, deviation: 0.3 };
        let below = |surface: &Transferred| surface.below(along, &surface.shares(along, 0.0, 0.0), &edges());
        let truth = below(&Nodes { curve: &curve, count: 4, signed: true }.surface(64, 0.2, 0.7));
        let [signed, unsigned] = [true, false].map(|signed| {
            let nodes = Nodes { curve: &curve, count: 3, signed }.over(0.2, 0.7);
            let found = below(&few(nodes.map(|node| (node.scale, node.weight))));
            found.iter().zip(&truth).map(|(one, other)| (one - other).abs()).fold(0.0, f64::max)
        });
        println!("{name}: with signs {signed:.4}, without {unsigned:.4}");
        assert!(signed < most && unsigned > 0.2, "{name}: {signed}, {unsigned}");
    }
    Ok(())
}
