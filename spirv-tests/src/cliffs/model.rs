//! What the filters' model says, in f64: the light of a tap by quadrature over the heights and slopes that it sees, of
//! the very distributions that the methods are given.
//!
//! Heights and slopes of a tap are independent and normal, and those that are seen weigh by Smith's model. Color and
//! irradiance both depend on the slope: the mean of their product is not the product of their means. What a method errs
//! by against this is its own fault; what this errs by against rays is the model's.

use super::known::Known;
use super::scene::{Palette, LIGHTS};
use crate::imaging::measure::{root_mean_square, worst};
use crate::imaging::pixel::fill;
use prefilter::reference::height;
use prefilter::reference::slopes::Visible;
use prefilter::reference::smith::Along;
use prefilter::Irradiance;
use std::f64::consts::PI;

/// The light of a tap by the model.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Modeled {
    /// The mean of color times irradiance, over π, under each sky.
    pub together: [[f64; 3]; LIGHTS.len()],
    /// The mean color times the mean irradiance, over π.
    pub apart: [[f64; 3]; LIGHTS.len()],
}

/// The least deviation of slopes, and the least of its multiples that a view is from seeing the mean slope from behind,
/// that a tap is modeled for: it has no Λ below, and too little to filter.
const LEAST: f64 = 0.05;

impl Modeled {
    /// The light of a tap, where it has much to filter and the view is above the horizon of the mean slope.
    pub fn new(known: &Known, palette: &Palette, skies: &[Irradiance; LIGHTS.len()]) -> Option<Self> {
        let view = known.view.map(f64::from);
        let (covariance, mean) = (known.covariance.map(f64::from), known.slope.map(f64::from));
        let visible = Visible { view, covariance, mean };
        let wide = covariance[0].min(covariance[2]).sqrt() > LEAST && visible.parameter() > LEAST;
        wide.then(|| Self::of(known, &visible, palette, skies))
    }

    fn of(known: &Known, visible: &Visible, palette: &Palette, skies: &[Irradiance; LIGHTS.len()]) -> Self {
        let lambda = if visible.reach() > 0.0 {
            Along::new(visible.view, visible.covariance, visible.mean).lambda()
        } else {
            0.0
        };
        let ground = height::mean(&palette.ground, known.mean.into(), known.deviation.into(), lambda);
        // The color at a slope over the heights that are seen, and the light there.
        let means = visible.average(|[x, y]| {
            let (steepness, length) = (x.hypot(y), (1.0 + x * x + y * y).sqrt());
            let (flat, rock) = (palette.flat.value(steepness), palette.rock.value(steepness));
            let color: [f64; 3] = std::array::from_fn(|channel| ground[channel] * flat[channel] + rock[channel]);
            let normal = [-x / length, -y / length, 1.0 / length].map(|part| part as f32);
            let lights = skies.map(|sky| sky.value(normal).map(|light| f64::from(light) / PI));
            let mut row = [0.0; 3 + 6 * LIGHTS.len()];
            for channel in 0..3 {
                row[channel] = color[channel];
                for (light, value) in lights.iter().enumerate() {
                    row[3 + 6 * light + channel] = value[channel];
                    row[6 + 6 * light + channel] = color[channel] * value[channel];
                }
            }
            row
        });
        let of = |light: usize, channel: usize| means[3 + 6 * light + channel];
        Self {
            together: std::array::from_fn(|light| std::array::from_fn(|channel| of(light, 3 + channel))),
            apart: std::array::from_fn(|light| std::array::from_fn(|channel| means[channel] * of(light, channel))),
        }
    }
}

/// The light of every tap, where it is modeled.
pub fn all(known: &[Known], palette: &Palette, skies: &[Irradiance; LIGHTS.len()]) -> Vec<Option<Modeled>> {
    let mut models = vec![None; known.len()];
    fill(&mut models, 1, &|_, tap| Modeled::new(&known[tap], palette, skies), &|| ());
    models
}

/// The part of a tap's light by which the product of the means is off, from which on color and light count as
/// correlated.
const CORRELATED: f32 = 0.05;

/// How taps under a sky differ from their model.
#[derive(Clone, Debug, Default)]
pub struct Taps {
    /// The light, in its brightest channel.
    light: Vec<f32>,
    /// How far the product of the means is from the mean of the product, both by the model.
    apart: Vec<f32>,
    /// How far each method is from the mean of the product.
    methods: Vec<Vec<f32>>,
}

