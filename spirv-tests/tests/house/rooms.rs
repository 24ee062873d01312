//! Same stem in every room: a function of the shelf has its place in the crate, its reference and its rows of tests.

use crate::shelf_edges::room;
use crate::tree::{stem, Tree};

/// The rooms that a file of each room of the shelf needs, as paths with `*` for its stem.
const NEEDS: &[(&str, &[&str])] = &[
    ("math", &["src/reference/*", "spirv-tests/src/rows/*"]),
    ("footprint", &["src/reference/*", "spirv-tests/src/rows/*"]),
    ("visibility", &["src/reference/*", "spirv-tests/src/rows/*"]),
    ("driver", &["src/driver/*", "src/reference/*", "spirv-tests/src/rows/*"]),
    ("filter", &["src/filter/*", "src/reference/*", "spirv-tests/src/rows/*"]),
    ("pass", &["spirv-tests/src/rows/*"]),
];

/// Rooms that stand elsewhere, with the reason in the comment.
const INSTEAD: &[(&str, &str, &str)] = &[
    // Kernels, and their paper's form, are parts of one driver.
    ("wgsl/driver/gabor_kernel.wgsl", "src/driver/gabor_kernel", "src/driver/gabor"),
    ("wgsl/driver/gabor_paper.wgsl", "src/driver/gabor_paper", "src/driver/gabor"),
    // A structure alone: what drivers that are functions return, each of which has its own truth and rows.
    ("wgsl/driver/statistics.wgsl", "src/driver/statistics", "src/driver/function"),
    ("wgsl/driver/statistics.wgsl", "src/reference/statistics", "src/reference/moments"),
    ("wgsl/driver/statistics.wgsl", "spirv-tests/src/rows/statistics", "spirv-tests/src/rows/moments"),
    // Noises on lattices are bases of one driver.
    ("wgsl/driver/bent_noise.wgsl", "src/driver/bent_noise", "src/driver/bend"),
    ("wgsl/driver/fractal.wgsl", "src/driver/fractal", "src/driver/noise"),
    ("wgsl/driver/perlin.wgsl", "src/driver/perlin", "src/driver/noise"),
    ("wgsl/driver/simplex.wgsl", "src/driver/simplex", "src/driver/noise"),
    ("wgsl/driver/perlin_solid.wgsl", "src/driver/perlin_solid", "src/driver/solid"),
    ("wgsl/driver/value_solid.wgsl", "src/driver/value_solid", "src/driver/solid"),
    ("wgsl/driver/value.wgsl", "src/driver/value", "src/driver/noise"),
    // Axes come in pairs: the inverse of the shader's axis is the baker's, which tables need anyway.
    ("wgsl/math/grid.wgsl", "src/reference/grid", "src/table/grid"),
    // Cubics are one kind of piece.
    ("wgsl/math/cubic.wgsl", "src/reference/cubic", "src/reference/piece"),
    // Distributions of Rice are how lengths of slopes are represented.
    ("wgsl/filter/rice.wgsl", "src/filter/rice", "src/filter/steepness"),
    ("wgsl/filter/rice.wgsl", "src/reference/rice", "src/reference/steepness"),
    // What round distributions stand for is a setting of the maps that read them.
    ("wgsl/filter/rounds.wgsl", "src/filter/rounds", "src/filter/slope_map"),
    // Two distributions for visible slopes are a setting of the same maps.
    ("wgsl/filter/split.wgsl", "src/filter/split", "src/filter/slope_map"),
    // Shorter tails are a tier of heights.
    ("wgsl/filter/tails.wgsl", "src/filter/tails", "src/filter/height/tails"),
    // Noise is a switch of the surface that the heights belong to.
    ("wgsl/filter/perturbed.wgsl", "src/filter/perturbed", "src/filter/height/surface"),
];

/// Missing rooms, and files of the shelf that the linker does not know.
pub fn findings(tree: &Tree) -> Vec<String> {
    let known: Vec<String> = prefilter_wgsl::FILES.iter().map(|file| format!("wgsl/{}", file.path)).collect();
    let mut findings = missing_rooms(tree);
    for (path, _) in tree.below("wgsl/", ".wgsl").filter(|(path, _)| !known.iter().any(|known| known == path)) {
        findings.push(format!("{path}:1: not in prefilter_wgsl::FILES"));
    }
    findings
}

fn missing_rooms(tree: &Tree) -> Vec<String> {
    let mut findings = Vec::new();
    for (path, _) in tree.below("wgsl/", ".wgsl") {
        let needs = NEEDS.iter().find(|needs| needs.0 == room(path)).map_or(&[][..], |needs| needs.1);
        for need in needs {
            let usual = need.replace('*', stem(path));
            let instead = INSTEAD.iter().find(|instead| (instead.0, instead.1) == (path, usual.as_str()));
            let place = instead.map_or(usual, |instead| instead.2.to_owned());
            if !tree.has_module(&place) {
                findings.push(format!("{path}:1: its room {place}.rs is missing"));
            }
        }
    }
    findings
}

#[test]
fn a_missing_room_is_named() {
    let rooms =
        ["wgsl/filter/foo.wgsl", "src/filter/foo.rs", "src/reference/foo/mod.rs", "spirv-tests/src/rows/foo.rs"];
    let whole = Tree::planted(rooms.map(|path| (path, "")));
    assert_eq!(missing_rooms(&whole), [""; 0]);
    assert_eq!(findings(&whole), ["wgsl/filter/foo.wgsl:1: not in prefilter_wgsl::FILES"]);
    for room in &rooms[1..] {
        let mut tree = Tree::planted(rooms.map(|path| (path, "")));
        tree.files.remove(*room);
        let found = missing_rooms(&tree);
        assert_eq!(found.len(), 1, "{room}: {found:?}");
        assert!(found[0].contains(room.trim_end_matches("/mod.rs").trim_end_matches(".rs")), "{found:?}");
    }
}
