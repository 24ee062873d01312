//! The build script's check: a shelf file with a planted error is named by path, line and column.

#[path = "../../macros/src/fault.rs"]
mod fault;
#[path = "../build/shelf.rs"]
mod shelf;

use prefilter_wgsl::{File, FILES};

/// The faults of the shelf with a function planted in front of one file, and the `line:column` of the function's mark
/// `«`, which is taken out.
fn planted(path: &str, function: &str) -> (Vec<String>, String) {
    let mut files = FILES.to_vec();
    let file = files.iter_mut().find(|file| file.path == path).expect("the shelf has the file");
    let text = format!("// A comment.\n\n{function}\n\n{}", file.text);
    let mark = text.find('«').expect("the function has a mark");
    *file = File { path: file.path, text: text.replacen('«', "", 1).leak() };
    (shelf::faults(&files), fault::place(&text, mark))
}

/// Asserts that a planted function is the only fault, and reports its message behind the path.
fn only_fault(path: &str, function: &str) -> String {
    let (found, place) = planted(path, function);
    assert_eq!(found.len(), 1, "{found:?}");
    let start = format!("wgsl/{path}:{place}: ");
    assert!(found[0].starts_with(&start), "{start} begins {}", found[0]);
    assert!(found[0].contains("┌─ wgsl/"), "no excerpt in {}", found[0]);
    found[0][start.len()..].to_owned()
}

#[test]
fn the_shelf_as_it_stands_has_no_fault() {
    assert_eq!(shelf::faults(FILES), [""; 0]);
}

#[test]
fn an_unknown_name_is_named_by_its_place() {
    for path in ["math/normal.wgsl", "filter/texture.wgsl"] {
        let message = only_fault(path, "fn planted(x: f32) -> f32 {\n    return 2.0 * «normal_cfd(x);\n}");
        assert!(message.starts_with("no definition in scope for identifier: `normal_cfd`\n"), "{message}");
    }
}

#[test]
fn a_syntax_error_is_named_by_its_place() {
    let message = only_fault("math/normal.wgsl", "fn planted(x: f32) -> f32 {\n    let y = x\n    «return y;\n}");
    assert!(message.starts_with("expected "), "{message}");
}

#[test]
fn a_wrong_type_is_named_by_its_place() {
    only_fault("filter/texture.wgsl", "fn planted(x: f32) -> vec3f {\n    return «normal_cdf(x);\n}");
}

#[test]
fn an_open_brace_is_its_own_files_fault() {
    // naga notices it at the next `fn`, or at the end of the file.
    let function = "fn planted(x: f32) -> f32 «{\n    if x > 0.0 {\n        return x;\n}";
    let (found, _) = planted("filter/texture.wgsl", function);
    assert_eq!(found.len(), 1, "{found:?}");
    assert!(found[0].starts_with("wgsl/filter/texture.wgsl:"), "{}", found[0]);
}

#[test]
fn a_name_that_two_files_declare_names_both() {
    let (found, place) = planted("math/normal.wgsl", "fn «grid_linear(x: f32) -> f32 {\n    return x;\n}");
    let grid = FILES.iter().find(|file| file.path == "math/grid.wgsl").expect("the shelf has the file").text;
    let other = fault::place(grid, grid.find("grid_linear(").expect("the file declares the name"));
    let message =
        format!("wgsl/math/normal.wgsl:{place}: `grid_linear` is declared by wgsl/math/grid.wgsl:{other} too");
    assert!(found.contains(&message), "{message} is missing in {found:?}");
}
