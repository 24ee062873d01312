const SHADER: &str = prefilter_macros::include_wgsl!("shaders/unknown_name.wgsl");

fn main() {
    println!("{SHADER}");
}
