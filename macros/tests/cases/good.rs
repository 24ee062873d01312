use prefilter_macros::include_wgsl;

const SHADER: &str = include_wgsl!("shaders/terrain.wgsl");
const RAW: &str = include_wgsl!(r#"shaders/terrain.wgsl"#,);

macro_rules! through_a_macro {
    ($path:literal) => {
        include_wgsl!($path)
    };
}

fn main() {
    let file = include_str!("../shaders/terrain.wgsl");
    let shelf = SHADER.strip_prefix(file).expect("the file comes first, byte for byte");
    assert!(shelf.contains("fn texture_step(") && shelf.contains("fn normal_cdf("));
    assert!(!shelf.contains("fn normal_excess("));
    assert_eq!(SHADER, RAW);
    assert_eq!(SHADER, through_a_macro!("shaders/terrain.wgsl"));
}
