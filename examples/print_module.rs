//! What does a module look like? Prints the text of a small scene and what is known of it. Needs no GPU.

use prefilter::{Accuracy, ColorMap, Scene};

fn main() -> Result<(), prefilter::Error> {
    let lichen = ColorMap::gradient([
        (0.00, [0.05, 0.09, 0.03]),
        (0.45, [0.21, 0.24, 0.10]),
        (0.45, [0.42, 0.40, 0.37]), // the same position twice: a hard edge
        (1.00, [0.71, 0.69, 0.66]),
    ])?;
    let module = Scene::new("lichen").texture(lichen).accuracy(Accuracy::max_filter_error(1.0 / 255.0)).module()?;
    println!("{}", module.wgsl());
    for line in module.explain().lines() {
        println!("// {line}");
    }
    Ok(())
}
