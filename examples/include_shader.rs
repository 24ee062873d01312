//! How do I use single functions of the shelf in a shader file of mine? `cargo build` links and validates it.

/// The file, and behind it the shelf functions that it mentions. A mistake in it is a compile error with its line.
const SHADER: &str = prefilter::include_wgsl!("examples/shaders/cutout.wgsl");

fn main() {
    let own = include_str!("shaders/cutout.wgsl");
    println!("{SHADER}");
    println!("// {} bytes of yours, {} from the shelf", own.len(), SHADER.len() - own.len());
}
