use prefilter_macros::include_wgsl;

const EMPTY: &str = include_wgsl!();
const NUMBER: &str = include_wgsl!(12);
const BYTES: &str = include_wgsl!(b"shaders/terrain.wgsl");
const TWO: &str = include_wgsl!("shaders/terrain.wgsl", "shaders/terrain.wgsl");
const CALL: &str = include_wgsl!(concat!("shaders/", "terrain.wgsl"));

fn main() {}
