//! What is looked at: rock where it is steep, snow where it is high and flat, two suns, and from where.

use super::Error;
use crate::imaging::view::{azimuth, Lens, View};
use prefilter::reference::texture::PiecewiseLinear;
use prefilter::{ColorMap, Irradiance, JointMap};

/// A light's name.
pub const LIGHTS: [&str; 2] = ["behind", "ahead"];

/// Elevation of both suns, in degrees.
const SUN: f64 = 25.0;

/// Degrees between the azimuth of a sun and the line of sight.
const ASIDE: f64 = 35.0;

/// Where cameras stand on the ground, in meters; each sees other hills.
pub const PLACES: [[f64; 2]; 4] = [[3000.0, 4000.0], [24000.0, 19000.0], [13500.0, 34000.0], [34500.0, 49000.0]];

/// Products of what depends on the height and on the steepness, of which all colors are a sum: three channels of the
/// ground by height, and one that is constant.
pub const PRODUCTS: usize = 4;

/// Colors of the ground by height, of what is flat and what is not, and of the rock on what is not.
#[derive(Clone, Debug)]
pub struct Materials {
    /// By height in meters: woods, meadows, and snow on the tops.
    pub ground: ColorMap,
    /// By steepness: 1 where the ground is bare of rock.
    pub flat: ColorMap,
    /// By steepness: the color of rock times the share of it.
    pub rock: ColorMap,
}

impl Materials {
    /// The colors.
    ///
    /// # Errors
    /// None: they are fixed.
    pub fn new() -> Result<Self, Error> {
        let rock = [0.150, 0.110, 0.082];
        Ok(Self {
            ground: ColorMap::gradient([
                (-450.0, [0.025, 0.070, 0.018]),
                (-150.0, [0.060, 0.130, 0.030]),
                (20.0, [0.190, 0.200, 0.060]),
                (100.0, [0.250, 0.210, 0.110]),
                (170.0, [0.830, 0.850, 0.890]),
                (600.0, [0.900, 0.910, 0.930]),
            ])?,
            flat: ColorMap::gradient([(0.55, [1.0; 3]), (0.75, [0.0; 3])])?,
            rock: ColorMap::gradient([(0.55, [0.0; 3]), (0.75, rock)])?,
        })
    }

    /// The colors of height and steepness together, as a sum of products.
    ///
    /// # Errors
    /// None: the colors are fixed.
    pub fn map(&self) -> Result<JointMap, Error> {
        let palette = self.palette();
        let positions = |map: &ColorMap| -> Vec<f32> { map.knots().iter().map(|knot| knot.position).collect() };
        let color =
            |height: f32, steepness: f32| palette.color(height.into(), steepness.into()).map(|part| part as f32);
        Ok(JointMap::new(positions(&self.ground), positions(&self.flat), color)?)
    }

    /// What the truth looks colors up in.
    pub fn palette(&self) -> Palette {
        Palette { ground: self.ground.reference(), flat: self.flat.reference(), rock: self.rock.reference() }
    }
}

/// The same colors in f64.
#[derive(Clone, Debug)]
pub struct Palette {
    /// By height.
    pub ground: PiecewiseLinear,
    /// By steepness.
    pub flat: PiecewiseLinear,
    /// By steepness.
    pub rock: PiecewiseLinear,
}

impl Palette {
    /// The color of a point.
    pub fn color(&self, height: f64, steepness: f64) -> [f64; 3] {
        let [ground, flat, rock] =
            [(&self.ground, height), (&self.flat, steepness), (&self.rock, steepness)].map(|(map, at)| map.value(at));
        [0, 1, 2].map(|channel| ground[channel] * flat[channel] + rock[channel])
    }
}

/// Skies with a sun behind the viewer and with one ahead.
///
/// # Errors
/// None: they are fixed.
pub fn skies() -> Result<[Irradiance; 2], Error> {
    let [behind, ahead] = [180.0 - ASIDE, ASIDE].map(f64::to_radians).map(sky);
    Ok([behind?, ahead?])
}

