//! Declarations and names in texts that try to mislead the scanner.

use prefilter_wgsl::{declarations, link, mentioned, Kind};

/// Name, kind, line and column of every declaration.
fn outline(text: &str) -> Vec<(&str, Kind, usize, usize)> {
    declarations(text).into_iter().map(|found| (found.name, found.kind, found.line, found.column)).collect()
}

/// The names of the shelf that a text mentions, without those that they need.
fn direct(text: &str) -> Vec<&'static str> {
    let found = mentioned(text).into_iter().map(|(_, declaration)| declaration.name);
    found.filter(|name| ["normal_cdf", "grid_linear"].contains(name)).collect()
}

#[test]
fn every_kind_of_declaration() {
    let text = "\
enable f16;
requires readonly_and_readwrite_storage_textures;
diagnostic(off, derivative_uniformity);
const_assert 1 < 2;
alias Weights = array<f32, 4>;
const scale: array<vec2<f32>, 2> = array(vec2(1.0), vec2(2.0));
@id(3) override count: u32 = 4u;
var<private> seed: u32;
@group(0) @binding(1) var<storage, read_write> heights: array<f32>;
@group(0) @binding(2) var height_map: texture_2d<f32>;
struct Vertex { @builtin(position) position: vec4f, @location(0) uv: vec2f }
@vertex fn shade(@location(0) p: vec3<f32>) -> Vertex { const local = 1; var other = 2; return Vertex(); }
fn last() {}
";
    let expected = [
        ("Weights", Kind::Alias, 5, 7),
        ("scale", Kind::Constant, 6, 7),
        ("count", Kind::Override, 7, 17),
        ("seed", Kind::Variable, 8, 14),
        ("heights", Kind::Variable, 9, 48),
        ("height_map", Kind::Variable, 10, 27),
        ("Vertex", Kind::Structure, 11, 8),
        ("shade", Kind::Function, 12, 12),
        ("last", Kind::Function, 13, 4),
    ];
    assert_eq!(outline(text), expected);
    assert_eq!(outline(&text.replace('\n', "\r\n")), expected, "line breaks of Windows");
}

#[test]
fn a_declaration_ends_where_its_bracket_closes() {
    let text =
        "fn a(x: array<f32, 4>) -> vec2<f32> { if x[0] > 1.0 { return f(x[(1)]); } }fn b(){}const c=1;const d=(2);";
    let parts: Vec<&str> = declarations(text).into_iter().map(|found| found.text).collect();
    assert_eq!(parts[1..], ["fn b(){}", "const c=1;", "const d=(2);"]);
    assert_eq!(parts.concat(), text);
}

#[test]
fn comments_belong_to_what_follows_them() {
    let text = "\
/// First.
fn a() {} // behind a

// cut off

/// Second.
///
/// More.
@must_use

fn b() {}
/* third */ fn c() {}";
    let found = declarations(text);
    assert_eq!(found[0].text, "/// First.\nfn a() {}");
    assert_eq!(found[0].documentation(), "First.");
    assert_eq!(found[1].text, "/// Second.\n///\n/// More.\n@must_use\n\nfn b() {}");
    assert_eq!(found[1].documentation(), "Second.\n\nMore.");
    assert_eq!(found[2].text, "/* third */ fn c() {}");
}

#[test]
fn signatures_are_one_line_without_comments() {
    let text =
        "fn  a( // why\n    x: f32, /* , */ y: array<f32, 4>,\n) -> vec3f\n{ return b; }\nvar<private> c: u32 = 3;";
    let signatures: Vec<String> = declarations(text).into_iter().map(|found| found.signature).collect();
    assert_eq!(signatures, ["fn a( x: f32, y: array<f32, 4>, ) -> vec3f", "var<private> c: u32"]);
}

#[test]
fn nothing_in_comments_counts() {
    let text = "// fn a() {}\n/* fn b() {} /* nested } */ fn c() {} normal_cdf */ fn d() {} // normal_cdf {\nfn e() {}";
    assert_eq!(outline(text).into_iter().map(|(name, ..)| name).collect::<Vec<_>>(), ["d", "e"]);
    assert_eq!(direct(text), [""; 0]);
    assert_eq!(link(text).as_deref(), Ok(text));
}

#[test]
fn every_line_break_of_wgsl_ends_a_line_comment() {
    for line_break in ["\n", "\r\n", "\r", "\u{b}", "\u{c}", "\u{85}", "\u{2028}", "\u{2029}"] {
        let text = format!("// comment{line_break}fn a() {{ normal_cdf(1.0); }}");
        assert_eq!(direct(&text), ["normal_cdf"], "{line_break:?}");
        assert_eq!(declarations(&text)[0].name, "a", "{line_break:?}");
    }
}

#[test]
fn blank_characters_of_wgsl_separate_words() {
    for blank in [" ", "\t", "\u{b}", "\u{85}", "\u{200e}", "\u{200f}", "\u{2028}", "\u{2029}"] {
        assert_eq!(direct(&format!("return{blank}normal_cdf")), ["normal_cdf"], "{blank:?}");
    }
}

#[test]
fn members_attributes_and_longer_names_are_no_mentions() {
    for text in [
        "a.normal_cdf",
        "a . /* still */ normal_cdf",
        "f(x).normal_cdf",
        "vec2(1.0).normal_cdf",
        "a[0].normal_cdf",
        "@normal_cdf",
        "my_normal_cdf",
        "normal_cdf_",
        "normal_cdf2",
        "Normal_cdf",
        "énormal_cdf",
        "0x1normal_cdf",
    ] {
        assert_eq!(direct(text), [""; 0], "{text}");
    }
}

#[test]
fn mentions_next_to_numbers_and_brackets() {
    for text in [
        "1.0+normal_cdf",
        "1.+normal_cdf",
        ".5*normal_cdf",
        "0x1p-3*normal_cdf",
        "1e-5f-normal_cdf",
        "3u<normal_cdf",
        "-normal_cdf",
        "array<f32,normal_cdf>",
        "@workgroup_size(normal_cdf)",
        "x.y=normal_cdf",
        "a.b\nnormal_cdf",
        "a/normal_cdf",
        "!normal_cdf(",
    ] {
        assert_eq!(direct(text), ["normal_cdf"], "{text}");
    }
    assert_eq!(direct("1.5.x*normal_cdf+a.grid_linear"), ["normal_cdf"]);
}

#[test]
fn broken_texts_end_somewhere() {
    for text in
        ["fn", "fn ", "fn (", "fn a", "fn a(", "fn a() {", "const", "const a", "var<", "}", "*/", "/*", "@", "fn }"]
    {
        for found in declarations(text) {
            assert!(text.contains(found.text), "{text}");
        }
        assert_eq!(link(text).as_deref(), Ok(text));
    }
}
