//! What is seen of a view: the truth, brute force and what methods show.

use super::rays::{fewer, Stage};
use super::sheet::{self, Panel};
use crate::imaging::look::{Look, Quantity};
use crate::imaging::measure::root_mean_square;
use crate::imaging::picture::Picture;
use crate::imaging::region::Region;
use crate::imaging::tally::Errors;
use crate::report::Error;

/// What is seen of a view.
#[derive(Clone, Debug)]
pub struct Frame {
    /// Both halves of the truth.
    pub halves: [Vec<Look>; 2],
    /// Their mean.
    pub truth: Vec<Look>,
    /// Brute force with fewer samples, by rising numbers of them.
    pub brute: Vec<Vec<Look>>,
    /// What each method shows.
    pub shown: Vec<Vec<Look>>,
}

impl Frame {
    /// Looks at a view. `number` says what the truth draws, `brute` what brute force does.
    ///
    /// # Errors
    /// Those of the stage.
    pub fn new<S: Stage>(stage: &S, view: &S::View, strata: usize, number: u64, brute: u64) -> Result<Self, Error> {
        let half = |half: u64| stage.sampled(view, strata, 16 * number + half);
        let halves = [half(0)?, half(1)?];
        let brute = fewer(strata).zip(2..).map(|(strata, sampled)| stage.sampled(view, strata, 16 * brute + sampled));
        Ok(Self {
            truth: halves[0].iter().zip(&halves[1]).map(|(one, other)| Look::mean(&[*one, *other])).collect(),
            halves,
            brute: brute.collect::<Result<_, Error>>()?,
            shown: stage.shown(view)?,
        })
    }

    /// Whether all methods see something where there is something.
    fn is_judged(&self, pixel: usize) -> bool {
        self.truth[pixel].share != 0.0 && self.shown.iter().all(|shown| shown[pixel].share != 0.0)
    }

    /// Adds the errors of all judged pixels.
    pub fn enter(&self, all: &mut Errors) {
        let pixels: Vec<usize> = (0..self.truth.len()).filter(|&pixel| self.is_judged(pixel)).collect();
        let of = |shown: &[Look]| pixels.iter().map(|&pixel| error(&shown[pixel], &self.truth[pixel])).collect();
        let apart = pixels.iter().map(|&pixel| error(&self.halves[0][pixel], &self.halves[1][pixel]));
        let apart: Vec<f32> = apart.collect();
        // What a picture of so many samples that is independent of the truth would be off: its own variance is half of
        // the halves' difference, the truth's a quarter.
        let half = apart.iter().map(|apart| apart * 0.75f32.sqrt()).collect();
        append(&mut all.methods, self.shown.iter().map(|shown| of(shown)));
        append(&mut all.brute, self.brute.iter().map(|shown| of(shown)).chain([half]));
        all.truth.extend(apart.iter().map(|apart| 0.5 * apart));
        all.regions.extend(vec![Region::Near; pixels.len()]);
    }

    /// What a sheet shows of some pixels: of methods, by their labels, and the truth; shaded before something.
    pub fn view(&self, title: String, labels: &[String], shown: &Shown<'_>) -> sheet::View {
        let pixels = shown.light * shown.size[0] * shown.size[1]..(shown.light + 1) * shown.size[0] * shown.size[1];
        let picture = |looks: &[Look]| {
            let shade = |(look, truth): (&Look, &Look)| {
                let share = if look.share == 0.0 { 0.0 } else { truth.share };
                let color = (shown.shade)(look);
                std::array::from_fn(|at| (share * color[at] + (1.0 - share) * shown.behind[at]) as f32)
            };
            let pixels = looks[pixels.clone()].iter().zip(&self.truth[pixels.clone()]).map(shade).collect();
            Picture { width: shown.size[0], height: shown.size[1], pixels }
        };
        let errors = |looks: &[Look]| -> Vec<f32> {
            let error = |pixel| if self.is_judged(pixel) { error(&looks[pixel], &self.truth[pixel]) } else { 0.0 };
            pixels.clone().map(error).collect()
        };
        let judged = pixels.clone().filter(|&pixel| self.is_judged(pixel)).count().max(1) as f64;
        let rms = |errors: &[f32]| root_mean_square(errors) * (errors.len() as f64 / judged).sqrt();
        let panels = labels.iter().zip(&self.shown).map(|(label, looks)| {
            let errors = errors(looks);
            Panel::new(label, rms(&errors), picture(looks), errors)
        });
        let enlarged = (WIDE / shown.size[0].max(1)).max(1);
        sheet::View { title, enlarged, panels: panels.chain([Panel::truth(picture(&self.truth))]).collect() }
    }
}

/// Pixels that pictures of sheets are about as wide as.
const WIDE: usize = 180;

/// How a sheet shows a frame.
pub struct Shown<'a> {
    /// Pixels a row, and rows.
    pub size: [usize; 2],
    /// Which light.
    pub light: usize,
    /// The color that people are shown.
    pub shade: &'a dyn Fn(&Look) -> [f64; 3],
    /// What is behind.
    pub behind: [f64; 3],
}

fn append(all: &mut Vec<Vec<f32>>, more: impl Iterator<Item = Vec<f32>>) {
    for (number, errors) in more.enumerate() {
        match all.get_mut(number) {
            Some(list) => list.extend(errors),
            None => all.push(errors),
        }
    }
}

/// The error of a pixel by the share that is seen in truth; what sees nothing there is black.
fn error(shown: &Look, truth: &Look) -> f32 {
    let black = Look { lit: [0.0; 3], share: 1.0, ..*shown };
    let shown = if shown.share == 0.0 { &black } else { shown };
    Quantity::Lit.error(shown, truth).unwrap_or(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::imaging::tally::{sizes, Of};

    fn look(color: f64) -> Look {
        Look { color: [color; 3], lit: [color; 3], share: 1.0 }
    }

    /// Halves of the truth that are 0.2 apart, a method that is 0.3 off, and one pixel that nobody sees.
    #[test]
    fn errors_are_those_of_what_is_seen() {
        let nothing = Look { share: 0.0, ..look(0.0) };
        let frame = Frame {
            halves: [vec![look(0.4), nothing], vec![look(0.6), nothing]],
            truth: vec![look(0.5), nothing],
            brute: vec![vec![nothing, nothing]],
            shown: vec![vec![look(0.8), look(1.0)]],
        };
        let mut errors = Errors::default();
        frame.enter(&mut errors);
        let expected = [&errors.methods[0], &errors.brute[0], &errors.brute[1], &errors.truth];
        // What sees nothing is black. A picture like the halves has half of the variance of their difference.
        for (errors, value) in expected.into_iter().zip([0.3, 0.5, 0.2 * 0.75f32.sqrt(), 0.1]) {
            assert!(errors.len() == 1 && (errors[0] - value).abs() < 1e-6, "{errors:?} {value}");
        }
        let half = sizes(&[errors.clone(), errors], Of::Brute(1), None).rms.value;
        assert!((half - 0.2 / 2f64.sqrt()).abs() < 1e-6, "{half}");
    }
}
