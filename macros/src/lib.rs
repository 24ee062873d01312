//! [`include_wgsl!`] of the `prefilter` crate: WGSL files linked with the shelf and validated by `cargo build`.
#![deny(missing_docs)]

mod argument;
mod fault;
mod validate;

use std::io::ErrorKind;
use std::path::PathBuf;

use proc_macro::{Delimiter, Group, Ident, Literal, Punct, Spacing, Span, TokenStream, TokenTree};

/// The text of a WGSL file with every shelf function that it mentions, validated while the crate compiles.
///
/// Expands to a `&'static str`: the file byte for byte, and behind it the declarations of the `prefilter-wgsl` shelf
/// that it mentions by name, directly or through one another, with their comments. The file comes first, so that line
/// numbers in later messages stay its own. A changed file is linked and validated again by the next `cargo build`.
///
/// ```
/// const SHADER: &str = prefilter_macros::include_wgsl!("tests/shaders/terrain.wgsl");
/// assert!(SHADER.contains("fn normal_cdf("));
/// ```
///
/// (`prefilter` re-exports the macro with its feature `macros`: `prefilter::include_wgsl!`.)
///
/// # Path
/// One string literal, raw or not, relative to `CARGO_MANIFEST_DIR`: the folder of the `Cargo.toml` of the crate that
/// uses the macro, not the folder of the source file as with `include_str!`. An absolute path stands as it is.
///
/// # Errors
/// A compile error at the literal that starts with `shaders/terrain.wgsl:12:7:` (line and column in characters, both
/// from 1; naga names no place for a few whole-module errors) and ends with naga's excerpt, where
/// - the text is not WGSL, or naga's validator refuses it: it runs with every check and no capability flag, so that
///   what passes needs no optional feature of a device (`f16`, cube arrays, push constants and the like do not pass);
/// - it uses a name that neither it nor the shelf declares; a shelf name that resembles it is suggested;
/// - it declares a name of the shelf, or a name that hides a built-in function or type from a shelf function that it
///   uses (`fn select`, `alias f32`); the message names both places.
///
/// A file that is missing or no UTF-8 and an argument that is not one string literal are compile errors, too.
///
/// # Cost
/// The linked text is a constant: nothing is left to do at run time. A file takes a few milliseconds, even in an
/// unoptimized build; before the first one, cargo builds naga for the host.
#[proc_macro]
pub fn include_wgsl(input: TokenStream) -> TokenStream {
    match argument::path(input) {
        Ok((path, span)) => match load(&path) {
            Ok((file, linked)) => expression(&file, &linked),
            Err(message) => compile_error(&message, span),
        },
        Err((message, span)) => compile_error(&message, span),
    }
}

/// The absolute path of a file and its linked text, or what is wrong with it.
fn load(path: &str) -> Result<(String, String), String> {
    let folder = std::env::var_os("CARGO_MANIFEST_DIR")
        .ok_or("include_wgsl! needs CARGO_MANIFEST_DIR, which cargo sets: paths are relative to it")?;
    let absolute = PathBuf::from(folder).join(path);
    let bytes = std::fs::read(&absolute).map_err(|error| match error.kind() {
        ErrorKind::NotFound => format!(
            "{path}: there is no such file; paths are relative to CARGO_MANIFEST_DIR, the folder of this crate's \
             Cargo.toml"
        ),
        _ => format!("{path}, relative to CARGO_MANIFEST_DIR: {error}"),
    })?;
    let text = decode(path, &bytes)?;
    let linked = validate::validate(path, text)?;
    let absolute =
        absolute.to_str().ok_or_else(|| format!("{path}: the folder of this crate's Cargo.toml is no UTF-8"))?;
    Ok((absolute.to_owned(), linked))
}

/// The bytes as text, or the place of the first that is none.
fn decode<'a>(path: &str, bytes: &'a [u8]) -> Result<&'a str, String> {
    std::str::from_utf8(bytes).map_err(|error| {
        let valid = String::from_utf8_lossy(&bytes[..error.valid_up_to()]);
        format!("{path}:{}: this byte is no UTF-8", fault::place(&valid, valid.len()))
    })
}

/// `{ const _: &[u8] = ::core::include_bytes!("file"); "linked" }`: the bytes are unused, but cargo watches the file.
fn expression(file: &str, linked: &str) -> TokenStream {
    let span = Span::call_site();
    let word = |name: &str| TokenTree::Ident(Ident::new(name, span));
    let mark = |mark: char| TokenTree::Punct(Punct::new(mark, Spacing::Alone));
    let group =
        |delimiter, tokens: Vec<TokenTree>| TokenTree::Group(Group::new(delimiter, tokens.into_iter().collect()));
    let text = |text: &str| TokenTree::Literal(Literal::string(text));
    let mut body = vec![word("const"), word("_"), mark(':'), mark('&'), group(Delimiter::Bracket, vec![word("u8")])];
    body.push(mark('='));
    body.extend(core_macro("include_bytes", span));
    body.extend([group(Delimiter::Parenthesis, vec![text(file)]), mark(';'), text(linked)]);
    group(Delimiter::Brace, body).into()
}

/// `::core::compile_error!{"message"}` at the given place.
fn compile_error(message: &str, span: Span) -> TokenStream {
    let mut literal = Literal::string(message);
    literal.set_span(span);
    let mut argument = Group::new(Delimiter::Brace, TokenTree::Literal(literal).into());
    argument.set_span(span);
    core_macro("compile_error", span).into_iter().chain([TokenTree::Group(argument)]).collect()
}

/// `::core::name!`, which no import of the user's can replace.
fn core_macro(name: &str, span: Span) -> Vec<TokenTree> {
    let mark = |mark: char, spacing| {
        let mut mark = Punct::new(mark, spacing);
        mark.set_span(span);
        TokenTree::Punct(mark)
    };
    let path =
        |name: &str| [mark(':', Spacing::Joint), mark(':', Spacing::Alone), TokenTree::Ident(Ident::new(name, span))];
    path("core").into_iter().chain(path(name)).chain([mark('!', Spacing::Alone)]).collect()
}
