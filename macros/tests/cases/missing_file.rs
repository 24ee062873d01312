const SHADER: &str = prefilter_macros::include_wgsl!("shaders/absent.wgsl");

fn main() {
    println!("{SHADER}");
}
