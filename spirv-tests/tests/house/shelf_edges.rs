//! Dependencies between the rooms of the shelf: `math ← footprint, visibility ← driver, filter ← pass`.

use std::collections::BTreeMap;

use crate::tree::Tree;
use crate::wgsl;

/// The rooms, and the rooms whose functions each may mention besides its own.
const ROOMS: &[(&str, &[&str])] = &[
    ("math", &[]),
    ("footprint", &["math"]),
    ("visibility", &["math"]),
    ("driver", &["math", "footprint", "visibility"]),
    // A filter never mentions a driver: it takes statistics, whoever measured them.
    ("filter", &["math", "footprint", "visibility"]),
    ("pass", &["math", "footprint", "visibility", "driver", "filter"]),
];

/// The room of `wgsl/ROOM/FILE.wgsl`.
pub fn room(path: &str) -> &str {
    path.trim_start_matches("wgsl/").split('/').next().unwrap_or(path)
}

/// Mentions of shelf functions against the order of the rooms.
pub fn findings(tree: &Tree) -> Vec<String> {
    let mut homes = BTreeMap::new();
    for (path, text) in tree.below("wgsl/", ".wgsl") {
        homes.extend(prefilter_wgsl::declarations(text).iter().map(|declaration| (declaration.name.to_owned(), path)));
    }
    let mut findings = Vec::new();
    for (path, text) in tree.below("wgsl/", ".wgsl") {
        let from = room(path);
        let Some((_, allowed)) = ROOMS.iter().find(|entry| entry.0 == from) else {
            findings.push(format!("{path}:1: `{from}` is no room of the shelf"));
            continue;
        };
        for word in wgsl::words(text) {
            let Some(home) = homes.get(word.text) else { continue };
            let to = room(home);
            if to != from && !allowed.contains(&to) {
                findings.push(format!("{path}:{}: `{from}` mentions `{}` of {home}", word.line, word.text));
            }
        }
    }
    findings
}

#[cfg(test)]
mod tests {
    use super::*;

    const FILTER: (&str, &str) = ("wgsl/filter/texture.wgsl", "fn texture_step() { normal_cdf(); }");
    const MATH: (&str, &str) = ("wgsl/math/normal.wgsl", "fn normal_cdf() {}");

    #[test]
    fn edges_with_the_stream_pass() {
        assert_eq!(findings(&Tree::planted([FILTER, MATH])), [""; 0]);
    }

    #[test]
    fn edges_that_run_back_fail() {
        let back = ("wgsl/math/normal.wgsl", "fn normal_cdf() {\n  texture_step(); }");
        let driver = ("wgsl/driver/moments.wgsl", "fn moments_read() {}");
        let filter = ("wgsl/filter/texture.wgsl", "fn texture_step() {\n  moments_read(); }");
        let attic = ("wgsl/attic/box.wgsl", "fn box_open() {}");
        assert!(findings(&Tree::planted([FILTER, back]))[0].starts_with("wgsl/math/normal.wgsl:2:"));
        assert!(findings(&Tree::planted([driver, filter]))[0].starts_with("wgsl/filter/texture.wgsl:2:"));
        assert!(findings(&Tree::planted([attic]))[0].starts_with("wgsl/attic/box.wgsl:1:"));
    }
}
