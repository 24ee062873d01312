//! The contact sheet: what each method shows of an input, its errors below, and the truth.

use super::input::{Ground, Input};
use super::judge::{error, is_judged};
use super::lens::Lens;
use super::method::{Method, Renderer};
use super::truth::{Look, Sampler};
use super::Error;
use crate::imaging::canvas::{Canvas, Letters};
use crate::imaging::measure::root_mean_square;
use crate::imaging::picture::Picture;
use crate::report::cache::Cache;
use prefilter::driver::taps::Taps;
use prefilter::gpu::Device;

/// Those that the sheet shows, in two rows with the truth at the end.
const SHOWN: [Method; 9] = [
    Method::Naive,
    Method::Mean,
    Method::Fading,
    Method::Clamping,
    Method::Hart,
    Method::Paper,
    Method::Ours(Taps::One),
    Method::Ours(Taps::Eight),
    Method::Stratified(4),
];

/// Pictures a row.
const COLUMNS: usize = 5;

/// The error that error maps show brightest.
const BRIGHTEST: f32 = 0.25;

const PAPER: [u8; 3] = [255; 3];
const INK: [u8; 3] = [30, 34, 40];
const SKY: [[u8; 3]; 2] = [[126, 160, 204], [226, 232, 236]];
/// Behind blocks, above and below, in linear light.
const BEHIND: [[f32; 3]; 2] = [[0.62, 0.64, 0.66], [0.30, 0.29, 0.28]];

/// Rows of sky above a plane.
const SKY_ROWS: usize = 10;
const MARGIN: usize = 10;
const GAP: usize = 6;
/// Height of a line of text.
const LINE: usize = 18;

/// Strata an axis of the truth that is shown.
const TRUTH: usize = 32;

/// An input as it is shown.
#[derive(Clone, Debug)]
pub struct Shown {
    input: Input,
    lens: Lens,
    truth: Vec<Look>,
    /// In the order of [`SHOWN`].
    methods: Vec<Vec<Look>>,
}

impl Shown {
    /// What methods show of an input in a picture of so many pixels.
    ///
    /// # Errors
    /// Those of scenes and of the device.
    pub fn new(
        device: &Device,
        input: &Input,
        size: [usize; 2],
        cache: &Cache,
        done: &dyn Fn(u64),
    ) -> Result<Self, Error> {
        let (sampler, lens) = (Sampler::new(device, input, cache)?, input.lens(size));
        let methods = SHOWN.iter().map(|&method| Renderer::new(device, &sampler, method)?.picture(&lens, 1));
        let methods = methods.collect::<Result<_, _>>()?;
        let truth = sampler.picture(&lens, 1, TRUTH, 0, done)?;
        Ok(Self { input: input.clone(), lens, truth, methods })
    }

    /// Samples that it takes, for a progress bar.
    pub fn samples([width, height]: [usize; 2]) -> u64 {
        (width * height * TRUTH * TRUTH) as u64
    }

    /// What is shown: a method and its pixels, and the truth's at the end.
    pub fn looks(&self) -> impl Iterator<Item = (Option<Method>, &[Look])> + '_ {
        let methods = SHOWN.into_iter().map(Some).zip(self.methods.iter().map(Vec::as_slice));
        methods.chain([(None, self.truth.as_slice())])
    }

    /// What people are shown of colors: in the truth's light, before something.
    pub fn picture(&self, looks: &[Look]) -> Picture {
        let (Lens { width, height, .. }, naive) = (self.lens, &self.methods[0]);
        let pixel = |(number, (look, truth)): (usize, (&Look, &Look))| {
            let along = (number / width) as f32 / height as f32;
            // What methods see nothing of, and their errors leave out, is the truth's.
            let color = if is_judged(&naive[number], truth) { look.color } else { truth.color };
            std::array::from_fn(|channel| {
                let behind = BEHIND[0][channel] + along * (BEHIND[1][channel] - BEHIND[0][channel]);
                truth.share * truth.light * color[channel] + (1.0 - truth.share) * behind
            })
        };
        Picture { width, height, pixels: looks.iter().zip(&self.truth).enumerate().map(pixel).collect() }
    }

    /// The errors of all pixels: none where there is no color to judge.
    pub fn errors(&self, looks: &[Look]) -> Vec<f32> {
        let naive = &self.methods[0];
        let pixels = looks.iter().zip(&self.truth).zip(naive);
        pixels.map(|((look, truth), naive)| if is_judged(naive, truth) { error(look, truth) } else { 0.0 }).collect()
    }

    /// Root mean square of the judged errors.
    pub fn rms(&self, looks: &[Look]) -> f64 {
        let judged = self.methods[0].iter().zip(&self.truth).map(|(naive, truth)| is_judged(naive, truth));
        let errors = self.errors(looks).into_iter().zip(judged).filter(|pixel| pixel.1).map(|pixel| pixel.0);
        root_mean_square(&errors.collect::<Vec<_>>())
    }

    /// Height of a row of pictures with their errors and letters.
    fn row(&self) -> usize {
        LINE + self.sky() + 2 * self.lens.height + 2 * GAP
    }

    fn sky(&self) -> usize {
        if self.input.ground == Ground::Plane {
            SKY_ROWS
        } else {
            0
        }
    }
}

/// The sheet of inputs whose pictures are of one width.
pub fn sheet(all: &[Shown]) -> Canvas {
    let width = all.first().map_or(0, |shown| shown.lens.width);
    let height: usize = all.iter().map(|shown| LINE + 2 * shown.row() + GAP).sum();
    let mut canvas = Canvas::new(2 * MARGIN + COLUMNS * (width + GAP) - GAP, 2 * MARGIN + height - GAP, PAPER);
    let mut top = MARGIN;
    for shown in all {
        canvas.text(shown.input.title, [MARGIN, top], Letters::Bold, INK);
        top += LINE;
        for number in 0..=SHOWN.len() {
            let place = [MARGIN + number % COLUMNS * (width + GAP), top + number / COLUMNS * shown.row()];
            draw(&mut canvas, shown, number, place);
        }
        top += 2 * shown.row() + GAP;
    }
    canvas
}

/// A method's picture above its errors, or the truth.
fn draw(canvas: &mut Canvas, shown: &Shown, number: usize, [left, top]: [usize; 2]) {
    let (Lens { width, height, .. }, sky) = (shown.lens, shown.sky());
    let looks = shown.methods.get(number).unwrap_or(&shown.truth);
    canvas.shade([left, top + LINE], [width, sky], SKY[0], SKY[1]);
    canvas.picture(&shown.picture(looks), [left, top + LINE + sky]);
    let below = top + LINE + sky + height + GAP / 2;
    let label = match SHOWN.get(number) {
        Some(method) => {
            canvas.errors(&shown.errors(looks), width, BRIGHTEST, [left, below]);
            format!("{}: RMS {:.3}", method.label(), shown.rms(looks))
        }
        None => {
            legend(canvas, [left, below + GAP], width);
            format!("truth, {TRUTH} x {TRUTH} samples")
        }
    };
    canvas.text(&label, [left, top + 3], Letters::Small, INK);
}

/// What the colors of the error maps mean.
fn legend(canvas: &mut Canvas, [left, top]: [usize; 2], width: usize) {
    canvas.text("error, worst channel, linear", [left, top], Letters::Small, INK);
    canvas.error_scale([left, top + 16], [width, 10]);
    canvas.text("0", [left, top + 29], Letters::Small, INK);
    let most = format!("{BRIGHTEST} and more");
    canvas.text(&most, [left + width - Letters::Small.width(&most), top + 29], Letters::Small, INK);
}
