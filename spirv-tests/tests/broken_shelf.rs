//! The build script's check: a shelf file with a planted error is named by path, line and column.

#[path = "../../macros/src/fault.rs"]
mod fault;
#[path = "../build/shelf.rs"]
mod shelf;

use prefilter_wgsl::{File, FILES};

/// The faults of the shelf with one piece of one of its files replaced.
fn faults(path: &str, old: &str, new: &str) -> Vec<String> {
    let mut files = FILES.to_vec();
    let file = files.iter_mut().find(|file| file.path == path).expect("the shelf has the file");
    let text = file.text.replacen(old, new, 1);
    assert_ne!(text, file.text, "the file contains the piece");
    *file = File { path: file.path, text: text.leak() };
    shelf::faults(&files)
}

/// `line:column` in a shelf file of the first place of a piece.
fn place(path: &str, piece: &str) -> String {
    let text = FILES.iter().find(|file| file.path == path).expect("the shelf has the file").text;
    fault::place(text, text.find(piece).expect("the file contains the piece"))
}

#[test]
fn the_shelf_as_it_stands_has_no_fault() {
    assert_eq!(shelf::faults(FILES), [""; 0]);
}

#[test]
fn a_planted_error_is_named_by_its_place() {
    let call = place("filter/texture.wgsl", "normal_excess(abs");
    let found = faults("filter/texture.wgsl", "normal_excess(abs", "normal_exces(abs");
    assert_eq!(found.len(), 1, "{found:?}");
    let start = format!("wgsl/filter/texture.wgsl:{call}: no definition in scope for identifier: `normal_exces`\n");
    assert!(found[0].starts_with(&start), "{}", found[0]);
    assert!(found[0].contains(&format!("┌─ wgsl/filter/texture.wgsl:{call}\n")), "{}", found[0]);

    let semicolon = place("math/normal.wgsl", "let tail");
    let found = faults("math/normal.wgsl", "q;\n    let tail", "q\n    let tail");
    assert_eq!(found.len(), 1, "{found:?}");
    assert!(found[0].starts_with(&format!("wgsl/math/normal.wgsl:{semicolon}: expected ")), "{}", found[0]);
}

#[test]
fn a_wrong_type_is_named_by_its_place() {
    let piece = "normal_cdf(distance /";
    let line = place("filter/texture.wgsl", piece);
    let found = faults("filter/texture.wgsl", piece, "vec2f(distance /");
    assert_eq!(found.len(), 1, "{found:?}");
    assert!(found[0].starts_with(&format!("wgsl/filter/texture.wgsl:{line}: ")), "{}", found[0]);
}

#[test]
fn an_open_brace_is_its_own_files_fault() {
    let found = faults("filter/texture.wgsl", "return normal_cdf(distance", "{ return normal_cdf(distance");
    assert_eq!(found.len(), 1, "{found:?}");
    assert!(found[0].starts_with("wgsl/filter/texture.wgsl:"), "{}", found[0]);
}

#[test]
fn a_name_that_two_files_declare_names_both() {
    let [first, second] = [place("math/grid.wgsl", "grid_linear("), place("math/normal.wgsl", "normal_cdf(")];
    let found = faults("math/normal.wgsl", "fn normal_cdf(", "fn grid_linear(");
    let expected =
        format!("wgsl/math/normal.wgsl:{second}: `grid_linear` is declared by wgsl/math/grid.wgsl:{first} too");
    assert!(found.contains(&expected), "{found:?}");
}
