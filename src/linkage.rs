//! Names under which a SPIR-V linker finds the functions of a library: naga declares the capability, but exports
//! nothing.

/// The library with a linkage attribute for every function of these names.
///
/// naga names functions by `OpName`, where it is told to keep names; the decorations stand behind all of those.
pub(crate) fn exported(mut library: Vec<u32>, names: &[&str]) -> Vec<u32> {
    let mut decorations = Vec::new();
    let mut end = HEADER;
    let mut at = HEADER;
    while let Some(&first) = library.get(at) {
        let (length, code) = ((first >> 16) as usize, first & 0xffff);
        if code == NAME {
            let words = library.get(at + 2..at + length).unwrap_or_default();
            if let (Some(&target), true) = (library.get(at + 1), names.iter().any(|name| literal(name) == words)) {
                decorations.extend([(4 + words.len() as u32) << 16 | DECORATE, target, LINKAGE_ATTRIBUTES]);
                decorations.extend_from_slice(words);
                decorations.push(EXPORT);
            }
        }
        at += length.max(1);
        if DEBUG.contains(&code) {
            end = at;
        }
    }
    library.splice(end..end, decorations);
    library
}

/// Words before the first instruction.
const HEADER: usize = 5;
const NAME: u32 = 5;
const DECORATE: u32 = 71;
const LINKAGE_ATTRIBUTES: u32 = 41;
const EXPORT: u32 = 0;
/// Instructions that stand before every decoration: sources, strings and names.
const DEBUG: [u32; 6] = [2, 3, 4, NAME, 6, 7];

/// A string as SPIR-V holds it: UTF-8, ended by a zero byte and padded with zeros to whole words.
fn literal(text: &str) -> Vec<u32> {
    let mut bytes = text.as_bytes().to_vec();
    bytes.resize(4 * (text.len() / 4 + 1), 0);
    bytes.chunks_exact(4).map(|word| u32::from_le_bytes([word[0], word[1], word[2], word[3]])).collect()
}
