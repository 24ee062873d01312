//! What a combination is made of: layers, each with its share of the error, and weights.

use std::collections::BTreeMap;

use super::candidate::Over;
use super::combination::{Combination, Expression};
use super::layer::Layer;
use super::polynomial::largest_error;
use super::Scene;
use crate::filter::height::Microsurface;
use crate::transfer::color_map::MAX_COLOR;
use crate::{name, Error};

/// How many times its even part a share may be, and how often the interval is halved to find it.
const PARTS: (f64, f64) = (0.5, 4.0);
const HALVINGS: usize = 16;

/// The layers and weights of an expression, each once.
pub(super) struct Leaves<'a> {
    /// In the order of the expression.
    pub scenes: Vec<&'a Scene>,
    /// The names of the weights, likewise.
    pub weights: Vec<String>,
    /// Whether a color has four channels.
    pub four: bool,
}

impl Scene {
    /// What the expression is made of.
    ///
    /// # Errors
    /// Names that cannot be used, numbers that no color may be, two scenes of one name, no layer, no color, channels
    /// that differ.
    pub(super) fn leaves<'a>(&self, expression: &'a Expression) -> Result<Leaves<'a>, Error> {
        let (mut scenes, mut weights, mut channels): (Vec<&Scene>, Vec<String>, Vec<usize>) = Default::default();
        for leaf in expression.leaves() {
            match leaf {
                Expression::Layer(scene) | Expression::Channel(scene, _) => {
                    name::check(&format!("{}_color", scene.name))?;
                    if scenes.iter().any(|known| known.name == scene.name && *known != &**scene) {
                        let what = format!("two different layers of `{}` are called `{}`", self.name, scene.name);
                        return Err(Error::Conflict(what));
                    }
                    match leaf {
                        // Read from a file, it may be one that there is not.
                        Expression::Channel(_, channel) => drop(Combination::channel(scene, *channel)?),
                        _ => channels.extend(scene.channels()),
                    }
                    if !scenes.contains(&&**scene) {
                        scenes.push(scene);
                    }
                }
                Expression::Weight(weight) => {
                    name::check(weight)?;
                    if !weights.contains(weight) {
                        weights.push(weight.clone());
                    }
                }
                Expression::Color(color) => channels.push(color.channels()),
                // Written so that NaN is refused.
                Expression::Number(number) if !(number.abs() <= MAX_COLOR) => {
                    let what = format!("a number of the combination `{}`", self.name);
                    return Err(Error::value(what, *number, "a number from -65504 to 65504"));
                }
                Expression::Number(_) | Expression::Sum(..) | Expression::Product(..) => {}
            }
        }
        let refused = |what: String| Err(Error::Conflict(what));
        if scenes.is_empty() {
            return refused(format!("the combination of `{}` has no layer", self.name));
        }
        if channels.is_empty() && scenes.iter().all(|scene| scene.channels().is_some()) {
            return refused(format!("the combination of `{}` has weights, and no color", self.name));
        }
        if channels.windows(2).any(|pair| pair[0] != pair[1]) {
            return refused(format!(
                "the layers and colors of `{}` have {channels:?} channels; give all as many",
                self.name
            ));
        }
        Ok(Leaves { scenes, weights, four: channels.first() == Some(&4) })
    }

    /// The layers with their tiers. An accuracy of the combination is shared among those that ask for none: alike at
    /// first, and what some of them leave among those for which that is too little.
    ///
    /// # Errors
    /// As [`Self::layer`].
    pub(super) fn layers<'a>(&self, expression: &Expression, scenes: Vec<&'a Scene>) -> Result<Vec<Layer<'a>>, Error> {
        let mut errors: BTreeMap<&str, f64> = BTreeMap::new();
        let mut layers: Vec<Option<Layer<'a>>> = scenes.iter().map(|_| None).collect();
        loop {
            let open: Vec<usize> = (0..scenes.len()).filter(|&place| layers[place].is_none()).collect();
            let asking: Vec<&Scene> = open.iter().map(|&place| scenes[place]).collect();
            let shares = self.shares(expression, &asking, &errors);
            let mut refused = None;
            for (&place, share) in open.iter().zip(shares) {
                let scene = scenes[place];
                match self.layer(scene, share) {
                    Ok(layer) => {
                        // What a layer asks for itself is not shared.
                        let own = if scene.accuracy.is_none() { layer.chosen.judged.into() } else { 0.0 };
                        errors.insert(&scene.name, share.min(own));
                        layers[place] = Some(layer);
                    }
                    Err(error @ Error::Accuracy { .. }) => refused = Some(error),
                    Err(error) => return Err(error),
                }
            }
            let stuck = open.iter().all(|&place| layers[place].is_none());
            match refused {
                None => return Ok(layers.into_iter().flatten().collect()),
                Some(error) if stuck => return Err(error),
                Some(_) => {}
            }
        }
    }

    /// What each layer may err by, of what the layers with known errors leave.
    fn shares(&self, expression: &Expression, asking: &[&Scene], errors: &BTreeMap<&str, f64>) -> Vec<f64> {
        let asked = f64::from(self.accuracy.unwrap_or_default().max_filter_error);
        let whole = |own: &dyn Fn(&Scene) -> f64| {
            let of = |scene: &Scene| {
                let [low, high] = scene.hull().unwrap_or_default();
                [own(scene), low, high]
            };
            largest_error(expression, &of)
        };
        let known = |scene: &Scene| errors.get(&*scene.name).copied();
        let (least, used) = (whole(&|_| 0.0), whole(&|scene| known(scene).unwrap_or(0.0)));
        let count = asking.iter().filter(|scene| scene.accuracy.is_none()).count() as f64;
        // How many times a layer's own error the whole errs.
        let weight = |scene: &Scene| whole(&|other| f64::from(u8::from(other.name == scene.name))) - least;
        let weights: BTreeMap<&str, f64> = asking.iter().map(|scene| (&*scene.name, weight(scene).max(1e-3))).collect();
        let share = |scene: &Scene, part: f64| {
            let weight = weights.get(&*scene.name).copied().unwrap_or(1.0);
            part * (asked - used).max(0.0) / (count * weight)
        };
        // Errors of factors are multiplied, too, colors are rounded, and layers of a mixture do not err at once.
        let free = |scene: &Scene, part| if scene.accuracy.is_none() { share(scene, part) } else { 0.0 };
        let kept = |part: f64| whole(&|scene| known(scene).unwrap_or_else(|| free(scene, part))) <= asked;
        let (mut part, mut above) = PARTS;
        for _ in 0..HALVINGS {
            let middle = 0.5 * (part + above);
            *(if kept(middle) { &mut part } else { &mut above }) = middle;
        }
        // An accuracy is a positive number.
        asking.iter().map(|scene| share(scene, part).clamp(1e-30, 1e30)).collect()
    }

    /// Whether a surface hides what the layers color.
    ///
    /// # Errors
    /// A microsurface that none of them has, noise on heights that none has.
    pub(super) fn hides(&self, layers: &[Layer<'_>]) -> Result<(), Error> {
        let refused = |what: &str| Err(Error::Conflict(format!("the combination `{}` has {what}", self.name)));
        if self.microsurface != Microsurface::default() && !layers.iter().any(Layer::hidden) {
            return refused("a `microsurface`, which hides heights and slopes, and layers of neither");
        }
        let heights = |layer: &Layer<'_>| matches!(layer.chosen.over, Over::Heights(_));
        if self.microsurface.perturbed && !layers.iter().any(heights) {
            return refused("noise on the heights, and no layer of them");
        }
        Ok(())
    }
}