/// Size of the image of a sky.
const SKY: [usize; 2] = [128, 64];

/// A sky that is bluer toward the zenith, over brown ground, with a sun of 8 degrees' deviation; scaled so that level
/// ground in it reflects about half of what white does in a picture.
fn sky(left: f64) -> Result<Irradiance, Error> {
    let ([x, y], (sine, cosine)) = (azimuth(left), SUN.to_radians().sin_cos());
    let sun = [cosine * x, cosine * y, sine];
    let texel = |at: usize| {
        let polar = (at / SKY[0]) as f64 + 0.5;
        let (turn, polar) = ((at % SKY[0]) as f64 + 0.5, polar / SKY[1] as f64 * std::f64::consts::PI);
        let turn = turn / SKY[0] as f64 * std::f64::consts::TAU;
        let way = [polar.sin() * turn.cos(), polar.sin() * turn.sin(), polar.cos()];
        let toward: f64 = way.iter().zip(sun).map(|(way, sun)| way * sun).sum();
        let disc = ((toward - 1.0) / 8f64.to_radians().powi(2)).exp();
        let up = way[2].max(0.0);
        let sky = [0.36 - 0.22 * up, 0.42 - 0.18 * up, 0.52 - 0.08 * up];
        let diffuse = if way[2] > 0.0 { sky } else { [0.10, 0.09, 0.07] };
        [0, 1, 2].map(|channel| (1.2 * diffuse[channel] + [24.0, 21.0, 16.5][channel] * disc) as f32)
    };
    let texels: Vec<[f32; 3]> = (0..SKY[0] * SKY[1]).map(texel).collect();
    Ok(Irradiance::from_equirectangular(SKY[0], SKY[1], &texels)?)
}

/// What the suns are called in a view.
pub fn suns(view: &View) -> [&'static str; 2] {
    match view.lens {
        Lens::Pinhole { .. } => ["sun behind the viewer", "sun ahead"],
        Lens::Satellite { .. } => ["sun on one side", "sun on the other side"],
    }
}

/// From grazing to overhead, from near to far.
pub fn views([width, height]: [usize; 2]) -> [View; 3] {
    let pinhole =
        |degrees: [f64; 2], last| Lens::Pinhole { tangents: degrees.map(|degrees| degrees.to_radians().tan()), last };
    let view = |name, title, lens| View { name, title, lens, width, height, pan: [0.0; 2] };
    [
        view("grazing", "grazing: the ground from 1.5 to 15 degrees below the horizon", pinhole([1.5, 15.0], 60.0)),
        view("oblique", "oblique: the ground from 12 to 40 degrees below the horizon", pinhole([12.0, 40.0], 150.0)),
        view(
            "overhead",
            "from overhead, 50 times farther at the right",
            Lens::Satellite { first: 40.0, farther: 50.0 },
        ),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// As many products are enough, and no fewer.
    #[test]
    fn colors_are_a_sum_of_products() -> Result<(), Error> {
        let errors = Materials::new()?.map()?.errors().to_vec();
        println!("products leave {errors:?}");
        assert!(errors[PRODUCTS - 1] < 1e-6 && errors[PRODUCTS - 2] > 1.0 / 255.0, "{errors:?}");
        Ok(())
    }

    /// Order 2 of a sun is negative on its back; with the sky no normal gets less than nothing, so that it makes no
    /// difference that only one side of a comparison clamps there.
    #[test]
    fn skies_are_bright_all_around() -> Result<(), Error> {
        for sky in skies()? {
            let least = (0..20_000).map(|number| {
                let z = f64::from(number) / 10_000.0 - 1.0;
                let (sine, cosine) = (2.4 * f64::from(number)).sin_cos();
                let level = (1.0 - z * z).sqrt();
                sky.value([level * cosine, level * sine, z].map(|part| part as f32)).into_iter().fold(9.0, f32::min)
            });
            let least = least.fold(9.0, f32::min);
            assert!(least > 0.05, "{least}");
        }
        Ok(())
    }
}
