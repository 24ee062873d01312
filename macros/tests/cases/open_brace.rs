const SHADER: &str = prefilter_macros::include_wgsl!("shaders/open_brace.wgsl");

fn main() {
    println!("{SHADER}");
}
