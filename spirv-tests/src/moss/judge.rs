//! Every method on every view of both surfaces against the truth, over several fields of noise.

use super::known::Known;
use super::method::Method;
use super::scene;
use super::studio::{Seen, Studio};
use super::zoom::{self, Zoomed};
use super::Error;
use crate::imaging::camera::View;
use crate::imaging::look::{Look, Quantity};
use crate::imaging::region::Region;
use crate::imaging::tally::{sizes, Errors, Of, Sizes};
use prefilter::gpu::Device;

/// The share of the variance of f from which a pixel that loses it is far.
const FAR: f64 = 0.99;

/// The sine of the elevation of the eye below which a tap is at the silhouette: 15 degrees.
const RIM: f64 = 0.259;

/// How much is done.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Extent {
    /// Width and height of the pictures.
    pub size: [usize; 2],
    /// Strata an axis of each of the two halves of the truth, view by view.
    pub strata: [usize; 3],
    /// Fields of noise.
    pub seeds: usize,
    /// The zoom.
    pub zoom: zoom::Extent,
}

impl Extent {
    /// Rays that [`judge`] shoots, for a progress bar.
    pub fn rays(self) -> u64 {
        let views = scene::views(self.size, self.strata);
        2 * (self.seeds as u64 * views.iter().map(rays).sum::<u64>() + self.zoom.frames().iter().map(rays).sum::<u64>())
    }
}

/// Rays of both halves of the truth of a view.
fn rays(view: &View) -> u64 {
    (2 * view.width * view.height * view.strata * view.strata) as u64
}

/// Pixels that figures are of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// All.
    All,
    /// Those that resolve as much.
    Of(Region),
    /// Those that see some of the log at less than 15 degrees.
    Silhouette,
}

impl Part {
    /// All of them.
    pub const ALL: [Self; 5] =
        [Self::All, Self::Of(Region::Near), Self::Of(Region::Between), Self::Of(Region::Far), Self::Silhouette];

    /// The name in tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::All => "all",
            Self::Of(region) => region.name(),
            Self::Silhouette => "silhouette",
        }
    }
}

/// What is known of a view of a surface.
#[derive(Clone, Debug)]
pub struct Row {
    /// The surface.
    pub material: &'static str,
    /// The view.
    pub view: View,
    /// The true picture of the first noise.
    pub truth: Vec<Look>,
    /// What each method shows of it, in the order of [`Method::ALL`].
    pub shown: Vec<Vec<Look>>,
    /// Errors of all pixels and of those at the silhouette, by quantity; noise by noise.
    errors: [[Vec<Errors>; 2]; 2],
}

impl Row {
    fn new(material: &'static str, view: View) -> Self {
        Self { material, view, truth: Vec::new(), shown: Vec::new(), errors: Default::default() }
    }

    /// Sizes of the errors of a method or of the truth, the truth's variance taken off a method's.
    pub fn sizes(&self, of: Of, quantity: Quantity, part: Part) -> Sizes {
        let errors = &self.errors[usize::from(part == Part::Silhouette)][quantity as usize];
        let region = if let Part::Of(region) = part { Some(region) } else { None };
        sizes(errors, of, region)
    }

    /// How many pixels there are of a part, over all noise.
    pub fn pixels(&self, part: Part) -> usize {
        let errors = &self.errors[usize::from(part == Part::Silhouette)][0];
        let regions = errors.iter().flat_map(|errors| &errors.regions);
        regions.filter(|&&region| !matches!(part, Part::Of(of) if of != region)).count()
    }

    /// Root mean square error of a method.
    pub fn rms(&self, method: Method, quantity: Quantity, part: Part) -> f64 {
        self.sizes(Of::Method(method as usize), quantity, part).rms.value
    }

    /// Adds the errors of a picture.
    fn enter(&mut self, seen: &Seen) {
        for (quantity, part) in Quantity::ALL.into_iter().flat_map(|quantity| [0, 1].map(|part| (quantity, part))) {
            let mut entered = Errors { methods: vec![Vec::new(); seen.shown.len()], ..Errors::default() };
            for (pixel, known) in seen.known.iter().enumerate().filter(|(_, known)| part == 0 || is_rim(*known)) {
                let methods = seen.shown.iter().map(|shown| quantity.error(&shown[pixel], &seen.truth[pixel]));
                let apart = quantity.error(&seen.halves[0][pixel], &seen.halves[1][pixel]);
                if let (Some(methods), Some(apart)) = (methods.collect::<Option<Vec<_>>>(), apart) {
                    entered.regions.push(region(known));
                    entered.methods.iter_mut().zip(methods).for_each(|(all, error)| all.push(error));
                    // The mean of two has half the deviation of their difference.
                    entered.truth.push(0.5 * apart);
                }
            }
            self.errors[part][quantity as usize].push(entered);
        }
    }
}

fn is_rim(known: &[Option<Known>]) -> bool {
    known.iter().any(|tap| tap.is_none_or(|tap| tap.view[2] < RIM))
}

/// What a pixel resolves, by the variance of f.
fn region(known: &[Option<Known>]) -> Region {
    let taps: Vec<f64> = known.iter().flatten().map(|tap| tap.deviation.powi(2)).collect();
    Region::of(taps.iter().sum::<f64>() / taps.len() as f64, FAR)
}

/// Everything that is known.
#[derive(Clone, Debug)]
pub struct Judged {
    /// The views of both surfaces.
    pub rows: Vec<Row>,
    /// The zoom on each surface.
    pub zooms: Vec<Zoomed>,
}

/// Judges every method. `done` is told how many rays have been shot, from several threads.
///
/// # Errors
/// Those of scenes and of the device.
pub fn judge(device: &Device, extent: Extent, done: &(dyn Fn(u64) + Sync)) -> Result<Judged, Error> {
    let mut judged = Judged { rows: Vec::new(), zooms: Vec::new() };
    for material in scene::materials()? {
        let studio = Studio::new(device, material, &Method::ALL)?;
        let mut rows = scene::views(extent.size, extent.strata).map(|view| Row::new(studio.material.name, view));
        for seed in 0..extent.seeds {
            let noise = studio.noise(seed as u32 + 1);
            for (number, row) in rows.iter_mut().enumerate() {
                let seen = noise.look(&row.view, (seed * 3 + number) as u64, done)?;
                row.enter(&seen);
                if seed == 0 {
                    (row.truth, row.shown) = (seen.truth, seen.shown);
                }
            }
            if seed == 0 {
                judged.zooms.push(zoom::zoom(&noise, extent.zoom, done)?);
            }
        }
        judged.rows.extend(rows);
    }
    Ok(judged)
}
