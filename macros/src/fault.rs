//! What naga says against a text, with its place and its excerpt.

use std::error::Error;
use std::ops::Range;

use naga::valid::{Capabilities, ValidationError, ValidationFlags, Validator};
use naga::{Function, Module, WithSpan};

/// The first thing that naga has against a text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fault {
    /// One line, without a place.
    pub message: String,
    /// The bytes it is about, if naga names a place.
    pub range: Option<Range<usize>>,
    /// The lines of the text with the place underlined, and naga's notes; empty where there is nothing to show.
    pub excerpt: String,
}

impl Fault {
    /// `path:line:column: message`, followed by the excerpt on lines of its own.
    pub fn report(&self, path: &str, source: &str) -> String {
        let place = self.range.as_ref().map_or_else(String::new, |range| place(source, range.start));
        let excerpt = if self.excerpt.is_empty() { String::new() } else { format!("\n{}", self.excerpt) };
        format!("{path}:{place}{} {}{excerpt}", if place.is_empty() { "" } else { ":" }, self.message)
    }
}

/// Parses and validates a whole module without any capability flag; `path` is the name in the excerpt.
///
/// # Errors
/// The first thing that naga's parser or validator has against it.
pub fn check(path: &str, source: &str) -> Result<(), Fault> {
    let module = naga::front::wgsl::parse_str(source).map_err(|error| Fault {
        message: error.message().to_owned(),
        range: error.labels().find_map(|(span, _)| span.to_range()),
        excerpt: excerpt(source, &error.emit_to_string_with_path(source, path)),
    })?;
    let checked = Validator::new(ValidationFlags::all(), Capabilities::empty()).validate(&module);
    checked.map(drop).map_err(|error| {
        let error = with_place(error, &module);
        Fault {
            message: chain(error.as_inner()),
            // naga marks the function as well as the expression: the shortest mark says most.
            range: error.spans().filter_map(|(span, _)| span.to_range()).min_by_key(ExactSizeIterator::len),
            excerpt: without_notes(&excerpt(source, &error.emit_to_string_with_path(source, path))),
        }
    })
}

/// A built-in type has no place of its own: marks what uses it first, a variable of the module or else a function.
fn with_place(error: WithSpan<ValidationError>, module: &Module) -> WithSpan<ValidationError> {
    let handle = match error.as_inner() {
        ValidationError::Type { handle, .. } if error.spans().len() == 0 => *handle,
        _ => return error,
    };
    let variable = module.global_variables.iter().find(|(_, variable)| variable.ty == handle);
    let uses = |function: &Function| {
        let mut types =
            function.arguments.iter().map(|argument| argument.ty).chain(function.result.iter().map(|it| it.ty));
        types.any(|ty| ty == handle) || function.local_variables.iter().any(|(_, variable)| variable.ty == handle)
    };
    let function = || module.functions.iter().find(|(_, function)| uses(function));
    let span = variable
        .map(|(variable, _)| module.global_variables.get_span(variable))
        .or_else(|| function().map(|(function, _)| module.functions.get_span(function)));
    error.with_span(span.unwrap_or_default(), "here")
}

/// `line:column` of a byte, both from 1, the column in characters.
pub fn place(source: &str, offset: usize) -> String {
    let before = source.get(..offset).unwrap_or(source);
    let line_start = before.rfind('\n').map_or(0, |at| at + 1);
    format!("{}:{}", before.matches('\n').count() + 1, before[line_start..].chars().count() + 1)
}

/// What naga emits without the first lines, which repeat the message.
fn excerpt(source: &str, emitted: &str) -> String {
    // naga replaces control characters by wider ones and then points beside the place.
    if source.chars().any(|character| character.is_control() && !character.is_whitespace()) {
        return String::new();
    }
    let lines = emitted.lines().skip_while(|line| !line.trim_start().starts_with('┌'));
    lines.map(str::trim_end).collect::<Vec<_>>().join("\n").trim_end().to_owned()
}

/// An excerpt of the validator without its notes, which repeat the message.
fn without_notes(excerpt: &str) -> String {
    let lines = excerpt.lines().take_while(|line| !line.trim_start().starts_with('='));
    lines.collect::<Vec<_>>().join("\n").trim_end_matches(['│', ' ', '\n']).to_owned()
}

/// An error and what caused it, outermost first, in one line.
fn chain(error: &dyn Error) -> String {
    let causes = std::iter::successors(Some(error), |&error| error.source());
    causes.map(|error| error.to_string().replace('\n', " ")).collect::<Vec<_>>().join(": ")
}
