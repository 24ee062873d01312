//! Question 2: color by slope from the shelf's functions, a normal distribution or two of them over C0.

use prefilter::gpu::Device;
use prefilter::reference::slope::mean;
use prefilter::{Kernel, Ranges, Scene, Tier};
use spirv_tests::kernel::Function;

use crate::{maps, view, Outcome, Random};

/// Color of the mean slope, over all slopes, by one and by two normal distributions of visible slopes, a channel each.
const CHAIN: &str = "
struct colors { naive: vec3f, all: vec3f, one: vec3f, two: vec3f }
fn component(c: vec2f) -> vec3f { return map_texture(c.x, c.y); }
fn asked(view: vec3f, covariance: vec3f, mean_slope: vec2f, direction: vec2f) -> colors {
    let factor = slopes_factor(view, covariance);
    let parameter = slopes_parameter(view, mean_slope, factor);
    let m = slopes_moments(parameter);
    let p = slopes_pair(parameter);
    let low = component(slopes_along(direction, mean_slope, factor, p.x, p.y));
    let high = component(slopes_along(direction, mean_slope, factor, p.z, p.w));
    return colors(map_texture(dot(direction, mean_slope), 0.0),
        component(slopes_along(direction, mean_slope, factor, 0.0, 1.0)),
        component(slopes_along(direction, mean_slope, factor, m.x, m.y)), 0.5 * (low + high));
}";

#[test]
fn two_distributions_are_within_their_step_error_of_every_map() -> Outcome {
    let device = Device::new()?;
    let mut random = Random::new(51);
    for (map, variation) in maps()? {
        let ranges = Ranges { mean: (-8.0, 8.0), deviation: 3.0 };
        let scene = Scene::new("map").texture(map.clone()).ranges(ranges).tier(Tier::ClosedForm(Kernel::Exact));
        let module = scene.module()?;
        let declarations = prefilter_wgsl::declarations(module.wgsl());
        let texture = declarations.iter().find(|found| found.name == "map_texture").ok_or("no map_texture")?;
        let text = format!("{}{CHAIN}", texture.text);
        let views: Vec<_> = (0..1500).map(|_| view(&mut random)).collect();
        let points: Vec<Vec<f64>> = views
            .iter()
            .map(|(visible, direction)| [&visible.view[..], &visible.covariance, &visible.mean, direction].concat())
            .collect();
        let got = Function::in_text(&text, "asked")?.results(&device, &[], &points)?;
        let reference = map.reference();
        let mut worst = [0.0f64; 4];
        for ((visible, direction), got) in views.iter().zip(&got) {
            let truth = mean(&reference, visible, *direction);
            for (form, worst) in worst.iter_mut().enumerate() {
                for channel in 0..3 {
                    let error = (got[3 * form + channel] - truth[channel]).abs();
                    assert!(error.is_finite());
                    *worst = worst.max(error);
                }
            }
        }
        let [naive, all, one, two] = worst;
        println!("variation {variation:.2}: mean slope {naive:.3}, all {all:.3}, one {one:.4}, two {two:.4}");
        assert!(one <= 0.047 * variation && two <= 0.0125 * variation && two < 0.5 * one, "{worst:?}");
        assert!(naive > 4.0 * one && all > 4.0 * one, "{worst:?}");
    }
    Ok(())
}
