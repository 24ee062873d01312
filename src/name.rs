//! Names that a scene puts into shaders.

use crate::reserved;
use crate::Error;

/// Checks that a name can prefix exports in every shading language: an identifier that none of them reserves.
pub(crate) fn check(name: &str) -> Result<(), Error> {
    let refused = |reason: String| Err(Error::Name { name: name.to_owned(), reason });
    let letters = |byte: u8| byte.is_ascii_alphanumeric() || byte == b'_';
    match name.as_bytes() {
        [] => return refused("is empty".into()),
        bytes if bytes.len() > MAX_LENGTH => return refused(format!("has more than {MAX_LENGTH} letters")),
        [first, ..] if !first.is_ascii_alphabetic() => return refused("does not begin with a letter".into()),
        bytes if !bytes.iter().all(|&byte| letters(byte)) => return refused("holds a character not allowed".into()),
        [.., last] if last.is_ascii_digit() => return refused("ends in a digit, which naga would number on".into()),
        [.., b'_'] => return refused("ends in an underscore".into()),
        _ if name.contains("__") => return refused("holds a double underscore, reserved in GLSL".into()),
        _ if GLSL_PREFIXES.iter().any(|prefix| name.split('_').next() == Some(prefix)) => {
            return refused("begins exports as names reserved in GLSL begin".into())
        }
        _ => {}
    }
    if let Some(language) = reserved::language(name) {
        return refused(format!("is reserved in {language}"));
    }
    Ok(())
}

/// GLSL promises identifiers of up to 1024 characters; nobody needs the tenth of it.
const MAX_LENGTH: usize = 100;

/// First parts of names that GLSL and WebGL keep for themselves.
const GLSL_PREFIXES: [&str; 2] = ["gl", "webgl"];
