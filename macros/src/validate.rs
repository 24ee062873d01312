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
    match prefilter_wgsl::nearest(name) {
        Some(nearest) if fault.message.contains(UNKNOWN) => {
            Fault { message: format!("{}; did you mean `{nearest}`?", fault.message), ..fault }
        }
        _ => fault,
    }
}
