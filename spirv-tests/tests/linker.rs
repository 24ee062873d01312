//! The linker against naga, which alone knows what a text needs, and against arbitrary texts.

use naga::valid::{Capabilities, ValidationFlags, Validator};
use prefilter_wgsl::{collisions, declarations, link, mentioned, Declaration, Kind, FILES};
use proptest::prelude::*;

/// Why naga refuses a text, if it does.
fn refusal(text: &str) -> Option<String> {
    let module = match naga::front::wgsl::parse_str(text) {
        Ok(module) => module,
        Err(error) => return Some(error.emit_to_string(text)),
    };
    let mut validator = Validator::new(ValidationFlags::all(), Capabilities::empty());
    validator.validate(&module).err().map(|error| error.emit_to_string(text))
}

/// A valid text that uses one declaration of the shelf and nothing else of it.
fn user(declaration: &Declaration<'_>) -> String {
    let name = declaration.name;
    match declaration.kind {
        Kind::Function => {
            let (_, rest) = declaration.signature.split_once('(').expect("a function has parameters");
            let (parameters, result) = rest.rsplit_once(") ->").unwrap_or((rest.trim_end_matches(')'), ""));
            let arguments: Vec<&str> = parameters.split(',').filter_map(|part| Some(part.split_once(':')?.0)).collect();
            let call = format!("{name}({})", arguments.join(","));
            format!("fn user({parameters}) {{ {}{call}; }}\n", if result.is_empty() { "" } else { "_ = " })
        }
        Kind::Structure | Kind::Alias => format!("fn user() {{ var value: {name}; }}\n"),
        _ => format!("const user = {name};\n"),
    }
}

#[test]
fn every_name_links_what_it_needs_and_nothing_else() {
    let mut count = 0;
    for declaration in FILES.iter().flat_map(|file| declarations(file.text)) {
        let text = user(&declaration);
        let linked = link(&text).expect("the shelf declares no `user`");
        assert_eq!(refusal(&linked), None, "{linked}");
        for (_, needed) in mentioned(&text) {
            let without = linked.replace(needed.text, "");
            assert_ne!(without, linked);
            assert!(refusal(&without).is_some(), "{} links {}, which it does not need", declaration.name, needed.name);
        }
        count += 1;
    }
    assert!(count >= 10, "the shelf holds {count} declarations");
}

#[test]
fn the_whole_shelf_in_one_text_is_valid() {
    let shelf: String = FILES.iter().map(|file| file.text).collect();
    assert_eq!(refusal(&shelf), None);
}

/// Texts of the pieces that the scanner must tell apart, in any order.
fn pieces() -> impl Strategy<Value = String> {
    let pieces = [
        "fn ",
        "struct ",
        "const ",
        "var",
        "let ",
        "alias ",
        "override ",
        "<private>",
        "<",
        ">",
        "(",
        ")",
        "{",
        "}",
        "[",
        "]",
        ";",
        ":",
        "=",
        ".",
        ",",
        "@",
        "//",
        "///",
        "/*",
        "*/",
        "\n",
        "\r\n",
        "\n\n",
        " ",
        "a",
        "b",
        "normal_cdf",
        "texture_ramp",
        "select",
        "1.0",
        "0x1p-3",
        "é",
        "\u{2028}",
        "\u{0}",
        "\"",
    ];
    prop::collection::vec(prop::sample::select(pieces.to_vec()), 0..40).prop_map(|pieces| pieces.concat())
}

/// Parts of a module with the name that they declare.
const PARTS: &[(&str, Option<&str>)] = &[
    ("// fn a() {\n", None),
    ("/* const a = 1; /* } */ { */", None),
    ("\n\n", None),
    (";", None),
    ("const_assert 1 < 2;", None),
    ("diagnostic(off, derivative_uniformity);", None),
    ("@must_use /* fn */\n", None),
    ("const a: array<f32, 2> = array(1., .5);", Some("a")),
    ("@id(1) override b = 0x1p-3;", Some("b")),
    ("var<private> c: vec2<f32>;", Some("c")),
    ("@group(0) @binding(0) var<storage, read_write> d: array<u32>;", Some("d")),
    ("alias e = array<vec4<f32>, 4>;", Some("e")),
    ("struct f { a: f32, @align(16) b: array<f32, 3> }", Some("f")),
    ("fn g(@location(0) a: vec2<f32>) -> @location(0) vec4f { const b = 1; if a.x < b { var c = 2; } }", Some("g")),
    ("fn é() {}", Some("é")),
];

/// What must hold for any text at all.
fn scans(text: &str) -> Result<(), TestCaseError> {
    let mut end = 0;
    for found in declarations(text) {
        let at = text[end..].find(found.text).map(|at| at + end);
        prop_assert!(at.is_some(), "{:?} lies in order behind byte {end}", found.text);
        end = at.unwrap_or(end) + found.text.len();
        let line = text.split('\n').nth(found.line - 1).unwrap_or_default();
        let named: String = line.chars().skip(found.column - 1).take(found.name.chars().count()).collect();
        prop_assert_eq!(&named, found.name);
        prop_assert!(found.text.contains(found.name) && !found.signature.is_empty());
    }
    match link(text) {
        Ok(linked) => {
            prop_assert!(collisions(text).is_empty());
            let behind = linked.strip_prefix(text);
            prop_assert_eq!(behind.map(str::is_empty), Some(mentioned(text).is_empty()));
            prop_assert_eq!(link(text), Ok(linked.clone()));
            for (_, needed) in mentioned(text) {
                prop_assert!(linked.contains(needed.text));
            }
        }
        Err(collision) => prop_assert_eq!(collisions(text).into_iter().next(), Some(collision)),
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, cases: 2000, ..ProptestConfig::default() })]

    #[test]
    fn arbitrary_characters_never_mislead_the_linker(text in any::<String>()) {
        scans(&text)?;
    }

    #[test]
    fn arbitrary_pieces_never_mislead_the_linker(text in pieces()) {
        scans(&text)?;
    }

    #[test]
    fn whole_declarations_are_found_in_any_order(parts in prop::collection::vec(prop::sample::select(PARTS), 0..20)) {
        let text: String = parts.iter().map(|part| part.0).collect();
        let expected: Vec<&str> = parts.iter().filter_map(|part| part.1).collect();
        let found: Vec<&str> = declarations(&text).into_iter().map(|found| found.name).collect();
        prop_assert_eq!(found, expected);
    }
}
