//! The crate's lists of reserved words against naga's, which are private: they are read from the source that cargo has.

use std::collections::BTreeSet;
use std::path::PathBuf;
use std::process::Command;

use crate::reserved::{language, LANGUAGES};

/// The folder of naga's source, as cargo names it.
fn naga() -> PathBuf {
    // Without a platform cargo would want the packages of all of them, which no build has fetched.
    let version = Command::new("rustc").arg("-vV").output().expect("rustc starts");
    let version = String::from_utf8_lossy(&version.stdout).into_owned();
    let host = version.lines().find_map(|line| line.strip_prefix("host: ")).expect("rustc names its host");
    let manifest = concat!(env!("CARGO_MANIFEST_DIR"), "/Cargo.toml");
    let mut metadata = Command::new(env!("CARGO"));
    metadata.args([
        "metadata",
        "--format-version",
        "1",
        "--offline",
        "--filter-platform",
        host,
        "--manifest-path",
        manifest,
    ]);
    let output = metadata.output().expect("cargo starts");
    let answer: serde_json::Value = serde_json::from_slice(&output.stdout)
        .unwrap_or_else(|error| panic!("{error}: {}", String::from_utf8_lossy(&output.stderr)));
    let packages = answer["packages"].as_array().expect("a list of packages");
    let naga = packages.iter().find(|package| package["name"] == "naga").expect("naga among the packages");
    PathBuf::from(naga["manifest_path"].as_str().expect("a path")).with_file_name("src")
}

/// The words between quotes of the lines that hold nothing else.
fn quoted(text: &str) -> impl Iterator<Item = &str> {
    let lines = text.lines().map(|line| line.split("//").next().unwrap_or_default().trim());
    lines.filter_map(|line| line.strip_prefix('"')?.trim_end_matches(',').strip_suffix('"'))
}

/// Whether a name may look like that at all; others are refused for their looks.
fn possible(word: &str) -> bool {
    let letters = word.bytes().all(|byte| byte.is_ascii_alphanumeric() || byte == b'_');
    let ends = word.starts_with(|first: char| first.is_ascii_alphabetic()) && !word.ends_with(char::is_numeric);
    letters && ends && !word.contains("__")
}

#[test]
fn every_word_of_naga_is_reserved() {
    let source = naga();
    let mut count = 0;
    for file in ["keywords/wgsl.rs", "back/glsl/keywords.rs", "back/hlsl/keywords.rs", "back/msl/keywords.rs"] {
        let text = std::fs::read_to_string(source.join(file)).unwrap_or_else(|error| panic!("{file}: {error}"));
        let words: Vec<&str> = quoted(&text).filter(|word| possible(word)).collect();
        let missing: Vec<_> = words.iter().filter(|word| language(word).is_none()).collect();
        assert!(missing.is_empty(), "{file}: {missing:?}");
        count += words.len();
    }
    assert!(count > 1000, "{count} words found: naga's lists look different now");
    assert!(naga::keywords::wgsl::RESERVED.iter().all(|word| language(word) == Some("WGSL")));
}

#[test]
fn words_name_their_language() {
    for (word, expected) in [
        ("fn", "WGSL"),
        ("texture_2d", "WGSL"),
        ("vec3f", "WGSL"),
        ("half", "GLSL"),
        ("cbuffer", "HLSL"),
        ("TECHNIQUE", "HLSL"),
        ("kernel", "MSL"),
        ("constexpr", "WGSL"),
        ("main", "GLSL"),
    ] {
        assert_eq!(language(word), Some(expected), "{word}");
    }
    for word in ["lichen", "terrain", "gravel", "mean", "deviation", "Fn"] {
        assert_eq!(language(word), None, "{word}");
    }
}

#[test]
fn lists_are_sorted_and_free_of_impossible_words() {
    for vocabulary in LANGUAGES {
        for list in [vocabulary.words, vocabulary.functions] {
            let words: Vec<&str> = list.split_ascii_whitespace().collect();
            let sorted: Vec<&str> = BTreeSet::from_iter(words.iter().copied()).into_iter().collect();
            assert_eq!(words, sorted, "{}", vocabulary.language);
            assert!(words.iter().all(|word| possible(word)), "{}", vocabulary.language);
        }
    }
}
