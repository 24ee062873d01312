const SHADER: &str = prefilter_macros::include_wgsl!("shaders/collision.wgsl");

fn main() {
    println!("{SHADER}");
}
