//! The plane of `examples/data/colormaps.json`, seen up to its horizon, with noise on it: places, footprints and truth.

use prefilter::gpu::Device;
use prefilter::{Module, Scene, Tier};
use spirv_tests::horizon::{colors, pixels, FOCAL};
use spirv_tests::maps::named;
use spirv_tests::random::Random;

use crate::{Found, Outcome};

/// Deviation of the pixel's filter.
const DEVIATION: f64 = 0.5;

/// How the plane lies under the noise.
#[derive(Clone, Copy)]
pub struct Plane {
    turn: f64,
    origin: [f64; 2],
}

impl Plane {
    pub fn new(seed: u32) -> Self {
        let mut random = Random::new(seed);
        let origin = [0, 1].map(|_| 100.0 * random.unit() - 50.0);
        Self { turn: 0.4 + f64::from(seed), origin }
    }

    fn turned(&self, [x, z]: [f64; 2]) -> [f64; 2] {
        let (sin, cos) = self.turn.sin_cos();
        [cos * x - sin * z, sin * x + cos * z]
    }

    /// Position, dpdx and dpdy of every pixel.
    pub fn points(&self) -> Vec<f32> {
        let pixel = |[px, py]: [f64; 2]| {
            let [x, z] = self.turned([px / py, FOCAL / py]);
            let [right, down] = [[1.0 / py, 0.0], [-px / (py * py), -FOCAL / (py * py)]].map(|way| self.turned(way));
            [self.origin[0] + x, self.origin[1] + z, right[0], right[1], down[0], down[1]].map(|part| part as f32)
        };
        pixels().flat_map(pixel).collect()
    }

    /// Where the pixels are in the picture, and how the plane lies.
    fn rays(&self) -> Vec<f32> {
        let (sin, cos) = self.turn.sin_cos();
        let ray = |[px, py]: [f64; 2]| [px, py, cos, sin, self.origin[0], self.origin[1]].map(|part| part as f32);
        pixels().flat_map(ray).collect()
    }
}

/// The colors of a module's `NAME_color` on the plane.
pub fn filtered(device: &Device, module: &Module, plane: &Plane) -> Result<Vec<[f64; 3]>, prefilter::Error> {
    let name = module.name();
    let text = format!(
        "fn color(p: array<f32, 6>) -> vec3f {{
    return {name}_color(vec2f(p[0], p[1]), vec2f(p[2], p[3]), vec2f(p[4], p[5]));
}}"
    );
    colors(device, module.link(&text)?.wgsl(), &plane.points())
}

/// The map at a function `truth_noise(position: vec2f) -> f32` itself, and averaged over `side`² stratified samples of
/// the pixel's filter; the text is the function's.
pub struct Truth {
    point: String,
    pixel: String,
}

impl Truth {
    pub fn new(map: &str, noise: &str, side: u32, jitter: u32) -> Found<Self> {
        let module = Scene::new("truth").texture(named(map)?).tier(Tier::Naive).module()?;
        let point = "fn color(p: array<f32, 6>) -> vec3f {
    return truth_texture(truth_noise(vec2f(p[0], p[1])), 0.0);
}";
        let pixel = format!(
            "fn color(p: array<f32, 6>) -> vec3f {{
    var sum = vec3f();
    let start = hash_pair(bitcast<vec2u>(vec2f(p[0], p[1])) + {jitter}u);
    for (var sample = 0u; sample < {side}u * {side}u; sample++) {{
        let words = hash_pair(start + sample) >> vec2u(8u);
        let unit = (vec2f(vec2u(sample % {side}u, sample / {side}u)) + (vec2f(words) + 0.5) / 16777216.0) / {side}.0;
        let radius = {DEVIATION:?} * sqrt(-2.0 * log(unit.x));
        let angle = 6.28318531 * unit.y;
        let at = vec2f(p[0], p[1]) + radius * vec2f(cos(angle), sin(angle));
        if at.y > 0.01 {{
            let ground = vec2f(at.x, {FOCAL:?}) / at.y;
            let place = vec2f(p[2] * ground.x - p[3] * ground.y, p[3] * ground.x + p[2] * ground.y);
            sum += truth_texture(truth_noise(vec2f(p[4], p[5]) + place), 0.0);
        }}
    }}
    return sum / {side}.0 / {side}.0;
}}"
        );
        let linked = |text: &str| {
            Ok::<_, Box<dyn std::error::Error + Send + Sync>>(
                module.link(&format!("{text}\n{noise}"))?.wgsl().to_owned(),
            )
        };
        Ok(Self { point: linked(point)?, pixel: linked(&pixel)? })
    }

    /// At the pixels' centers, without a filter.
    pub fn naive(&self, device: &Device, plane: &Plane) -> Result<Vec<[f64; 3]>, prefilter::Error> {
        colors(device, &self.point, &plane.points())
    }

    /// Over the pixels.
    pub fn mean(&self, device: &Device, plane: &Plane) -> Result<Vec<[f64; 3]>, prefilter::Error> {
        colors(device, &self.pixel, &plane.rays())
    }
}

#[test]
fn points_and_rays_are_of_the_same_plane() -> Outcome {
    let plane = Plane::new(3);
    for (point, ray) in plane.points().chunks_exact(6).zip(plane.rays().chunks_exact(6)) {
        let [px, py, cos, sin, x, y] = std::array::from_fn(|at| f64::from(ray[at]));
        let place = |px: f64, py: f64| [x + (cos * px - sin * FOCAL) / py, y + (sin * px + cos * FOCAL) / py];
        let step = 1e-3;
        for (axis, (right, down)) in [(point[2], point[4]), (point[3], point[5])].into_iter().enumerate() {
            assert!((place(px, py)[axis] - f64::from(point[axis])).abs() < 1e-4);
            let slope = (place(px + step, py)[axis] - place(px - step, py)[axis]) / (2.0 * step);
            assert!((slope - f64::from(right)).abs() < 1e-4 * (1.0 + slope.abs()));
            let slope = (place(px, py + step)[axis] - place(px, py - step)[axis]) / (2.0 * step);
            assert!((slope - f64::from(down)).abs() < 1e-4 * (1.0 + slope.abs()));
        }
    }
    Ok(())
}
