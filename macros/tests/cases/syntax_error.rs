const SHADER: &str = prefilter_macros::include_wgsl!("shaders/syntax_error.wgsl");

fn main() {
    println!("{SHADER}");
}
