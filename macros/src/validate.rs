//! From the text of a shader file to the linked and validated text, or to a message that names the place.

use crate::fault::{check, Fault};

/// A shader's text with the shelf functions that it mentions behind it, once naga has accepted the whole.
///
/// `path` is only the name that messages give to the text.
///
/// # Errors
/// A message that starts with `path:line:column:` and says what is wrong: a declaration that bears a name of the shelf,
/// or what naga's parser or validator refuses, with naga's excerpt.
pub fn validate(path: &str, text: &str) -> Result<String, String> {
    let linked = prefilter_wgsl::link(text).map_err(|collision| format!("{path}:{collision}"))?;
    match check(path, &linked) {
        Ok(()) => Ok(linked),
        Err(fault) => Err(report(path, text, &linked, fault)),
    }
}

/// The message of a fault in the linked text, told in terms of the file.
fn report(path: &str, text: &str, linked: &str, fault: Fault) -> String {
    let behind = fault.range.as_ref().is_some_and(|range| range.start >= text.len());
    if !behind {
        return suggest(fault, linked).report(path, linked);
    }
    // An open brace or comment swallows the shelf functions: without them, naga points at the end of the file.
    match check(path, text) {
        Err(alone) if !alone.message.contains(UNKNOWN) => alone.report(path, text),
        _ => {
            let message = format!("in the shelf functions linked behind the file: {}", fault.message);
            Fault { message, ..fault }.report(path, linked)
        }
    }
}

const UNKNOWN: &str = "no definition in scope";

/// Adds the nearest name of the shelf to a message about an unknown one.
fn suggest(fault: Fault, source: &str) -> Fault {
    let name = fault.range.clone().and_then(|range| source.get(range)).unwrap_or_default();
    match prefilter_wgsl::nearest(name, source) {
        Some(nearest) if fault.message.contains(UNKNOWN) => {
            Fault { message: format!("{}; did you mean `{nearest}`?", fault.message), ..fault }
        }
        _ => fault,
    }
}

#[cfg(test)]
mod tests {
    use super::validate;

    #[test]
    fn a_collision_names_both_places() {
        let message = validate("a.wgsl", "// one\nfn  normal_cdf() {}").expect_err("the shelf declares it");
        assert!(message.starts_with("a.wgsl:2:5: `normal_cdf` is declared here and by the shelf at math/normal.wgsl:"));
        let line = message.split(&[':', ';']).nth(4).and_then(|line| line.parse::<usize>().ok());
        assert!(line.is_some_and(|line| line > 1), "{message}");
    }

    #[test]
    fn columns_count_characters() {
        let message = validate("a.wgsl", "fn é() { let ü = 1.0; ä(); }").expect_err("ä is unknown");
        assert!(message.starts_with("a.wgsl:1:23: no definition in scope for identifier: `ä`\n"), "{message}");
        assert!(message.contains("┌─ a.wgsl:1:23\n"), "{message}");
    }

    #[test]
    fn control_characters_cost_the_excerpt_but_not_the_message() {
        let message = validate("a.wgsl", "// \u{1}\u{7f}\nfn a() { b(); }").expect_err("b is unknown");
        assert_eq!(message, "a.wgsl:2:10: no definition in scope for identifier: `b`");
    }

    #[test]
    fn what_needs_a_capability_is_refused_where_it_is_used() {
        for (text, place) in [
            ("// one\n@group(0) @binding(0) var a: texture_cube_array<f32>;", "2:"),
            ("// one\n\nfn a(b: texture_cube_array<f32>) {}", "3:1:"),
        ] {
            let message = validate("a.wgsl", text).expect_err("cube arrays are optional");
            assert!(message.starts_with(&format!("a.wgsl:{place}")), "{message}");
            assert!(message.contains("CUBE_ARRAY_TEXTURES) is required\n"), "{message}");
        }
    }

    #[test]
    fn every_byte_of_the_file_is_kept() {
        for text in ["", "\r\n", "fn a() {}", "/// é\r\nfn a() { _ = normal_cdf(1.0); }\r\n"] {
            let linked = validate("a.wgsl", text).expect("valid");
            assert!(linked.starts_with(text));
            assert_eq!(linked.contains("fn normal_cdf("), text.contains("normal_cdf"));
        }
    }
}
