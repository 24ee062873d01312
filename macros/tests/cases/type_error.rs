const SHADER: &str = prefilter_macros::include_wgsl!("shaders/type_error.wgsl");

fn main() {
    println!("{SHADER}");
}