impl Taps {
    /// The differences of what methods show of taps, each in a list of its own.
    pub fn new(models: &[Option<Modeled>], light: usize, shown: &[Vec<[f32; 3]>]) -> Self {
        let mut taps = Self { methods: vec![Vec::new(); shown.len()], ..Self::default() };
        for (tap, model) in models.iter().enumerate() {
            let Some(model) = model else { continue };
            let [together, apart] = [model.together, model.apart].map(|means| means[light].map(|mean| mean as f32));
            taps.light.push(worst(&together, &[0.0; 3]));
            taps.apart.push(worst(&apart, &together));
            for (errors, shown) in taps.methods.iter_mut().zip(shown) {
                errors.push(worst(&shown[tap], &together));
            }
        }
        taps
    }

    fn correlated(&self) -> impl Iterator<Item = bool> + '_ {
        self.light.iter().zip(&self.apart).map(|(light, apart)| apart > &(CORRELATED * light))
    }
}

/// Root mean squares over taps.
#[derive(Clone, Debug, PartialEq)]
pub struct Gaps {
    /// Taps.
    pub count: usize,
    /// Their light.
    pub light: f64,
    /// What the product of the means errs by.
    pub apart: f64,
    /// What each method errs by.
    pub methods: Vec<f64>,
}

/// The root mean squares over taps from several places; all, or those whose color and light are correlated.
pub fn gaps<'a>(places: impl IntoIterator<Item = &'a Taps> + Clone, correlated: bool) -> Gaps {
    let picked = |of: &dyn Fn(&'a Taps) -> &'a [f32]| -> Vec<f32> {
        let taps = places.clone().into_iter().flat_map(|taps| of(taps).iter().zip(taps.correlated()));
        taps.filter(|(_, is)| *is || !correlated).map(|(value, _)| *value).collect()
    };
    let methods = places.clone().into_iter().next().map_or(0, |taps| taps.methods.len());
    let light = picked(&|taps| &taps.light);
    Gaps {
        count: light.len(),
        light: root_mean_square(&light),
        apart: root_mean_square(&picked(&|taps| &taps.apart)),
        methods: (0..methods).map(|method| root_mean_square(&picked(&|taps| &taps.methods[method]))).collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::super::scene::{skies, Materials};
    use super::super::Error;
    use super::*;
    use crate::random::Random;

    /// By drawing slopes, each by the area that it shows, at a height that all share.
    #[test]
    fn light_is_that_of_drawn_slopes() -> Result<(), Error> {
        let (palette, skies) = (Materials::new()?.palette(), skies()?);
        let view = [0.48, 0.64, 0.6].map(|part: f64| part as f32);
        let known = Known { mean: 300.0, deviation: 0.0, slope: [0.2, -0.1], covariance: [0.2, 0.05, 0.15], view };
        let Some(model) = Modeled::new(&known, &palette, &skies) else { panic!("not modeled") };
        let [across, lean] = [0.2f64.sqrt(), 0.05 / 0.2f64.sqrt()];
        let rest = (0.15 - lean * lean).sqrt();
        let mut random = Random::new(3);
        let (mut sums, mut areas) = ([[0.0; 3]; LIGHTS.len()], 0.0);
        for _ in 0..400_000 {
            // Box and Muller 1958.
            let (length, turn) = ((-2.0 * (1.0 - random.unit()).ln()).sqrt(), 2.0 * PI * random.unit());
            let [u, w] = [length * turn.cos(), length * turn.sin()];
            let [x, y] = [0.2 + across * u, -0.1 + lean * u + rest * w];
            let area = (0.6 - 0.48 * x - 0.64 * y).max(0.0);
            let color = palette.color(300.0, x.hypot(y));
            let normal = [-x, -y, 1.0].map(|part| (part / (1.0 + x * x + y * y).sqrt()) as f32);
            areas += area;
            for (sum, sky) in sums.iter_mut().zip(skies) {
                let light = sky.value(normal);
                (0..3).for_each(|channel| sum[channel] += area * color[channel] * f64::from(light[channel]) / PI);
            }
        }
        for (drawn, modeled) in sums.as_flattened().iter().zip(model.together.as_flattened()) {
            assert!((drawn / areas - modeled).abs() < 2e-3, "{} {modeled}", drawn / areas);
        }
        let apart = worst(&model.together[0].map(|mean| mean as f32), &model.apart[0].map(|mean| mean as f32));
        assert!(apart > 6e-3, "color and light are not correlated: {apart}");
        Ok(())
    }
}
