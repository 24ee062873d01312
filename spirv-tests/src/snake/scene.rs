//! What is looked at: the material, the light, the views.

use crate::imaging::camera::View;
use prefilter::{ColorMap, Combination, Error, Irradiance, Scene};

/// Along which the slopes are looked at that turn red, in the frame of the surface: to the head and to one side.
pub const DIRECTION: [f64; 2] = [0.8, 0.6];

/// Reds by the slope, with premultiplied alpha.
const REDS: [(f32, [f32; 4]); 3] =
    [(0.06, [0.0, 0.0, 0.0, 0.0]), (0.18, [0.62, 0.05, 0.015, 0.92]), (0.60, [0.85, 0.16, 0.020, 1.0])];

/// How the skin is colored and lit.
#[derive(Clone, Debug)]
pub struct Material {
    /// Greens by the pattern's value.
    pub green: ColorMap,
    /// Reds by the slope along [`DIRECTION`], with premultiplied alpha.
    pub red: ColorMap,
    /// Light from all around.
    pub light: Irradiance,
}

impl Material {
    /// The material.
    ///
    /// # Errors
    /// None: its parts are fixed.
    pub fn new() -> Result<Self, Error> {
        let green = ColorMap::gradient([
            (0.05, [0.010, 0.030, 0.012]),
            (0.36, [0.022, 0.085, 0.020]),
            (0.36, [0.075, 0.220, 0.028]),
            (0.64, [0.200, 0.400, 0.050]),
            (0.64, [0.560, 0.660, 0.120]),
            (0.95, [0.780, 0.800, 0.300]),
        ])?;
        let red = ColorMap::gradient(REDS)?;
        Ok(Self { green, red, light: light()? })
    }

    /// The material as a combination of layers: greens where a scale is bare, and reds.
    ///
    /// # Errors
    /// As [`Self::new`].
    pub fn layers(&self, skin: &Scene, slopes: impl Fn(Scene) -> Scene) -> Result<Combination, Error> {
        let layer = |name, of: &dyn Fn([f32; 4]) -> [f32; 3]| {
            let map = ColorMap::gradient(REDS.map(|(slope, color)| (slope, of(color))))?;
            Ok::<Scene, Error>(slopes(Scene::new(name).slope(map)))
        };
        let bare = layer("bare", &|[.., alpha]| [1.0 - alpha; 3])?;
        let red = layer("red", &|[red, green, blue, _]| [red, green, blue])?;
        Ok(skin * &bare + &red)
    }
}

/// A sun behind thin clouds to the left, blue sky, and warm ground.
fn light() -> Result<Irradiance, Error> {
    const SIZE: [usize; 2] = [64, 32];
    let sun = [-0.55, -0.45, 0.70];
    let radiance = |texel: usize| {
        let [azimuth, polar] = [
            std::f32::consts::TAU * ((texel % SIZE[0]) as f32 + 0.5) / SIZE[0] as f32,
            std::f32::consts::PI * ((texel / SIZE[0]) as f32 + 0.5) / SIZE[1] as f32,
        ];
        let way = [polar.sin() * azimuth.cos(), polar.sin() * azimuth.sin(), polar.cos()];
        if way[2] < 0.0 {
            return [0.26, 0.20, 0.13];
        }
        let cosine = way.iter().zip(sun).map(|(a, b)| a * b).sum::<f32>().max(0.0);
        let glow = 5.0 * cosine.powi(24) + 1.2 * cosine.powi(4);
        [0.36 + glow, 0.46 + 0.93 * glow, 0.66 + 0.80 * glow]
    };
    let texels: Vec<[f32; 3]> = (0..SIZE[0] * SIZE[1]).map(radiance).collect();
    Irradiance::from_equirectangular(SIZE[0], SIZE[1], &texels)
}

/// Level of the heights that methods see displaced in each view: texels as wide as pixels about.
pub const LEVELS: [usize; 3] = [0, 2, 4];

/// Scales, the whole snake, and the snake far away: of a size, with strata an axis of each half of the truth.
pub fn views([width, height]: [usize; 2], strata: [usize; 3]) -> [View; 3] {
    let whole = [0.3, -1.2, 0.6];
    let eye = |far: f64| [whole[0] + 0.10 * far, whole[1] - 0.76 * far, whole[2] + 0.64 * far];
    let size = width as f64;
    let view = |name, title, far: f64, focal: f64, enlarged: usize, strata: usize| View {
        name,
        title,
        eye: eye(far),
        target: whole,
        focal: focal * size / enlarged as f64,
        width: width / enlarged,
        height: height / enlarged,
        enlarged,
        strata,
        pan: [0.0; 2],
    };
    let near = View { target: [0.75, -5.7, 2.2], ..view("near", "near: scales", 34.0, 5.2, 1, strata[0]) };
    [
        near,
        view("whole", "the whole snake", 34.0, 2.3, 1, strata[1]),
        view("far", "far away, 6 times enlarged", 34.0 * 6.0, 6.0 * 2.3, 6, strata[2]),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pictures_are_shown_in_one_size() {
        for view in views([60, 42], [1; 3]) {
            assert_eq!((view.width * view.enlarged, view.height * view.enlarged), (60, 42), "{}", view.name);
        }
    }
}
